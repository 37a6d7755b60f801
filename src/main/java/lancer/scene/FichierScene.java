package lancer.scene;

import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.attribute.BasicFileAttributes;
import lancer.SceneFautive;
import lancer.texte.ErreurSysteme;
import lancer.texte.Texte;

/** Le fichier d'une scène : où il est, comment il s'ouvre, s'il a changé. */
public final class FichierScene {

    /** Nombre de dossiers parents où une scène est aussi cherchée. */
    private static final int DOSSIERS_AU_DESSUS = 4;

    private FichierScene() {
    }

    /** Ouvre un fichier par {@code java.io}, qui sait lire un tube ; si elle échoue, {@code java.nio} dit pourquoi. */
    static InputStream ouvrir(Path chemin) throws IOException {
        try {
            return new FileInputStream(chemin.toFile());
        } catch (FileNotFoundException e) {
            return Files.newInputStream(chemin);
        }
    }

    /**
     * Le chemin de la scène. Un chemin relatif qui n'existe pas ici est cherché dans les quatre dossiers parents, du
     * plus proche au plus lointain.
     *
     * @throws SceneFautive s'il ne mène à aucun fichier
     */
    public static Path trouver(String fichier) {
        Path chemin;
        try {
            chemin = Paths.get(fichier);
        } catch (InvalidPathException e) {
            throw inutilisable(fichier, "nom de fichier impossible" + ErreurSysteme.horsLangue(fichier), e);
        }
        Path trouve = chemin;
        for (int k = 0; k < DOSSIERS_AU_DESSUS && !chemin.isAbsolute() && !Files.exists(trouve); k++) {
            trouve = Paths.get("..").resolve(trouve);
        }
        if (!Files.exists(trouve)) {
            String ici = Paths.get("").toAbsolutePath().toString();
            String ou = " dans " + Texte.echappe(ici) + " et les " + DOSSIERS_AU_DESSUS + " dossiers au-dessus"
                    + ErreurSysteme.horsLangue(ici);
            throw inutilisable(fichier, "fichier introuvable" + (chemin.isAbsolute() ? "" : ou), null);
        }
        if (Files.isDirectory(trouve)) {
            throw inutilisable(trouve.equals(chemin) ? fichier : trouve.toString(), "c'est un dossier", null);
        }
        return trouve;
    }

    /** L'heure et la taille du fichier ; {@code null} s'il n'existe pas. */
    public static String version(String fichier) {
        try {
            BasicFileAttributes a = Files.readAttributes(trouver(fichier), BasicFileAttributes.class);
            return a.lastModifiedTime() + " " + a.size();
        } catch (IOException | SceneFautive e) {
            return null;
        }
    }

    static SceneFautive inutilisable(String fichier, String faute, Exception cause) {
        return new SceneFautive(SectionLue.message(fichier, 0, null, null, faute, "un fichier de scène"), cause);
    }
}
