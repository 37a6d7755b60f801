package lancer.scene;

import static lancer.essai.Triplets.t;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.Sphere;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Des fichiers au hasard : une scène dans les limites, ou une {@link SceneFautive} d'une ligne ; jamais autre chose. Pour refaire
 * un essai qui échoue : {@code Abimeur.deToutesLesScenes().fichier(graine)}.
 */
@Timeout(value = 10, unit = TimeUnit.MINUTES, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class LectureAleatoireTest {

    private static final int ESSAIS = 10_000;

    /** fichier[, ligne N][, [section]][, clé] : faute ; attendu : quoi. */
    private static final Pattern MESSAGE = Pattern.compile("(?:, ligne ([0-9]+))?((?:, \\[.*\\])?(?:, .*)?) : (.+) ; attendu : (.+)");

    /** Le nom du fichier à part, rien de ce qui s'y cite ne dépasse soixante caractères. */
    private static final int MESSAGE_MAX = 500;

    @TempDir
    Path dossier;
    private Abimeur abimeur;
    private Path fichier;

    @BeforeEach
    void prendreLesVraiesScenes() throws IOException {
        abimeur = Abimeur.deToutesLesScenes();
        fichier = dossier.resolve("essai.ini");
    }

    @Test
    void unFichierAuHasardDonneUneSceneDansLesLimitesOuUneSceneFautiveDUneLigne() throws IOException {
        Set<String> fautes = new TreeSet<>();
        int acceptes = 0;
        for (long graine = 0; graine < ESSAIS; graine++) {
            byte[] octets = abimeur.fichier(graine);
            ecrire(octets);
            String cas = "graine " + graine;
            long avant = Memoire.demandee();
            try {
                Scene scene = new Scene(fichier.toString());
                acceptes++;
                verifierScene(scene, cas);
                assertDoesNotThrow(() -> StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(octets)), cas);
            } catch (SceneFautive e) {
                fautes.add(verifierMessage(e.getMessage(), octets, cas).split(" : ")[0]);
            } catch (RuntimeException | Error e) {
                throw new AssertionError(cas + " : " + e, e);
            }
            Memoire.verifier(avant, octets.length, cas);
        }
        // sans quoi ces essais ne diraient rien
        assertTrue(acceptes > ESSAIS / 20, acceptes + " scènes acceptées seulement");
        assertTrue(fautes.size() > 25, fautes.toString());
    }

    /** Sans passer par un fichier vide : après cela, certains disques attendent que tout soit écrit. */
    private void ecrire(byte[] octets) throws IOException {
        try (FileChannel canal = FileChannel.open(fichier, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
            canal.write(ByteBuffer.wrap(octets));
            canal.truncate(octets.length);
        }
    }

    /** Rend la faute que dit ce message. */
    private String verifierMessage(String message, byte[] octets, String cas) {
        String dit = cas + " : " + message;
        assertTrue(message.startsWith(fichier.toString()), dit);
        String reste = message.substring(fichier.toString().length());
        Matcher parties = MESSAGE.matcher(reste);
        assertTrue(parties.matches(), dit);
        assertFalse(Pattern.compile("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}]").matcher(reste).find(), dit);
        assertTrue(reste.length() <= MESSAGE_MAX, dit);
        int lignes = 1;
        for (byte octet : octets) {
            lignes += octet == '\n' || octet == '\r' ? 1 : 0;
        }
        int ligne = Integer.parseInt(parties.group(1));
        assertTrue(ligne >= 1 && ligne <= lignes, dit);
        return parties.group(3);
    }

    /** Ce que le format de scène permet, et rien au-delà. */
    private static void verifierScene(Scene scene, String cas) {
        for (Objet3D objet : scene.getObjets()) {
            Sphere sphere = (Sphere) objet;
            entre(-1e100, 1e100, cas, t(sphere.getCentre()));
            entre(1e-100, 1e100, cas, sphere.getRayon());
            entre(0, 1, cas, t(sphere.getKd()));
            entre(0, 1, cas, t(sphere.getKs()));
            entre(0, 1e9, cas, sphere.getNs());
        }
        for (Lampe lampe : scene.getLampes()) {
            entre(-1e100, 1e100, cas, t(lampe.getPosition()));
            entre(0, 1e6, cas, t(lampe.getCouleur()));
        }
    }

    private static void entre(double min, double max, String cas, double... valeurs) {
        for (double valeur : valeurs) {
            assertTrue(valeur >= min && valeur <= max, () -> cas + " : " + valeur + " n'est pas de " + min + " à " + max);
        }
    }
}
