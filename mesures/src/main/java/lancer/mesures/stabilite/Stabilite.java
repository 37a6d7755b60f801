package lancer.mesures.stabilite;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/**
 * Où les méthodes échouent : un fichier de mesures, et les planches qu'on en dessine. Aucun temps n'y entre : le fichier ne dépend que
 * du programme. Ce que les méthodes coûtent est dans {@link Methodes}.
 */
public final class Stabilite {

    public static final String CSV = "stabilite.csv";

    private Stabilite() {
    }

    /**
     * Mesure, et écrit {@link #CSV} dans ce dossier.
     *
     * @param rapide vrai pour dix fois moins de rayons, à une abscisse sur deux
     */
    public static void mesurer(Path dossier, boolean rapide) throws IOException {
        Exactitude.ecrire(dossier.resolve(CSV), Exactitude.STABILITE, new Mesures(rapide).toutes(), "");
    }

    private static Bilan lire(Path dossier) throws IOException {
        return new Bilan(Exactitude.lire(dossier.resolve(CSV), Exactitude.STABILITE));
    }

    /** Dessine les mesures de ce dossier. */
    public static void dessiner(Path dossier) throws IOException {
        Figures figures = new Figures(lire(dossier));
        figures.loin().ecrire(dossier.resolve("stabilite-loin.png"));
        figures.ras().ecrire(dossier.resolve("stabilite-ras.png"));
        figures.sol().ecrire(dossier.resolve("stabilite-sol.png"));
        figures.defauts().ecrire(dossier.resolve("stabilite-defauts.png"));
        figures.petites().ecrire(dossier.resolve("stabilite-petites.png"));
        figures.reflets().ecrire(dossier.resolve("stabilite-reflets.png"));
        if (Files.exists(dossier.resolve(Methodes.CSV))) {
            new Methodes(dossier).planche().ecrire(dossier.resolve("methodes.png"));
        }
    }

    /** Les nombres que montrent les pages, par leurs noms. */
    public static Map<String, String> pages(Path dossier) throws IOException {
        Map<String, String> valeurs = lire(dossier).nombres();
        if (Files.exists(dossier.resolve(Methodes.CSV))) {
            valeurs.putAll(new Methodes(dossier).pages());
        }
        return valeurs;
    }
}
