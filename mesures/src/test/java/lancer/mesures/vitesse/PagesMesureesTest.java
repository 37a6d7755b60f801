package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Map;
import lancer.mesures.stabilite.Stabilite;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les nombres des pages. */
class PagesMesureesTest {

    private static final Path RESULTATS = Faux.projet("mesures/resultats");

    @TempDir
    Path dossier;

    @Test
    void ilsViennentDesMesuresEtLeTexteAutourNeBougePas() {
        assertEquals("un <!--v:a-->2,1<!--/v--> deux <!--v:a-->2,1<!--/v-->",
                PagesMesurees.remplacer("un <!--v:a-->0<!--/v--> deux <!--v:a--><!--/v-->", Collections.singletonMap("a", "2,1")));
        assertEquals("$1 \\", PagesMesurees.remplacer("$1 \\", Collections.emptyMap()));
    }

    @Test
    void ceuxQuiNeViennentDAucuneMesureSontRefuses() {
        IllegalArgumentException faute = assertThrows(IllegalArgumentException.class,
                () -> PagesMesurees.remplacer("<!--v:b-->0<!--/v-->", Collections.singletonMap("a", "1")));
        assertTrue(faute.getMessage().contains("« b »"), faute.getMessage());
    }

    @Test
    void unePageNEstReecriteQueSIlsChangent() throws IOException {
        Path page = dossier.resolve("page.md");
        Files.write(page, "<!--v:a-->0<!--/v-->\n".getBytes(StandardCharsets.UTF_8));
        PagesMesurees.reecrire(page, Collections.singletonMap("a", "1"));
        assertEquals("<!--v:a-->1<!--/v-->\n", new String(Files.readAllBytes(page), StandardCharsets.UTF_8));
        PagesMesurees.reecrire(dossier.resolve("absente.md"), Collections.emptyMap());
    }

    @Test
    void ceuxDeCeProjetSontCeuxDeMesuresResultats() throws IOException {
        Map<String, String> valeurs = Stabilite.pages(RESULTATS);
        valeurs.putAll(new Chiffres(new Releves(new Journal(RESULTATS.resolve(Ouvrier.CSV)).lire()),
                TableBesoins.lire(RESULTATS.resolve("besoins.csv"))).get());
        for (Path relative : Rapport.PAGES) {
            Path page = Faux.projet(relative.toString());
            String texte = new String(Files.readAllBytes(page), StandardCharsets.UTF_8);
            assertTrue(texte.contains("<!--v:"), page + " montre des mesures");
            assertEquals(PagesMesurees.remplacer(texte, valeurs), texte, page + " : make mesures, ou MESURES=--dessiner, le réécrit");
        }
    }

    @Test
    void ceuxDuTableauDesBesoinsSontCeuxDeSonCsv() throws IOException {
        assertEquals(TableBesoins.markdown(TableBesoins.lire(RESULTATS.resolve("besoins.csv"))),
                new String(Files.readAllBytes(RESULTATS.resolve("besoins.md")), StandardCharsets.UTF_8));
    }

    @Test
    void lesCourbesMontreesExistent() throws IOException {
        for (Path relative : Rapport.PAGES) {
            Path page = Faux.projet(relative.toString());
            java.util.regex.Matcher m = java.util.regex.Pattern.compile("[(\"]([^()\"\\s]*resultats/[^()\"\\s]*\\.png)[)\"]")
                    .matcher(new String(Files.readAllBytes(page), StandardCharsets.UTF_8));
            int courbes = 0;
            while (m.find()) {
                Path courbe = page.toAbsolutePath().resolveSibling(m.group(1)).normalize();
                assertTrue(Files.exists(courbe), page + " montre " + courbe);
                courbes++;
            }
            assertTrue(courbes > 0, page + " montre des courbes");
        }
    }
}
