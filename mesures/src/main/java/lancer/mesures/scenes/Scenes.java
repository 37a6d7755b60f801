package lancer.mesures.scenes;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Scene;
import lancer.contrat.Modele;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;

/**
 * Des scènes par leur nom : un fichier de {@code scenes/}, ou une scène engendrée (« foule-1000 », {@link Difficiles}). Elles sont lues
 * sans variante, même si une variante à mesurer est dans le chemin des classes.
 */
public final class Scenes {

    public static final String FOULE = "foule";

    /** Trois scènes engendrées, difficiles à échantillonner. */
    public static final List<String> DIFFICILES = Difficiles.FINES;

    /** Scènes engendrées où quelques pixels portent presque toute l'erreur. */
    public static final List<String> RARES = Difficiles.RARES;

    private Scenes() {
    }

    static boolean estDifficile(String nom) {
        return DIFFICILES.contains(nom) || RARES.contains(nom);
    }

    /** Les fichiers des scènes livrées, par ordre alphabétique. */
    public static List<Path> livrees() throws IOException {
        try (Stream<Path> fichiers = Files.list(LecteurScene.trouver("scenes/scene1.ini").toAbsolutePath().getParent())) {
            return fichiers.filter(f -> f.toString().endsWith(".ini")).sorted().collect(Collectors.toList());
        }
    }

    /** Une scène, sans variante. @throws lancer.SceneFautive si le fichier ne peut être utilisé */
    public static Scene lire(Path fichier) {
        SceneLue lue = LecteurScene.lire(fichier.toString(), part -> { });
        return new Scene(lue.objets, lue.lampes, lue.getCadrage(), new Modele());
    }

    /**
     * Le fichier de cette scène, écrit si besoin.
     *
     * @param dossier dossier du fichier écrit, qui y reste
     * @throws lancer.SceneFautive si une scène livrée manque
     */
    public static Path fichier(String nom, Path dossier) throws IOException {
        if (!nom.startsWith(FOULE + "-") && !estDifficile(nom)) {
            return LecteurScene.trouver("scenes/" + nom + ".ini");
        }
        Path fichier = dossier.resolve(nom + ".ini");
        // ce fichier peut dépasser cent millions d'octets : Ctrl+C ne doit pas le laisser
        fichier.toFile().deleteOnExit();
        try (BufferedWriter sortie = Files.newBufferedWriter(fichier)) {
            Foule.ecrire(sortie, nom.replace(FOULE + "-", ""));
        }
        return fichier;
    }
}
