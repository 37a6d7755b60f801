package lancer.limites;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Map;
import lancer.essai.Defauts;
import lancer.essai.Essai;
import lancer.image.Comparaison;
import lancer.image.ImageMemoire;
import lancer.image.LectureImage;
import org.junit.jupiter.api.Test;

/** Les treize défauts que montre docs/stabilite.md. */
class DefautsTest {

    @Test
    void chaqueDefautSeVoitAutantQueLeDitLaPageEtLeProgrammeNEnAAucun() throws IOException {
        String page = Essai.texte("docs/stabilite.md");
        for (Defauts.Defaut defaut : new Defauts().tous()) {
            int faux = defaut.faux(defaut.naive);
            assertTrue(faux > 0 && page.contains("| " + defaut.nom + " | " + faux + " |"), defaut.nom + " : " + faux);
            assertEquals(0, defaut.faux(defaut.programme), defaut.nom);
        }
    }

    /** À un niveau près : les fonctions de Java n'arrondissent pas de même sur toutes les machines. */
    @Test
    void lesImagesDeLaPageSontCellesDesDefauts() throws IOException {
        String page = Essai.texte("docs/stabilite.md");
        for (Map.Entry<String, ImageMemoire> image : Defauts.dessiner().entrySet()) {
            String fichier = "images/" + image.getKey();
            assertTrue(page.contains(fichier), fichier);
            Comparaison comparaison = new Comparaison(image.getValue(), LectureImage.lire(fichier), 1, 0);
            assertTrue(comparaison.sontPareilles(), fichier + " : make -f outils/Makefile images le refait ; " + comparaison);
        }
    }
}
