package lancer.mesures.juge;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import lancer.Constantes;
import lancer.Scene;
import lancer.mesures.Generateur;
import lancer.mesures.Scenes;

/** Une scène à juger : un fichier, ou une scène engendrée, et le nombre de reflets. */
final class Affaire {

    /** Ce qui écrit une scène. */
    private interface Texte {
        void ecrire(Appendable sortie) throws IOException;
    }

    private static final String[] LIVREES = {"scene1", "diffus", "ombres", "miroirs", "bowling", "tournesol", "brume"};

    /** Dans le tunnel de miroirs.ini, ce nombre-là est celui que conseille la scène. */
    private static final int REFLETS_DU_TUNNEL = 40;

    private static final int GENERATIONS = 4;
    private static final int FOULE = 10000;

    final String nom;
    final int reflets;
    private final String fichier;
    private final Texte texte;

    private Affaire(String nom, int reflets, String fichier, Texte texte) {
        this.nom = nom;
        this.reflets = reflets;
        this.fichier = fichier;
        this.texte = texte;
    }

    /** La scène d'un fichier. */
    static Affaire fichier(String fichier, int reflets) {
        return new Affaire(Paths.get(fichier).getFileName().toString().replaceFirst("\\.ini$", ""), reflets, fichier, null);
    }

    /** Toutes les scènes livrées, puis deux grandes scènes engendrées, où quelques pixels sont sur un bord. */
    static List<Affaire> toutes() {
        List<Affaire> toutes = new ArrayList<>();
        for (String nom : LIVREES) {
            toutes.add(fichier("scenes/" + nom + ".ini", Constantes.MAX_REFLETS));
        }
        toutes.add(fichier("scenes/miroirs.ini", REFLETS_DU_TUNNEL));
        toutes.add(new Affaire("flocon-7381", Constantes.MAX_REFLETS, null, s -> Generateur.flocon(s, GENERATIONS)));
        toutes.add(new Affaire("foule-" + FOULE, Constantes.MAX_REFLETS, null, s -> Generateur.foule(s, FOULE, Generateur.GRAINE)));
        return toutes;
    }

    /**
     * Ses objets et ses lampes, sans les variantes que le chemin des classes pourrait contenir : POV-Ray n'en sait rien.
     *
     * @param dossier où écrire celles qui sont engendrées
     */
    Scene lire(Path dossier) throws IOException {
        return Scenes.nue(new Scene(texte == null ? fichier : engendrer(dossier)));
    }

    private String engendrer(Path dossier) throws IOException {
        Path engendree = dossier.resolve(nom + ".ini");
        try (BufferedWriter sortie = Files.newBufferedWriter(engendree, StandardCharsets.UTF_8)) {
            texte.ecrire(sortie);
        }
        return engendree.toString();
    }
}
