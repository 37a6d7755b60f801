package lancer.sortie;

import java.io.BufferedOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;
import lancer.lecture.Texte;

/**
 * Un fichier écrit en entier ou pas du tout : d'abord à côté, sous un nom provisoire, puis renommé. Un lien symbolique est
 * suivi ; ce qui n'est pas un fichier ordinaire (un tube, {@code /dev/null}) est écrit directement.
 */
public final class Ecriture {

    /** Ce qui sait écrire une image dans un flux. */
    public interface Format {
        void ecrire(ImageMemoire image, OutputStream sortie) throws IOException;
    }

    private final String nom;
    private final Path cible;

    /**
     * @param nom le fichier à écrire
     * @throws Echec s'il est clair dès maintenant qu'il ne pourra l'être
     */
    public Ecriture(String nom) {
        this.nom = nom;
        try {
            Path chemin = Paths.get(nom);
            cible = Files.exists(chemin) ? chemin.toRealPath() : destination(chemin);
        } catch (InvalidPathException e) {
            throw impossible("nom de fichier impossible");
        } catch (IOException e) {
            throw impossible(raison(e));
        }
        Path dossier = cible.toAbsolutePath().getParent();
        if (Files.isDirectory(cible)) {
            throw impossible("c'est un dossier");
        }
        if (dossier == null || !Files.isDirectory(dossier)) {
            throw impossible("le dossier n'existe pas");
        }
        if (!Files.isWritable(Files.exists(cible) && !Files.isRegularFile(cible) ? cible : dossier)) {
            throw impossible("écriture interdite");
        }
    }

    /** La cible d'un lien vers un fichier qui n'existe pas encore, ou le chemin même. */
    private static Path destination(Path chemin) throws IOException {
        Path lien = chemin;
        for (int suivis = 0; Files.isSymbolicLink(lien) && suivis < 40; suivis++) {
            lien = lien.resolveSibling(Files.readSymbolicLink(lien));
        }
        return lien;
    }

    /** Le fichier qui sera écrit, liens suivis. */
    public Path getCible() {
        return cible;
    }

    /** @throws Echec si l'écriture échoue ; le fichier est alors comme avant */
    public void ecrire(ImageMemoire image, Format format) {
        try {
            if (Files.exists(cible) && !Files.isRegularFile(cible)) {
                try (OutputStream sortie = Files.newOutputStream(cible)) {
                    format.ecrire(image, sortie);
                }
                return;
            }
            Path provisoire = cible.resolveSibling("." + cible.getFileName() + "." + System.nanoTime() + ".tmp");
            File aEffacer = provisoire.toFile();
            // Ctrl+C pendant l'écriture ne laisse rien derrière lui
            aEffacer.deleteOnExit();
            try {
                try (OutputStream sortie = new BufferedOutputStream(
                        Files.newOutputStream(provisoire, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE), 1 << 16)) {
                    format.ecrire(image, sortie);
                }
                Files.move(provisoire, cible, StandardCopyOption.REPLACE_EXISTING);
            } finally {
                Files.deleteIfExists(provisoire);
            }
        } catch (IOException e) {
            throw impossible(raison(e));
        }
    }

    private static String raison(IOException e) {
        if (e instanceof AccessDeniedException) {
            return "écriture interdite";
        }
        if (e instanceof NoSuchFileException) {
            return "le dossier n'existe pas";
        }
        String raison = e instanceof FileSystemException ? ((FileSystemException) e).getReason() : e.getMessage();
        return "No space left on device".equals(raison) ? "disque plein"
                : raison == null ? "échec du système" : Texte.abrege(raison);
    }

    private Echec impossible(String raison) {
        return new Echec(CodeSortie.PANNE, Texte.echappe(nom) + " : écriture impossible, " + raison);
    }
}
