package lancer.mesures.pages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import lancer.image.Comparaison;
import lancer.image.ImageMemoire;
import lancer.image.LectureImage;
import org.junit.jupiter.api.Test;

/** Les nombres des pages, et docs/reponses.md avec ses figures. */
class ReponsesTest {

    @Test
    void lesNombresViennentDesMesuresEtLeTexteAutourNeBougePas() {
        assertEquals("un <!--v:a-->2,1<!--/v--> deux <!--v:a-->2,1<!--/v-->",
                PagesMesurees.remplacer("un <!--v:a-->0<!--/v--> deux <!--v:a--><!--/v-->", Map.of("a", "2,1")));
        assertEquals("$1 \\", PagesMesurees.remplacer("$1 \\", Map.of()));
        IllegalArgumentException faute = assertThrows(IllegalArgumentException.class,
                () -> PagesMesurees.remplacer("<!--v:b-->0<!--/v-->", Map.of("a", "1")));
        assertTrue(faute.getMessage().contains("« b »"), faute.getMessage());
    }

    @Test
    void unNombreNEstJamaisSepareDeCeQuiLAccompagne() {
        assertEquals("<!--v:a-->«~partage~» (8~; 0,06)~: ×~4,5, de −~5~% à +~2~%<!--/v-->", PagesMesurees.remplacer("<!--v:a--><!--/v-->",
                Map.of("a", "« partage » (8 ; 0,06) : × 4,5, de − 5 % à + 2 %")).replace('\u00a0', '~'));
    }

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
