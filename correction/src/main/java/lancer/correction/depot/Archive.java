package lancer.correction.depot;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;

/** Une archive zip, lue sans rien écrire : ses entrées dans l'ordre, dont on sait si ce sont des liens. */
final class Archive implements AutoCloseable {

    private static final int LIEN = 0xA000;
    private static final int SORTE = 0xF000;
    /** La fin de l'archive, où est le répertoire central, et qui suffit à l'avoir tout entier. */
    private static final int QUEUE_MAX = 64 << 20;
    private static final int FIN = 22;
    private static final int SIGNATURE_DE_FIN = 0x06054b50;
    private static final int ENTREE = 46;
    private static final int SIGNATURE_D_ENTREE = 0x02014b50;

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
        zip = ouvrir(fichier.toFile());
        List<Boolean> liens = liens(fichier);
        // des « / » même si l'archive vient de Windows
        zip.stream().forEach(e -> entrees.add(new Entree(e.getName().replace('\\', '/'), entrees.size() < liens.size()
                && liens.get(entrees.size()), e.getSize(), () -> zip.getInputStream(e))));
    }

    private static ZipFile ouvrir(File fichier) throws IOException {
        try {
            return new ZipFile(fichier, StandardCharsets.UTF_8);
        } catch (ZipException e) {
            // des noms qui ne sont pas de l'UTF-8 : leurs lettres sans accent se lisent quand même
            return new ZipFile(fichier, StandardCharsets.ISO_8859_1);
        }
    }

    /** Lecture de ce que java.util.zip ne dit pas : les droits Unix, dans le répertoire central (PKWARE, APPNOTE, § 4.3.12). */
    private static List<Boolean> liens(Path fichier) throws IOException {
        List<Boolean> liens = new ArrayList<>();
        byte[] octets;
        try (RandomAccessFile f = new RandomAccessFile(fichier.toFile(), "r")) {
            octets = new byte[(int) Math.min(f.length(), QUEUE_MAX)];
            f.seek(f.length() - octets.length);
            f.readFully(octets);
        }
        ByteBuffer queue = ByteBuffer.wrap(octets).order(ByteOrder.LITTLE_ENDIAN);
        int fin = octets.length - FIN;
        while (fin >= 0 && queue.getInt(fin) != SIGNATURE_DE_FIN) {
            fin--;
        }
        int p = fin < 0 ? octets.length : Math.max(0, fin - queue.getInt(fin + 12));
        while (p + ENTREE <= octets.length && queue.getInt(p) == SIGNATURE_D_ENTREE) {
            liens.add((queue.getShort(p + 40) & SORTE) == LIEN);
            p += ENTREE + queue.getChar(p + 28) + queue.getChar(p + 30) + queue.getChar(p + 32);
        }
        return liens;
    }

    @Override
    public void close() throws IOException {
        zip.close();
    }
}
