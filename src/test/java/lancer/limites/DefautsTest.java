package lancer.limites;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.List;
import lancer.Couleur;
import lancer.contrat.Echantillonnage;
import lancer.essai.Defauts;
import org.junit.jupiter.api.Test;

/** Les treize défauts que montre docs/stabilite.md. */
class DefautsTest {

    /** La moyenne de neuf points, sans rien d'autre. */
    private static final Echantillonnage NEUF_POINTS = (pave, voulus, vue, toile) -> {
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
    void chaqueDefautSeVoitAutantQueLeDitLaPageEtLeProgrammeNEnAAucun() throws IOException {
        List<String> page = Files.readAllLines(Paths.get("docs/stabilite.md"));
        for (Defauts.Defaut defaut : new Defauts(NEUF_POINTS).tous()) {
            int faux = defaut.faux(defaut.naive);
            assertTrue(faux > 0 && page.contains("| " + defaut.nom + " | " + faux + " |"), defaut.nom + " : " + faux);
            assertEquals(0, defaut.faux(defaut.programme), defaut.nom);
        }
    }
}
