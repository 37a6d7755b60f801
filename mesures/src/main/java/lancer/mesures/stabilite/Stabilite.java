package lancer.mesures.stabilite;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import lancer.mesures.trace.Planche;

/**
 * Où les méthodes échouent : un fichier de mesures, et les cinq planches qu'on en dessine. Aucun temps n'y entre : le fichier ne
 * dépend que du programme.
 */
public final class Stabilite {

    public static final String CSV = "stabilite.csv";

    /** Les planches, dans l'ordre où la page les lit. */
    public static final String[] PLANCHES = {"stabilite-loin", "stabilite-ras", "stabilite-sol", "stabilite-carte", "stabilite-defauts"};

    private Stabilite() {
    }

    /**
     * Mesure, et écrit {@link #CSV} dans ce dossier.
     *
     * @param rapide vrai pour dix fois moins de rayons, à une abscisse sur deux
     */
    public static void mesurer(Path dossier, boolean rapide) throws IOException {
        List<Exactitude> tous = new ArrayList<>(new Mesures(rapide).intersections());
        tous.addAll(new Defauts().compter());
        Exactitude.ecrire(dossier.resolve(CSV), tous);
    }

    /** Dessine les mesures de ce dossier. */
    public static void dessiner(Path dossier) throws IOException {
        Figures figures = new Figures(new Bilan(Exactitude.lire(dossier.resolve(CSV))));
        Planche[] planches = {figures.loin(), figures.ras(), figures.sol(), figures.carte(), figures.defauts()};
        for (int k = 0; k < planches.length; k++) {
            planches[k].ecrire(dossier.resolve(PLANCHES[k] + ".png"));
        }
    }

    /** Les nombres que montrent les pages, par leurs noms. */
    public static Map<String, String> pages(Path dossier) throws IOException {
        return new Bilan(Exactitude.lire(dossier.resolve(CSV))).pages();
    }
}
