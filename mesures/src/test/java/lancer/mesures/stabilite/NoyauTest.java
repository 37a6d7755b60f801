package lancer.mesures.stabilite;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Ce qui se chronomètre d'une intersection. */
class NoyauTest {

    @Test
    void uneMethodeQuiSeTrompeNEstPasMesuree() {
        for (Formule formule : Formule.values()) {
            Noyau.verifier(formule, Regime.ORDINAIRE);
        }
        IllegalStateException refus = assertThrows(IllegalStateException.class, () -> Noyau.verifier(Formule.MANUEL, Regime.LOIN));
        assertTrue(refus.getMessage().contains("aucun temps"), refus.getMessage());
    }

    @Test
    void leNoyauSommeLesPlusPetitesDistancesDeSonRegime() {
        double programme = new Noyau(Formule.PROGRAMME, Regime.SOL).tour();
        double moyenne = programme * Noyau.ENSEMBLE / Noyau.RAYONS;
        assertTrue(moyenne > 0.5 && moyenne < 2, "un œil à hauteur 1 : " + moyenne);
        assertEquals(programme, new Noyau(Formule.COMPENSEE, Regime.SOL).tour(), 1e-11);
    }
}
