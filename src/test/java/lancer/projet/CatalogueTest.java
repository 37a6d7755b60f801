package lancer.projet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.essai.Essai;
import org.junit.jupiter.api.Test;

/** {@code docs/stabilite-cas.md} n'oublie aucune des façons de se tromper ; que ses tests existent, {@link FormeTest} le demande. */
class CatalogueTest {

    private static final int FACONS = 50;
    private static final Pattern ESSAI = Pattern.compile("`(\\w*Tests?)\\.(\\w+)`");
    private static final Pattern RANGEE = Pattern.compile("(?m)^\\| (\\d+) \\|.*$");

    @Test
    void chaqueFaconDeSeTromperASonTestOuUnePhraseQuiDitPourquoiElleNePeutPasArriver() throws IOException {
        Matcher m = RANGEE.matcher(Essai.texte("docs/stabilite-cas.md"));
        int derniere = 0;
        while (m.find()) {
            assertEquals(++derniere, Integer.parseInt(m.group(1)), "l'ordre des rangées");
            assertTrue(ESSAI.matcher(m.group()).find() || m.group().contains("Ne peut pas arriver"), m.group());
        }
        assertEquals(FACONS, derniere);
    }
}
