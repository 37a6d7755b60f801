package lancer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import lancer.contrat.Echantillonnage;
import lancer.essai.Defauts;
import org.junit.jupiter.api.Test;

/** Les treize défauts que montre docs/stabilite.md. */
class DefautsTest {

    /** La moyenne de neuf points, sans rien d'autre. */
    private static final Echantillonnage NEUF_POINTS = (pave, vue, toile) -> {
        for (int j = pave.j0; j < pave.j1; j++) {
            for (int i = pave.i0; i < pave.i1; i++) {
                Couleur somme = new Couleur();
                for (int k = 0; k < 9; k++) {
                    somme = somme.add(vue.couleur(i + 0.5 + (k % 3 - 1) / 3.0, j + 0.5 + (k / 3 - 1) / 3.0));
                }
                toile.drawPixel(somme.div(9), i, j);
            }
        }
        return 0;
    };

    @Test
    void chaqueDefautSeVoitEtLeProgrammeNEnAAucun() {
        for (Defauts.Defaut defaut : new Defauts(NEUF_POINTS).tous()) {
            assertTrue(defaut.faux(defaut.naive) > 0, defaut.nom);
            assertEquals(0, defaut.faux(defaut.programme), defaut.nom);
        }
    }
}
