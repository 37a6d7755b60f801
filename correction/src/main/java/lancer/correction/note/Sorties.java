package lancer.correction.note;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Les tableaux que l'enseignant ouvre. Celui qu'un tableur tient ouvert est écrit à côté : {@code classe-2.csv}. */
public final class Sorties {

    private final List<String> aCote = new ArrayList<>();

    /** Écrit ce fichier, ou à côté si un autre programme le tient. */
    public void ecrire(Path fichier, byte[] octets) throws IOException {
        try {
            Files.write(fichier, octets);
        } catch (FileSystemException e) {
            if (!Files.isRegularFile(fichier)) {
                throw e;
            }
            ecrireACote(fichier, octets);
        }
    }

    /** Écrit le nouveau contenu de ce fichier à côté de lui. */
    void ecrireACote(Path fichier, byte[] octets) throws IOException {
        Files.write(libre(fichier), octets);
    }

    /** Le premier nom libre à côté de ce fichier, qui est retenu. */
    private Path libre(Path fichier) {
        String nom = fichier.getFileName().toString();
        int point = nom.lastIndexOf('.');
        Path autre = fichier;
        for (int n = 2; Files.exists(autre); n++) {
            autre = fichier.resolveSibling(nom.substring(0, point) + '-' + n + nom.substring(point));
        }
        aCote.add(nom + " est tenu par un autre programme : ce qu'il faut y lire est dans " + autre.getFileName());
        return autre;
    }

    /** Une phrase par fichier écrit à côté. */
    public List<String> aCote() {
        return Collections.unmodifiableList(aCote);
    }

    /** Ce que le système a répondu, avec nos mots. */
    public static String raison(IOException e) {
        if (!(e instanceof FileSystemException)) {
            return e.toString();
        }
        FileSystemException faute = (FileSystemException) e;
        String raison = faute.getReason() == null ? "il manque" : faute.getReason();
        return faute.getFile() + " : " + (e instanceof AccessDeniedException ? "accès interdit, ou ouvert ailleurs" : raison);
    }
}
