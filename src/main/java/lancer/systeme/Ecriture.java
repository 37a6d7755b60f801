package lancer.systeme;

import java.io.IOError;
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
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import lancer.texte.Texte;

/**
 * Un fichier écrit en entier ou pas du tout : il est écrit sous un nom provisoire, dans le même dossier, puis renommé.
 * Il garde les permissions de celui qu'il remplace. Un lien symbolique est suivi. Si l'ancien a un autre nom (un lien
 * dur) ou un autre propriétaire, le nouveau y est recopié : seule une panne pendant cette copie le laisserait
 * incomplet. Une cible qui n'est pas un fichier ordinaire (un tube) est écrite directement.
 *
 * @param <T> ce que contient le fichier
 */
public final class Ecriture<T> {

    public interface Format<T> {
        void ecrire(T contenu, OutputStream sortie) throws IOException;
    }

    /** Tenu pendant la création d'un fichier provisoire ; l'arrêt du programme le garde : ensuite, aucun n'est créé. */
    private static final Lock CREATION = new ReentrantLock();

    static {
        Runtime.getRuntime().addShutdownHook(new Thread(CREATION::lock));
    }

    /** Combien de fois un remplacement est essayé, et en combien de nanosecondes : une seconde en tout. */
    private static final int ESSAIS = 11;
    private static final long ENTRE_DEUX_ESSAIS_NS = 100_000_000;

    private final String nom;
    private final Format<T> format;
    /** Le fichier qui sera écrit, liens suivis. */
    public final Path cible;
    private final boolean directe;
    private final Path provisoire;
    private boolean surPlace;

    /** @throws Echec si l'on sait déjà que le fichier ne pourra être écrit */
    public Ecriture(String nom, Format<T> format) {
        this.nom = nom;
        this.format = format;
        try {
            Path chemin = Paths.get(nom).toAbsolutePath();
            // le lien d'un tube, /proc/self/fd/1, mène à « pipe:[123] », qui n'est le nom d'aucun fichier
            directe = Files.exists(chemin) && !Files.isRegularFile(chemin);
            cible = directe ? chemin : suivre(chemin);
            // un nom court : celui de la cible peut avoir la longueur maximale
            provisoire = cible.resolveSibling(".lancer-" + Long.toHexString(System.nanoTime()) + ".tmp");
            if (!directe) {
                creer(() -> Files.delete(Files.createFile(provisoire)));
            }
            if (Files.isDirectory(cible)) {
                throw new FileSystemException(nom, null, "c'est un dossier");
            }
            if (Files.exists(cible) && !Files.isWritable(cible)) {
                throw new AccessDeniedException(nom);
            }
        } catch (IOException | InvalidPathException | IOError e) {
            throw impossible(e);
        }
    }

    /** Le fichier que désignent les liens, qu'il existe ou non, dans son dossier réel. */
    private static Path suivre(Path chemin) throws IOException {
        try {
            return chemin.toRealPath();
        } catch (NoSuchFileException e) {
            return Files.isSymbolicLink(chemin) ? suivre(chemin.resolveSibling(Files.readSymbolicLink(chemin)))
                    : chemin.getParent().toRealPath().resolve(chemin.getFileName());
        }
    }

    /** @throws Echec si la cible est cet autre fichier, même sous un autre nom ; {@code quoi} dit ce qu'il est */
    public void distinguer(String autre, String quoi) {
        try {
            if (Files.isSameFile(cible, Paths.get(autre))) {
                throw Echec.demande("la sortie est " + quoi + " : " + Texte.echappe(autre)
                        + " ; attendu : un autre fichier");
            }
        } catch (IOException | InvalidPathException e) {
            // un des deux fichiers n'existe pas : ils sont différents
        }
    }

    /** Remplace le contenu de ce fichier. @throws Echec si l'écriture échoue ; le fichier est alors inchangé */
    public void remplacer(T contenu) {
        ecrire(contenu, Collections.singleton(this), false);
    }

    /** Voir {@link #ecrire(Object, Collection)}. */
    public void ecrire(T contenu) {
        ecrire(contenu, Collections.singleton(this), true);
    }

    /**
     * Écrit ce contenu dans tous ces fichiers ou dans aucun. Là où le système refuse que l'ancien soit remplacé, parce
     * qu'un autre programme le tient ouvert, le nouveau est écrit à côté, {@code boules-2.png} pour {@code boules.png}.
     *
     * @throws Echec si une écriture échoue, ou si un fichier est à côté
     */
    public static <T> void ecrire(T contenu, Collection<Ecriture<T>> fichiers) {
        ecrire(contenu, fichiers, true);
    }

    private static <T> void ecrire(T contenu, Collection<Ecriture<T>> fichiers, boolean aCoteSIlLeFaut) {
        Ecriture<T> enCours = null;
        List<String> aCote = new ArrayList<>();
        try {
            for (Ecriture<T> fichier : fichiers) {
                enCours = fichier;
                try (OutputStream sortie = fichier.ouvrir()) {
                    fichier.format.ecrire(contenu, sortie);
                }
            }
            for (Ecriture<T> fichier : fichiers) {
                enCours = fichier;
                try {
                    fichier.renommer();
                } catch (IOException e) {
                    if (!aCoteSIlLeFaut) {
                        throw e;
                    }
                    aCote.add(fichier.ecrireACote(e));
                }
            }
        } catch (IOException e) {
            throw enCours.impossible(e);
        } finally {
            for (Ecriture<T> fichier : fichiers) {
                fichier.provisoire.toFile().delete();
            }
        }
        if (!aCote.isEmpty()) {
            throw Echec.machine(String.join(" ; ", aCote));
        }
    }

    private OutputStream ouvrir() throws IOException {
        if (directe) {
            return Files.newOutputStream(cible);
        }
        // sous Windows, ni permissions à garder, ni lecture d'un fichier qu'un autre programme peut tenir
        boolean remplace = !Console.WINDOWS && Files.isRegularFile(cible);
        creer(() -> {
            if (remplace) {
                // pour ses permissions et, si le système le permet, son propriétaire
                Files.copy(cible, provisoire, StandardCopyOption.COPY_ATTRIBUTES);
            } else {
                Files.createFile(provisoire);
            }
            // il disparaît même si Ctrl+C interrompt l'écriture
            provisoire.toFile().deleteOnExit();
        });
        surPlace = remplace && ((int) Files.getAttribute(cible, "unix:nlink") > 1
                || !Files.getOwner(provisoire).equals(Files.getOwner(cible)));
        // sans CREATE : effacé par l'arrêt du programme, il ne renaît pas
        return Files.newOutputStream(provisoire, StandardOpenOption.WRITE, StandardOpenOption.TRUNCATE_EXISTING);
    }

    private interface Creation {
        void faire() throws IOException;
    }

    private static void creer(Creation creation) throws IOException {
        CREATION.lock();
        try {
            creation.faire();
        } finally {
            CREATION.unlock();
        }
    }

    /** Met le fichier provisoire à sa place. Dix essais : un antivirus peut refuser un instant. */
    private void renommer() throws IOException {
        for (int essai = 1; ; essai++) {
            try {
                mettreEnPlace();
                return;
            } catch (FileSystemException e) {
                if (essai == ESSAIS) {
                    throw e;
                }
                LockSupport.parkNanos(ENTRE_DEUX_ESSAIS_NS);
            }
        }
    }

    private void mettreEnPlace() throws IOException {
        if (surPlace) {
            try (OutputStream sortie = Files.newOutputStream(cible)) {
                Files.copy(provisoire, sortie);
            }
        } else if (!directe) {
            // REPLACE_EXISTING effacerait d'abord l'ancien fichier : un autre programme le verrait absent
            Files.move(provisoire, cible, StandardCopyOption.ATOMIC_MOVE);
        }
    }

    /** Donne au fichier provisoire le premier nom libre. @return ce que l'on en dit */
    private String ecrireACote(IOException refus) throws IOException {
        String seul = cible.getFileName().toString();
        int point = seul.contains(".") ? seul.lastIndexOf('.') : seul.length();
        Path autre = cible;
        for (int n = 2; Files.exists(autre); n++) {
            autre = cible.resolveSibling(seul.substring(0, point) + '-' + n + seul.substring(point));
        }
        Files.move(provisoire, autre);
        String raison = Console.WINDOWS ? "un autre programme le tient ouvert" : ErreurSysteme.raison(refus, nom);
        return Texte.echappe(nom) + " : remplacement impossible, " + raison + " ; écrit à côté, dans "
                + Texte.echappe(autre.getFileName().toString());
    }

    private Echec impossible(Throwable e) {
        String raison = e instanceof NoSuchFileException ? "le dossier n'existe pas" : ErreurSysteme.raison(e, nom);
        return Echec.machine(Texte.echappe(nom) + " : écriture impossible, " + raison + ErreurSysteme.horsLangue(nom));
    }
}
