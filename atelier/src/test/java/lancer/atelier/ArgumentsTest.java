package lancer.atelier;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

/** La ligne de commande des mesures. */
class ArgumentsTest {

    private static final String USAGE = "[--seule | --autre] [--valeur V] [FICHIER]...";

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
