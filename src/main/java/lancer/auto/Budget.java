package lancer.auto;

/**
 * Ce que les essais ont le droit de coûter, en rayons : au plus la moitié du dessin qu'ils choisissent, ou d'un temps
 * voulu. Pour une erreur voulue, rien n'y dépend de la machine, ni de cette erreur.
 */
final class Budget {

    /** Ce que coûtent au plus les essais d'un petit dessin : moins de 0,2 s, même si rien n'est encore compilé. */
    private static final double PLANCHER = 500_000;

    /** Part du dessin que coûtent les autres : un rayon d'essai coûte un peu plus que celui d'une image. */
    private static final double PART = 0.4;

    /** Part des essais qui va au choix ; le reste va au contrôle. */
    private static final double PART_DU_CHOIX = 0.7;

    private static final double PRUDENCE = 1.2;
    private static final double NS_PAR_S = 1e9;

    private final Souhait souhait;
    private final Essais essais;
    private final long debut = System.nanoTime();

    Budget(Souhait souhait, Essais essais) {
        this.souhait = souhait;
        this.essais = essais;
    }

    /** Secondes depuis le début. */
    double ecoule() {
        return (System.nanoTime() - debut) / NS_PAR_S;
    }

    /** @return ce qui reste pour choisir, si le dessin est à ce prix par pixel */
    double pourChoisir(double prix) {
        return PART_DU_CHOIX * total(prix) - depense();
    }

    /** @return ce qui reste pour contrôler ce dessin */
    double pourControler(double prix) {
        return total(prix) - depense();
    }

    private double total(double prix) {
        return souhait.temps > 0 ? Math.min(souhait.temps / 2, souhait.temps - dessin(prix)) / essais.parRayon()
                : Math.max(PLANCHER, PART * prix * essais.pixels());
    }

    private double depense() {
        return souhait.temps > 0 ? ecoule() / essais.parRayon() : essais.rayons();
    }

    /** Le temps qu'il faudrait pour dessiner à ce prix par pixel, en secondes : une machine n'est jamais seule. */
    double dessin(double prix) {
        return PRUDENCE * prix * essais.pixels() * essais.parRayon();
    }
}
