package lancer.mesures.stabilite;

import java.io.IOException;
import java.nio.file.Path;

/**
 * Où les méthodes échouent : un fichier de mesures, et les planches qu'on en dessine. Aucun temps n'y entre : le fichier ne dépend que
 * du programme.
 */
public final class Stabilite {

    public static final String CSV = "stabilite.csv";

    /** Ce que promet le programme, en unités de l'erreur inévitable, κ u t. */
    public static final double PROMESSE = 8;

    private Stabilite() {
    }

    /**
     * Mesure, et écrit {@link #CSV} dans ce dossier.
     *
     * @param rapide vrai pour dix fois moins de rayons, à une abscisse sur deux
     */
    public static void mesurer(Path dossier, boolean rapide) throws IOException {
        Exactitude.ecrire(dossier.resolve(CSV), new Mesures(rapide).toutes());
    }

    /** Ce que disent les mesures de ce dossier. */
    public static Bilan lire(Path dossier) throws IOException {
        return new Bilan(Exactitude.lire(dossier.resolve(CSV)));
    }

    /** Dessine les mesures de ce dossier. */
    public static void dessiner(Path dossier) throws IOException {
        Figures figures = new Figures(lire(dossier));
        figures.loin().ecrire(dossier.resolve("stabilite-loin.png"));
        figures.ras().ecrire(dossier.resolve("stabilite-ras.png"));
        figures.sol().ecrire(dossier.resolve("stabilite-sol.png"));
        figures.petites().ecrire(dossier.resolve("stabilite-petites.png"));
        figures.reflets().ecrire(dossier.resolve("stabilite-reflets.png"));
    }
}
