package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Le fichier donné ligne par ligne, sans jamais être tout entier en mémoire. */
class LignesTest {

    /** Un flux qui rend ses octets par petits bouts, au hasard. */
    private static InputStream parBouts(byte[] octets, Random hasard) {
        return new ByteArrayInputStream(octets) {
            @Override
            public synchronized int read(byte[] cible, int position, int nombre) {
                return super.read(cible, position, Math.min(nombre, 1 + hasard.nextInt(4)));
            }
        };
    }

    /** Les lignes, chacune précédée du numéro qu'elle a quand elle est donnée. */
    private static List<String> lire(InputStream entree) throws IOException {
        List<String> lignes = new ArrayList<>();
        Lignes source = new Lignes(entree, 0, part -> { });
        char[] tampon = new char[10];
        StringBuilder s = new StringBuilder();
        for (int n = source.read(tampon, 0, 10); n >= 0; n = source.read(tampon, 0, 10)) {
            s.append(tampon, 0, n);
            if (s.charAt(s.length() - 1) == '\n') {
                lignes.add(source.getNumero() + ":" + s.substring(0, s.length() - 1));
                s.setLength(0);
            }
        }
        assertEquals(0, s.length(), "une ligne sans fin");
        return lignes;
    }

    private static List<String> lire(String texte) throws IOException {
        byte[] octets = texte.getBytes(StandardCharsets.UTF_8);
        List<String> lignes = lire(new ByteArrayInputStream(octets));
        for (int graine = 0; graine < 20; graine++) {
            assertEquals(lignes, lire(parBouts(octets, new Random(graine))), "graine " + graine);
        }
        return lignes;
    }

    private static void verifier(String texte, String... lignes) throws IOException {
        assertArrayEquals(lignes, lire(texte).toArray(), texte);
    }

    @Test
    void lesTroisFinsDeLigneSeValent() throws IOException {
        verifier("");
        verifier("a", "1:a");
        verifier("a\n", "1:a");
        verifier("a\r", "1:a");
        verifier("a\r\n", "1:a");
        verifier("a\nb\rc\r\nd", "1:a", "2:b", "3:c", "4:d");
        verifier("\n\r\r\n\n", "1:", "2:", "3:", "4:");
        verifier("é\r\nœ😀\r", "1:é", "2:œ😀");
    }

    @Test
    void laMarqueUtf8NEstOteeQuAuDebut() throws IOException {
        verifier("\ufeff", "1:");
        verifier("\ufeffa\n\ufeffb", "1:a", "2:\ufeffb");
        verifier("\ufeff\ufeffé", "1:\ufeffé");
    }

    @Test
    void unCommentaireEstDonneVide() throws IOException {
        verifier("; un\n \t# deux é\na ; b\n", "1:", "2:", "3:a ; b");
    }

    @Test
    void unCaractereDeControleEstDonneParSonCode() throws IOException {
        verifier("a\0\tb\u001b\n\f", "1:a\\u0000\tb\\u001b", "2:\\u000c");
        verifier("; \0\n\0;", "1:", "2:\\u0000;");
    }

    @Test
    void unOctetFauxEstRefuseASaLigne() {
        byte[] octets = "a\n; caf\u00e9\nb".getBytes(StandardCharsets.ISO_8859_1);
        Lignes lignes = new Lignes(new ByteArrayInputStream(octets), 0, part -> { });
        char[] tampon = new char[100];
        assertThrows(CharacterCodingException.class, () -> {
            while (lignes.read(tampon, 0, 100) >= 0) {
                assertEquals(1, lignes.getNumero());
            }
        });
        assertEquals(2, lignes.getNumero());
        assertEquals("; caf\ufffd", lignes.getTexte());
    }

    @Test
    void unFichierEnUtf16NEstPasDeLUtf8() throws IOException {
        for (String codage : new String[] {"UTF-16LE", "UTF-16BE"}) {
            byte[] octets = ("\uFEFF[Sphere 1]\r\ncentre=0 0 5").getBytes(codage);
            assertThrows(CharacterCodingException.class, () -> lire(new ByteArrayInputStream(octets)), codage);
        }
        verifier("\0\0\0\0\0", "1:\\u0000\\u0000\\u0000\\u0000\\u0000");
    }

    @Test
    void uneLigneTropLonguePourLeTamponEstDonneeEntiere() throws IOException {
        StringBuilder longue = new StringBuilder();
        for (int k = 0; k < 100_000; k++) {
            longue.append(k % 7 == 0 ? "é" : "x").append(k % 1000 == 0 ? "\u0001" : "");
        }
        List<String> lignes = lire(new ByteArrayInputStream(("a\n" + longue + "\nb").getBytes(StandardCharsets.UTF_8)));
        assertEquals(3, lignes.size());
        assertEquals("2:" + longue.toString().replace("\u0001", "\\u0001"), lignes.get(1));
        assertEquals("3:b", lignes.get(2));
    }
}
