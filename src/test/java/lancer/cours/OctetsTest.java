package lancer.cours;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.Objet3D;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** La taille du code compilé, là où elle décide de la vitesse. */
class OctetsTest {

    /**
     * Une méthode de moins d'octets est insérée là où elle est appelée ({@code FreqInlineSize} de HotSpot). Insérée dans elle-même par
     * ses reflets, {@code getColor} serait compilée plus longtemps, et une scène de dix boules dessinée un quart plus lentement. Insérées
     * dans les deux boucles, celles de la recherche retarderaient de même une première image de trente boules.
     */
    private static final int TAILLE_INSEREE = 325;

    @ParameterizedTest
    @CsvSource({"lancer.Objet3D, Couleur getColor", "lancer.rapide.Question, void chercher", "lancer.rapide.Question, boolean ouvrir"})
    void lesMethodesQuiColorentEtQuiCherchentSontTropLonguesPourEtreInserees(String classe, String methode) throws Exception {
        Path classes = Paths.get(Objet3D.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        Path java = Paths.get(System.getProperty("java.home"), "bin", "javap");
        Process javap = new ProcessBuilder(java.toString(), "-c", "-p", "-cp", classes.toString(), classe).start();
        java.io.ByteArrayOutputStream dit = new java.io.ByteArrayOutputStream();
        byte[] lu = new byte[1 << 16];
        for (int n = javap.getInputStream().read(lu); n >= 0; n = javap.getInputStream().read(lu)) {
            dit.write(lu, 0, n);
        }
        String texte = new String(dit.toByteArray(), StandardCharsets.UTF_8);
        Matcher fin = Pattern.compile(methode + "\\((?s:.*?)(\\d+): [ai]?return\n(?:\n|})").matcher(texte);
        assertTrue(fin.find(), texte);
        assertTrue(Integer.parseInt(fin.group(1)) >= TAILLE_INSEREE, fin.group(1));
    }
}
