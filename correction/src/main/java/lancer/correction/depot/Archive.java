package lancer.correction.depot;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.apache.commons.compress.archivers.zip.ZipArchiveEntry;
import org.apache.commons.compress.archivers.zip.ZipFile;

/** Une archive zip, lue sans rien écrire : ses entrées dans l'ordre, dont on sait si ce sont des liens. */
final class Archive implements AutoCloseable {

    /** Un fichier, un dossier ou un lien de ce qui est rendu, du disque ou d'une archive. */
    static final class Entree {

        /** Nom depuis le dossier, ou dans l'archive ; celui d'un dossier finit par « / ». */
        final String chemin;
        final boolean lien;
        /** Taille en octets, telle qu'elle est annoncée ; négative si elle ne l'est pas. */
        final long taille;
        final Contenu contenu;

        /** Flux pour le lire. */
        interface Contenu {
            InputStream ouvrir() throws IOException;
        }

        Entree(String chemin, boolean lien, long taille, Contenu contenu) {
            this.chemin = chemin;
            this.lien = lien;
            this.taille = taille;
            this.contenu = contenu;
        }

        /** Le premier nom de son chemin. */
        String premier() {
            return chemin.replaceFirst("(?s)/.*", "");
        }
    }

    private final ZipFile zip;
    final List<Entree> entrees = new ArrayList<>();

    /** @throws IOException si ce n'est pas une archive zip lisible */
    Archive(Path fichier) throws IOException {
        zip = ZipFile.builder().setPath(fichier).get();
        for (ZipArchiveEntry e : Collections.list(zip.getEntries())) {
            // des « / » même si l'archive vient de Windows
            entrees.add(new Entree(e.getName().replace('\\', '/'), e.isUnixSymlink(), e.getSize(), () -> zip.getInputStream(e)));
        }
    }

    @Override
    public void close() throws IOException {
        zip.close();
    }
}
