package lancer.scene;

import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.zip.CRC32;
import lancer.SceneFautive;
import lancer.texte.ErreurSysteme;
import lancer.texte.Texte;

/** Recherche du fichier d'une scène. */
public final class FichierScene {

    /** Nombre de dossiers parents où une scène est aussi cherchée. */
    private static final int DOSSIERS_AU_DESSUS = 4;

    /** La taille du plus grand fichier dont le contenu est lu à chaque observation. */
    private static final int OCTETS_SOMMES = 1 << 20;

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
            throw inutilisable(fichier, absente(chemin), null);
        }
        if (Files.isDirectory(trouve)) {
            throw inutilisable(trouve.equals(chemin) ? fichier : trouve.toString(), "c'est un dossier", null);
        }
        return trouve;
    }

    /**
     * L'heure, la taille et l'identité du fichier, et une somme de son contenu s'il est petit : deux enregistrements
     * peuvent avoir la même heure et la même taille. {@code null} s'il n'existe pas.
     */
    public static String version(String fichier) {
        try {
            Path chemin = trouver(fichier);
            BasicFileAttributes a = Files.readAttributes(chemin, BasicFileAttributes.class);
            CRC32 somme = new CRC32();
            if (a.isRegularFile() && a.size() <= OCTETS_SOMMES) {
                somme.update(Files.readAllBytes(chemin));
            }
            return a.lastModifiedTime() + " " + a.size() + " " + a.fileKey() + " " + somme.getValue();
        } catch (IOException | SceneFautive e) {
            return null;
        }
    }

    static SceneFautive inutilisable(String fichier, String faute, Exception cause) {
        return new SceneFautive(SectionLue.message(fichier, 0, null, null, faute, "un fichier de scène"), cause);
    }

    /** Raison pour laquelle ce chemin ne mène à rien, et dossier de départ. */
    private static String absente(Path chemin) {
        String introuvable = "fichier introuvable";
        String faute = introuvable;
        try {
            chemin.toRealPath();
        } catch (IOException e) {
            faute = pourquoi(e, ErreurSysteme.raison(e));
        }
        if (chemin.isAbsolute() || !faute.equals(introuvable)) {
            return faute;
        }
        Path ici = Paths.get("").toAbsolutePath();
        int plusHaut = Math.min(DOSSIERS_AU_DESSUS, ici.getNameCount());
        return faute + " dans " + Texte.echappe(ici.toString()) + (plusHaut == 0 ? ""
                : plusHaut == 1 ? " et le dossier au-dessus" : " et les " + plusHaut + " dossiers au-dessus")
                + ErreurSysteme.horsLangue(ici.toString());
    }

    /** Raison pour laquelle un fichier ne peut être lu, ou {@code sinon}. */
    static String pourquoi(IOException e, String sinon) {
        return e instanceof AccessDeniedException ? "lecture interdite" : sinon;
    }
}
