package lancer.mesures.vitesse;

import java.nio.file.Path;
import java.nio.file.Paths;

/** Ce qui est demandé à {@link Vitesse}. */
final class OptionsVitesse {

    static final String USAGE = "usage : Vitesse [--rapide] [--dessiner | --stabilite] [--dossier DOSSIER]";

    /** Où finit une mesure complète, avec ses courbes. */
    private static final String RESULTATS = "mesures/resultats";

    /** Où se fait toute mesure ; une mesure rapide y reste. */
    private static final String ATELIER = "mesures/target/vitesse";
    private static final String ATELIER_RAPIDE = "mesures/target/vitesse-rapide";

    /** Vrai pour une partie des mesures, en moins d'une minute. */
    final boolean rapide;

    /** Vrai pour redessiner les courbes des mesures déjà faites, sans mesurer. */
    final boolean dessiner;

    /** Vrai pour ne mesurer que la stabilité, puis tout redessiner. */
    final boolean stabilite;

    /** Où mesurer : chaque mesure y est notée dès qu'elle est finie. */
    final Path atelier;

    /** Où porter le tout à la fin ; l'atelier lui-même pour une mesure rapide. */
    final Path resultats;

    private OptionsVitesse(boolean rapide, boolean dessiner, boolean stabilite, String dossier) {
        this.rapide = rapide;
        this.dessiner = dessiner;
        this.stabilite = stabilite;
        atelier = Paths.get(dossier == null ? rapide ? ATELIER_RAPIDE : ATELIER : dossier);
        resultats = dossier == null && !rapide ? Paths.get(RESULTATS) : atelier;
    }

    /** @throws IllegalArgumentException si un argument ne va pas, avec un message d'une ligne */
    static OptionsVitesse lire(String... args) {
        boolean rapide = false;
        boolean dessiner = false;
        boolean stabilite = false;
        String dossier = null;
        for (int k = 0; k < args.length; k++) {
            switch (args[k]) {
                case "--rapide":
                    rapide = true;
                    break;
                case "--dessiner":
                    dessiner = true;
                    break;
                case "--stabilite":
                    stabilite = true;
                    break;
                case "--dossier":
                    if (++k == args.length || args[k].isEmpty()) {
                        throw new IllegalArgumentException("option sans sa valeur : --dossier ; " + USAGE);
                    }
                    dossier = args[k];
                    break;
                default:
                    throw new IllegalArgumentException("option inconnue : « " + args[k] + " » ; " + USAGE);
            }
        }
        return new OptionsVitesse(rapide, dessiner, stabilite, dossier);
    }

    /** Vrai si les pages du projet (README, docs) montrent ces résultats-là. */
    boolean montres() {
        return resultats.equals(Paths.get(RESULTATS));
    }
}
