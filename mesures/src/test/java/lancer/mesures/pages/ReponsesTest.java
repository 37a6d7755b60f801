package lancer.mesures.pages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lancer.image.Comparaison;
import lancer.image.ImageMemoire;
import lancer.image.LectureImage;
import org.junit.jupiter.api.Test;

/** docs/reponses.md et ses figures. */
class ReponsesTest {

    private static String lire(String fichier) throws IOException {
        return Files.readString(Path.of("..", fichier));
    }

    @Test
    void lesNombresDeLaPageSontCeuxDuProgramme() throws IOException {
        String page = lire("docs/reponses.md");
        assertEquals(PagesMesurees.remplacer(page, Reponses.valeurs()), page, "make -f outils/Makefile reponses");
    }

    @Test
    void lesFiguresSontCellesDuProgramme() throws IOException {
        assertEquals(Reponses.cosinus(), lire("images/reponses-cosinus.svg"), "make -f outils/Makefile reponses");
        memes(Reponses.etapes(), "images/reponses-etapes.png");
        memes(Reponses.escaliers(), "images/reponses-escaliers.png");
    }

    /** À un niveau près : les fonctions de Java n'arrondissent pas de même sur toutes les machines. */
    private static void memes(ImageMemoire attendue, String fichier) {
        Comparaison comparaison = new Comparaison(attendue, LectureImage.lire("../" + fichier), 1, 0);
        assertTrue(comparaison.sontPareilles(), fichier + " n'est plus du programme (make -f outils/Makefile reponses) : " + comparaison);
    }
}
