package lancer.mesures.pages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les nombres des pages. */
class PagesMesureesTest {

    @TempDir
    Path dossier;

    @Test
    void ilsViennentDesMesuresEtLeTexteAutourNeBougePas() {
        assertEquals("un <!--v:a-->2,1<!--/v--> deux <!--v:a-->2,1<!--/v-->",
                PagesMesurees.remplacer("un <!--v:a-->0<!--/v--> deux <!--v:a--><!--/v-->", Map.of("a", "2,1")));
        assertEquals("$1 \\", PagesMesurees.remplacer("$1 \\", Map.of()));
    }

    @Test
    void unNombreNEstJamaisSepareDeCeQuiLAccompagne() {
        assertEquals("<!--v:a-->«~partage~» (8~; 0,06)~: ×~4,5, de −~5~% à +~2~%<!--/v-->", PagesMesurees.remplacer("<!--v:a--><!--/v-->",
                Map.of("a", "« partage » (8 ; 0,06) : × 4,5, de − 5 % à + 2 %")).replace('\u00a0', '~'));
    }

    @Test
    void ceuxQuiNeViennentDAucuneMesureSontRefuses() {
        IllegalArgumentException faute = assertThrows(IllegalArgumentException.class,
                () -> PagesMesurees.remplacer("<!--v:b-->0<!--/v-->", Map.of("a", "1")));
        assertTrue(faute.getMessage().contains("« b »"), faute.getMessage());
    }
}
