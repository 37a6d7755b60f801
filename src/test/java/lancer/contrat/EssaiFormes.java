package lancer.contrat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import lancer.Main;
import lancer.essai.Essai;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/**
 * Une forme d'étudiant ne demande qu'une classe et une ligne de services : ici, le plan de docs/etendre.md. Il s'y appelle
 * {@code Panneau}, pour que ces tests restent vrais là où quelqu'un l'a copié dans la base.
 */
abstract class EssaiFormes {

    static final String SERVICE = "META-INF/services/lancer.contrat.Forme";

    static final String MUR = "[Panneau mur]\npoint=7 8 5\nnormale=0 0 -3\n";

    @TempDir
    static Path commun;
    static List<String> blocs;
    static String panneau;
    static Path classesDuPanneau;

    @TempDir
    Path dossier;
    Path scene;

    @BeforeAll
    static void copierLaPage() throws IOException {
        String section = Essai.texte("docs/etendre.md").split("\n## Une forme à soi\n")[1].split("\n## ")[0];
        blocs = new ArrayList<>();
        for (String paragraphe : section.split("\n(?=[^ \n])")) {
            int bloc = paragraphe.indexOf("\n    ");
            if (bloc >= 0) {
                blocs.add(paragraphe.substring(bloc + 1).replaceAll("(?m)^    ", ""));
            }
        }
        assertTrue(section.contains("`src/main/java/lancer/Plan.java`") && section.contains("> src/main/resources/" + SERVICE + "\n"));
        panneau = blocs.get(0).replace("Plan", "Panneau").replace("plan", "panneau");
        classesDuPanneau = Files.createDirectory(commun.resolve("panneau"));
        inscrire(classesDuPanneau, SERVICE, panneau);
    }

    @BeforeEach
    void nommerLaScene() throws IOException {
        dossier = dossier.toRealPath();
        scene = dossier.resolve("s.ini");
    }

    static String lireTexte(Path fichier) throws IOException {
        return new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
    }

    /** Compile ces classes dans le dossier, et les inscrit chacune sur une ligne de ce fichier de services. */
    static void inscrire(Path classes, String service, String... sources) throws IOException {
        JavaCompiler javac = ToolProvider.getSystemJavaCompiler();
        List<String> noms = new ArrayList<>();
        for (String source : sources) {
            String nom = source.replaceAll("(?s).*?public (?:final )?class (\\w+).*", "$1");
            noms.add(source.replaceAll("(?s).*?package (\\w+);.*", "$1") + "." + nom);
            Path fichier = Files.createDirectories(classes.resolve("sources")).resolve(nom + ".java");
            Files.write(fichier, source.getBytes(StandardCharsets.UTF_8));
            assertEquals(0, javac.run(null, null, null, "-encoding", "UTF-8", "-Xlint:all", "-Werror", "-d", classes.toString(),
                    "-cp", Essai.origine(Main.class) + File.pathSeparator + classes, fichier.toString()), source);
        }
        Files.createDirectories(classes.resolve(service).getParent());
        Files.write(classes.resolve(service), noms, StandardCharsets.UTF_8);
    }

    Path inscrire(String service, String... sources) throws IOException {
        Path classes = Files.createDirectory(dossier.resolve("classes"));
        inscrire(classes, service, sources);
        return classes;
    }
}
