package lancer.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.Collections;
import java.util.Map;
import lancer.commande.Echec;
import lancer.texte.ErreurSysteme;
import lancer.texte.Texte;

/**
 * Un fichier écrit en entier ou pas du tout : il est écrit sous un nom provisoire, dans le même dossier, puis renommé.
 * Un lien symbolique est suivi. Une cible qui n'est pas un fichier ordinaire (un tube) est écrite directement.
 */
public final class Ecriture {

    public interface Format {
        void ecrire(ImageMemoire image, OutputStream sortie) throws IOException;
    }

    private final String nom;
    private final Path cible;
    /** Vrai si la cible n'est pas un fichier ordinaire, et ne peut être remplacée. */
    private final boolean directe;
    private final Path provisoire;

    /** @throws Echec si l'on sait déjà que le fichier ne pourra être écrit */
    public Ecriture(String nom) {
        this.nom = nom;
        try {
            cible = suivre(Paths.get(nom).toAbsolutePath());
        } catch (IOException | InvalidPathException e) {
            throw impossible(raison(e) + ErreurSysteme.horsLangue(nom));
        }
        directe = estSpeciale(cible);
        // un nom court : celui de la cible peut avoir la longueur maximale
        provisoire = cible.resolveSibling(".lancer-" + Long.toHexString(System.nanoTime()) + ".tmp");
        if (Files.isDirectory(cible)) {
            throw impossible("c'est un dossier");
        }
        if (!directe && !Files.isWritable(cible.getParent())) {
            throw impossible("écriture interdite dans le dossier " + Texte.echappe(cible.getParent().toString()));
        }
        if (Files.exists(cible) && !Files.isWritable(cible)) {
            throw impossible("écriture interdite");
        }
    }

    /** Le fichier que désignent les liens, qu'il existe ou non, dans son dossier réel. */
    private static Path suivre(Path chemin) throws IOException {
        // le lien d'un tube, /proc/self/fd/1, mène à « pipe:[123] », qui n'est le nom d'aucun fichier
        if (estSpeciale(chemin)) {
            return chemin;
        }
        try {
            return chemin.toRealPath();
        } catch (NoSuchFileException | AccessDeniedException e) {
            return Files.isSymbolicLink(chemin) ? suivre(chemin.resolveSibling(Files.readSymbolicLink(chemin)))
                    : chemin.getParent().toRealPath().resolve(chemin.getFileName());
        }
    }

    private static boolean estSpeciale(Path chemin) {
        return Files.exists(chemin) && !Files.isRegularFile(chemin);
    }

    /** Le fichier qui sera écrit, liens suivis. */
    public Path getCible() {
        return cible;
    }

    /** @throws Echec si la cible est cet autre fichier, même sous un autre nom ; {@code quoi} dit ce qu'il est */
    public void distinguer(Path autre, String quoi) {
        try {
            if (Files.isSameFile(cible, autre)) {
                throw Echec.demande("la sortie est " + quoi + " : " + Texte.echappe(autre.toString())
                        + " ; attendu : un autre fichier");
            }
        } catch (IOException e) {
            // un des deux fichiers n'existe pas : ils sont différents
        }
    }

    /** Remplace le contenu du fichier. @throws Echec si l'écriture échoue ; le fichier est alors inchangé */
    public void ecrire(byte[] octets) {
        ecrire(null, (sansImage, sortie) -> sortie.write(octets));
    }

    /** Écrit l'image dans ce fichier. @throws Echec comme {@link #ecrire(byte[])} */
    public void ecrire(ImageMemoire image, Format format) {
        ecrire(image, Collections.singletonMap(this, format));
    }

    /** Écrit l'image dans tous ces fichiers ou dans aucun. @throws Echec si une écriture échoue */
    public static void ecrire(ImageMemoire image, Map<Ecriture, Format> fichiers) {
        Ecriture enCours = null;
        try {
            for (Ecriture fichier : fichiers.keySet()) {
                enCours = fichier;
                // le fichier provisoire disparaît même si Ctrl+C interrompt l'écriture
                fichier.provisoire.toFile().deleteOnExit();
                Path ecrit = fichier.directe ? fichier.cible : fichier.provisoire;
                try (OutputStream sortie = Files.newOutputStream(ecrit)) {
                    fichiers.get(fichier).ecrire(image, sortie);
                }
            }
            for (Ecriture fichier : fichiers.keySet()) {
                enCours = fichier;
                if (!fichier.directe) {
                    // REPLACE_EXISTING effacerait d'abord l'ancien fichier : un autre programme le verrait absent
                    Files.move(fichier.provisoire, fichier.cible, StandardCopyOption.ATOMIC_MOVE);
                }
            }
        } catch (IOException e) {
            throw enCours.impossible(raison(e));
        } finally {
            for (Ecriture fichier : fichiers.keySet()) {
                fichier.provisoire.toFile().delete();
            }
        }
    }

    private static String raison(Exception e) {
        return e instanceof NoSuchFileException ? "le dossier n'existe pas" : ErreurSysteme.raison(e);
    }

    private Echec impossible(String raison) {
        return Echec.machine(Texte.echappe(nom) + " : écriture impossible, " + raison);
    }
}
