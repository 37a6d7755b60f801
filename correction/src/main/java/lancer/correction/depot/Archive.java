package lancer.correction.depot;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;

/** Une archive zip, lue sans rien écrire : ses entrées dans l'ordre, dont on sait si ce sont des liens. */
final class Archive implements AutoCloseable {

    private static final int LIEN = 0xA000;
    private static final int SORTE = 0xF000;

    private final ZipFile zip;
    private final List<Entree> entrees = new ArrayList<>();

    /** @throws IOException si ce n'est pas une archive zip lisible */
    Archive(Path fichier) throws IOException {
        zip = ouvrir(fichier.toFile());
        List<Boolean> liens = liens(fichier);
        zip.stream().forEach(e -> entrees.add(entree(e, entrees.size() < liens.size() && liens.get(entrees.size()))));
    }

    private static ZipFile ouvrir(File fichier) throws IOException {
        try {
            return new ZipFile(fichier, StandardCharsets.UTF_8);
        } catch (ZipException e) {
            // des noms qui ne sont pas de l'UTF-8 : leurs lettres sans accent se lisent quand même
            return new ZipFile(fichier, StandardCharsets.ISO_8859_1);
        }
    }

    private Entree entree(ZipEntry e, boolean lien) {
        // des « / » même si l'archive vient de Windows
        return new Entree(e.getName().replace('\\', '/'), lien, e.getSize()) {
            @Override
            InputStream ouvrir() throws IOException {
                return zip.getInputStream(e);
            }
        };
    }

    List<Entree> entrees() {
        return entrees;
    }

    /** Ce que java.util.zip ne dit pas : les droits Unix, dans le répertoire central (PKWARE, APPNOTE, § 4.3.12). */
    private static List<Boolean> liens(Path fichier) throws IOException {
        List<Boolean> liens = new ArrayList<>();
        try (RandomAccessFile f = new RandomAccessFile(fichier.toFile(), "r")) {
            long fin = f.length();
            int portee = (int) Math.min(fin, 22 + 0xFFFF);
            byte[] queue = new byte[portee];
            f.seek(fin - portee);
            f.readFully(queue);
            int fiche = portee - 22;
            while (fiche >= 0 && entier(queue, fiche, 4) != 0x06054b50L) {
                fiche--;
            }
            byte[] tete = new byte[46];
            for (long p = fiche < 0 ? fin : Math.max(0, fin - portee + fiche - entier(queue, fiche + 12, 4)); p + tete.length <= fin;) {
                f.seek(p);
                f.readFully(tete);
                if (entier(tete, 0, 4) != 0x02014b50L) {
                    break;
                }
                liens.add(((entier(tete, 38, 4) >>> 16) & SORTE) == LIEN);
                p += tete.length + entier(tete, 28, 2) + entier(tete, 30, 2) + entier(tete, 32, 2);
            }
        }
        return liens;
    }

    private static long entier(byte[] octets, int debut, int longueur) {
        long n = 0;
        for (int k = longueur - 1; k >= 0; k--) {
            n = n << 8 | octets[debut + k] & 0xFF;
        }
        return n;
    }

    @Override
    public void close() throws IOException {
        zip.close();
    }
}
