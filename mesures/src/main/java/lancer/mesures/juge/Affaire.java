package lancer.mesures.juge;

import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import lancer.Constantes;
import lancer.Scene;
import lancer.atelier.Scenes;

/** Une scène à juger : un fichier, ou une scène par son nom, et le nombre de reflets. */
final class Affaire {

    private static final String[] TOUTES = {"scene1", "diffus", "ombres", "miroirs", "bowling", "tournesol", "brume"};

    /** Dans le tunnel de miroirs.ini, ce nombre-là est celui que conseille la scène. */
    private static final int REFLETS_DU_TUNNEL = 40;

    final String nom;
    final int reflets;
    private final Path fichier;

    private Affaire(String nom, int reflets, Path fichier) {
        this.nom = nom;
        this.reflets = reflets;
        this.fichier = fichier;
    }

    /** La scène d'un fichier. */
    static Affaire fichier(String fichier, int reflets) {
        Path chemin = Paths.get(fichier);
        return new Affaire(chemin.getFileName().toString().replaceFirst("\\.ini$", ""), reflets, chemin);
    }

    /** Toutes les scènes livrées, puis une grande foule engendrée, où quelques pixels sont sur un bord. */
    static List<Affaire> toutes() {
        List<Affaire> toutes = new ArrayList<>();
        for (String nom : TOUTES) {
            toutes.add(new Affaire(nom, Constantes.MAX_REFLETS, null));
        }
        toutes.add(new Affaire("miroirs", REFLETS_DU_TUNNEL, null));
        toutes.add(new Affaire(Scenes.FOULE + "-10000", Constantes.MAX_REFLETS, null));
        return toutes;
    }

    /**
     * Ses objets et ses lampes, sans les variantes que le chemin des classes pourrait contenir : POV-Ray n'en sait rien.
     *
     * @param dossier où écrire celles qui sont engendrées
     */
    Scene lire(Path dossier) throws IOException {
        return Scenes.lire(fichier != null ? fichier : Scenes.fichier(nom, dossier));
    }
}
