package lancer;

/** La brume : rien à l'œil, tout à trente unités. */
class Brume {

    static final Couleur COULEUR = new Couleur(0.8, 0.8, 0.8);

    static Couleur voiler(Couleur vue, double distance) {
        double k = Math.min(1, Math.max(0, distance / 30));
        return COULEUR.mul(k).add(vue.mul(1 - k));
    }
}
