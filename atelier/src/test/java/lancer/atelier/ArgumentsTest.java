package lancer.atelier;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** La ligne de commande des mesures. */
class ArgumentsTest {

    private static final String USAGE = "[--seule | --autre] [--valeur V] [FICHIER]...";

    @Test
    void lesOptionsOntLeurValeurEtLesNomsSuivent() {
        Arguments a = new Arguments(USAGE, true, "un", "--valeur", "3", "--seule", "deux");
        assertTrue(a.a("--seule") && a.a("--valeur"));
        assertFalse(a.a("--autre"));
        assertEquals("3", a.valeur("--valeur", "0"));
        assertEquals("", a.valeur("--autre", ""));
        assertEquals(Arrays.asList("un", "deux"), a.restes);
    }

    @Test
    void uneFauteDitLaquelleEtLUsage() {
        for (String[] faute : new String[][] {{"--inconnue", "option inconnue : « --inconnue » ; usage : " + USAGE},
            {"--valeur", "option sans sa valeur : --valeur ; usage : " + USAGE},
            {"--seule --seule", "option donnée deux fois : --seule"}}) {
            assertEquals(faute[1], assertThrows(IllegalArgumentException.class, () -> new Arguments(USAGE, true, faute[0].split(" ")))
                    .getMessage());
        }
        assertThrows(IllegalArgumentException.class, () -> new Arguments(USAGE, false, "un"));
    }
}
