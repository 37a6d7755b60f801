package lancer.mesures.scenes;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Scene;
import lancer.scene.FichierScene;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;

/**
 * Des scènes par leur nom : une de {@code scenes/}, celle que l'on ne fait que mesurer (« tp »), ou engendrée le temps
 * de s'en servir (« foule-1000 »). Telles que la base les voit : les variantes du chemin des classes sont là pour être
 * mesurées, non pour s'y installer.
 */
public final class Scenes {

    public static final String FOULE = "foule";

    /** Dix boules qui se reflètent, et deux lampes. */
    public static final String TP = "tp";

    private Scenes() {
    }

    /** Les fichiers des scènes livrées, dans l'ordre de leurs noms. */
    public static List<Path> livrees() throws IOException {
        try (Stream<Path> fichiers = Files.list(Paths.get("scenes"))) {
            return fichiers.filter(f -> f.toString().endsWith(".ini")).sorted().collect(Collectors.toList());
        }
    }

    /** Une scène, sans variante. @throws lancer.SceneFautive si le fichier ne peut être utilisé */
    public static Scene lire(Path fichier) {
        SceneLue lu = LecteurScene.lire(fichier.toString(), part -> { });
        return new Scene(lu.objets, lu.lampes);
    }

    /**
     * Le fichier de cette scène, écrit s'il le faut.
     *
     * @param dossier où l'écrire ; il y est laissé
     * @throws lancer.SceneFautive si une scène livrée n'est pas là
     */
    public static Path fichier(String nom, Path dossier) throws IOException {
        int tiret = nom.indexOf('-');
        if (tiret < 0) {
            return FichierScene.trouver((nom.equals(TP) ? "mesures/src/main/scenes/" : "scenes/") + nom + ".ini");
        }
        Path fichier = dossier.resolve(nom + ".ini");
        // cent millions d'octets peut-être, que Ctrl+C ne doit pas laisser
        fichier.toFile().deleteOnExit();
        try (BufferedWriter sortie = Files.newBufferedWriter(fichier)) {
            Foule.ecrire(sortie, Integer.parseInt(nom.substring(tiret + 1)));
        }
        return fichier;
    }
}
