package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.abort;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** De quoi donner une ligne de commande au programme, et voir ce qu'il écrit, dit et rend. */
public abstract class EssaiCommande {

    protected static final String SCENE = Ressources.chemin("reference/p3-miroirs.ini");

    @TempDir
    protected Path dossier;
    protected Path png;
    protected Path pfm;

    @BeforeEach
    protected void nommerLesSorties() throws IOException {
        dossier = dossier.toRealPath();
        png = dossier.resolve("image.png");
        pfm = dossier.resolve("image.pfm");
    }

    /** JUnit s'inquiéterait, en vidant le dossier, de ceux qui mènent ailleurs. */
    @AfterEach
    protected void effacerLesLiens() throws IOException {
        for (File fichier : dossier.toFile().listFiles()) {
            if (Files.isSymbolicLink(fichier.toPath())) {
                Files.delete(fichier.toPath());
            }
        }
    }

    /** Dessine la scène en petit ; la demande doit aboutir, sans rien dire. */
    protected static String dessiner(String... arguments) {
        Essai e = executer(arguments);
        assertEquals(0, e.code, e.toString());
        assertEquals("", e.erreur);
        return e.sortie;
    }

    protected static Essai executer(String... arguments) {
        return Essai.executer(Essai.suite(arguments, "--taille", "40x30", SCENE));
    }

    protected static void verifierRefus(int statut, String message, Essai e) {
        e.exigerRefus(statut, message);
    }

    protected void verifierFichiers(String... noms) {
        assertEquals(new TreeSet<>(List.of(noms)), new TreeSet<>(List.of(dossier.toFile().list())));
    }

    /** Un lien symbolique ; le test est passé là où Windows n'en donne pas le droit, ou n'en fait pas un. */
    protected Path lien(String nom, Path vers) throws IOException {
        try {
            Path lien = Files.createSymbolicLink(dossier.resolve(nom), vers);
            assumeTrue(Files.isSymbolicLink(lien), "pas de liens symboliques ici");
            return lien;
        } catch (UnsupportedOperationException | FileSystemException e) {
            if (File.separatorChar == '/') {
                throw e;
            }
            return abort("pas de liens symboliques ici : " + e);
        }
    }
}
