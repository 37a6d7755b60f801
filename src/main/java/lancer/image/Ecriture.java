package lancer.image;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import lancer.commande.Echec;
import lancer.texte.Texte;

/**
 * Un fichier écrit en entier ou pas du tout : d'abord à côté, sous un nom provisoire, puis renommé, avec les
 * permissions de celui qu'il remplace. Un lien symbolique est suivi ; ce qui n'est pas un fichier ordinaire (un tube,
 * par exemple) est écrit directement. Le nom provisoire dit quel processus écrit : si celui-ci est tué avant la fin,
 * l'écriture suivante dans ce dossier efface ce qu'il a laissé.
 */
public final class Ecriture {

    /** Ce qui sait écrire une image dans un flux. */
    public interface Format {
        void ecrire(ImageMemoire image, OutputStream sortie) throws IOException;
    }

    /** Autour d'un nom provisoire, court : celui de la cible peut déjà être aussi long que le système le permet. */
    private static final String DEBUT_PROVISOIRE = ".lancer-";
    private static final String FIN_PROVISOIRE = ".tmp";

    /** Là où Linux montre les processus, chacun sous son numéro. */
    private static final String PROCESSUS = "/proc";

    /** Nombre de liens symboliques suivis l'un après l'autre, comme le fait Linux. */
    private static final int LIENS_MAX = 40;

    private final String nom;
    private final Path cible;

    /**
     * @param nom le fichier à écrire
     * @throws Echec s'il est clair dès maintenant qu'il ne pourra l'être
     */
    public Ecriture(String nom) {
        this.nom = nom;
        try {
            cible = suivre(Paths.get(nom).toAbsolutePath());
        } catch (InvalidPathException e) {
            throw impossible("nom de fichier impossible" + Texte.horsLangue(nom));
        } catch (IOException e) {
            throw impossible(raison(e) + Texte.horsLangue(nom));
        }
        if (Files.isDirectory(cible)) {
            throw impossible("c'est un dossier");
        }
        Path dossier = cible.getParent();
        if (!Files.isDirectory(dossier)) {
            throw impossible("le dossier n'existe pas");
        }
        if (!estSpecial() && !Files.isWritable(dossier)) {
            throw impossible("écriture interdite dans le dossier " + Texte.echappe(dossier.toString()));
        }
        if (Files.exists(cible) && !Files.isWritable(cible)) {
            throw impossible("écriture interdite");
        }
    }

    /** Le fichier au bout des liens, qu'il existe ou non, dans le vrai dossier : un fichier n'a que ce nom. */
    private static Path suivre(Path chemin) throws IOException {
        Path lien = chemin;
        for (int suivis = 0; Files.isSymbolicLink(lien) && !Files.exists(lien); suivis++) {
            if (suivis == LIENS_MAX) {
                throw new IOException("trop de liens symboliques");
            }
            lien = lien.resolveSibling(Files.readSymbolicLink(lien));
        }
        // celui d'un tube, /proc/self/fd/1, mène à « pipe:[123] », qui n'est le nom de rien
        return Files.isRegularFile(lien) ? lien.toRealPath()
                : Files.exists(lien) ? lien : lien.getParent().toRealPath().resolve(lien.getFileName());
    }

    /** Vrai pour ce qui n'est pas un fichier ordinaire : on y écrit, on ne le remplace pas. */
    private boolean estSpecial() {
        return Files.exists(cible) && !Files.isRegularFile(cible);
    }

    /** Le fichier qui sera écrit, liens suivis. */
    public Path getCible() {
        return cible;
    }

    /**
     * @param faute comment le dire
     * @throws Echec si c'est cet autre fichier que l'on écrirait, sous ce nom ou un autre
     */
    public void epargner(Path autre, String faute) {
        try {
            if (Files.isSameFile(cible, autre)) {
                throw Echec.demande(faute);
            }
        } catch (IOException e) {
            // un seul des deux existe
        }
    }

    /** @throws Echec si l'écriture échoue ; le fichier est alors comme avant */
    public void ecrire(ImageMemoire image, Format format) {
        try {
            if (estSpecial()) {
                try (OutputStream sortie = Files.newOutputStream(cible)) {
                    format.ecrire(image, sortie);
                }
                return;
            }
            String processus = new File(PROCESSUS, "self").getCanonicalFile().getName();
            balayer(cible.getParent().toFile(), processus);
            try {
                ecrireACote(image, format, processus);
            } catch (NoSuchFileException e) {
                // ailleurs que sous Linux, ou sur un disque partagé, un autre programme a pu balayer le provisoire
                // pendant qu'il s'écrivait
                ecrireACote(image, format, processus);
            }
        } catch (IOException e) {
            throw impossible(raison(e));
        }
    }

    /** Efface de ce dossier les provisoires des processus qui ne sont plus ; celui-ci n'en a pas encore. */
    private static void balayer(File dossier, String processus) {
        String[] noms = dossier.list();
        for (String reste : noms == null ? new String[0] : noms) {
            if (reste.startsWith(DEBUT_PROVISOIRE) && reste.endsWith(FIN_PROVISOIRE)) {
                String ecrivain = reste.substring(DEBUT_PROVISOIRE.length()).split("-")[0];
                if (ecrivain.equals(processus) || !new File(PROCESSUS, ecrivain).exists()) {
                    new File(dossier, reste).delete();
                }
            }
        }
    }

    private void ecrireACote(ImageMemoire image, Format format, String processus) throws IOException {
        Path provisoire = cible.resolveSibling(
                DEBUT_PROVISOIRE + processus + "-" + Long.toHexString(System.nanoTime()) + FIN_PROVISOIRE);
        // Ctrl+C pendant l'écriture ne laisse rien derrière lui
        provisoire.toFile().deleteOnExit();
        try {
            try (OutputStream sortie = Files.newOutputStream(provisoire, StandardOpenOption.CREATE_NEW)) {
                // avant d'écrire : ce que l'ancien fichier cachait ne se voit pas un instant
                garderLesPermissions(provisoire);
                format.ecrire(image, sortie);
            }
            // REPLACE_EXISTING effacerait d'abord l'ancien, et quelqu'un pourrait le voir absent
            Files.move(provisoire, cible, StandardCopyOption.ATOMIC_MOVE);
        } finally {
            Files.deleteIfExists(provisoire);
        }
    }

    private void garderLesPermissions(Path provisoire) {
        try {
            if (Files.exists(cible)) {
                Files.setPosixFilePermissions(provisoire, Files.getPosixFilePermissions(cible));
            }
        } catch (IOException | UnsupportedOperationException e) {
            // ce disque n'en a pas
        }
    }

    private static String raison(IOException e) {
        return e instanceof NoSuchFileException ? "le dossier n'existe pas" : Texte.panne(e);
    }

    private Echec impossible(String raison) {
        return Echec.panne(Texte.echappe(nom) + " : écriture impossible, " + raison);
    }
}
