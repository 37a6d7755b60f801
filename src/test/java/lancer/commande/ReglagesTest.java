package lancer.commande;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import lancer.contrat.Modele;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.scene.SectionLue;
import org.junit.jupiter.api.Test;

/** La façon de dessiner est une valeur : égale à une autre si elle donne la même image, et écrite en options. */
class ReglagesTest {

    private static final class Gris implements Variante {
        @Override
        public String getSection() {
            return "Gris";
        }

        @Override
        public void installer(Section valeurs, Modele.Construction modele) {
            valeurs.reel("part", 1, 0, 1);
        }
    }

    private final Variante gris = new Gris();
    private final Reglages lus = Options.lire().pour(lues(gris, "part", "0.5"));

    private static Map<Variante, Section> lues(Variante variante, String... clesEtValeurs) {
        return Map.of(variante, new SectionLue("Gris", clesEtValeurs));
    }

    @Test
    void deuxReglagesSontEgauxSiChacunDeLeursReglagesLEst() {
        Section autre = new SectionLue("Gris", "part", "0.25");
        Reglages[] changes = {lus.avec(Option.ETAPE, Etape.OMBRES), lus.avec(Option.REFLETS, 2), lus.avec(Option.SEUIL, 0.0),
            lus.avec(Option.SIMPLE, true), lus.avecVariante(gris, false), lus.avecSection(gris, autre)};
        for (Reglages change : changes) {
            assertNotEquals(lus, change);
        }
        assertEquals(lus, lus.avec(Option.ETAPE, Etape.OMBRES).avec(Option.ETAPE, Etape.REFLETS));
        assertEquals(lus, lus.avecVariante(gris, false).avecVariante(gris, true));
        assertEquals(lus, lus.avecSection(gris, autre).avecSection(gris, new SectionLue("Gris", "part", "0.5")));
        assertEquals(lus.avec(Option.SANS, Option.SANS.lire("gris")), lus.avecVariante(gris, false), "quelle que soit la casse");
        assertEquals(lus.avec(Option.SANS, Option.SANS.lire("gris")).hashCode(), lus.avecVariante(gris, false).hashCode());
        assertEquals(lus, Options.lire().pour(lues(gris, "part", "0.5")), "une autre lecture du même fichier");
    }

    @Test
    void lesOptionsEcritesRedonnentLesReglages() {
        Reglages[] tous = {Options.lire(), Options.lire().avec(Option.ETAPE, Etape.PHONG).avec(Option.REFLETS, 7),
            Options.lire().avec(Option.SEUIL, 0.25).avec(Option.SIMPLE, true),
            Options.lire().avec(Option.SANS, Option.SANS.lire("Brume,Blinn"))};
        for (Reglages ecrits : tous) {
            String options = ecrits.getOptions().trim();
            assertEquals(ecrits, Options.lire(options.isEmpty() ? new String[0] : options.split(" ")), options);
        }
    }

    @Test
    void aUneRelectureUneSectionChangeeResteSiLeFichierNAPasChangeLaSienne() {
        Section changee = new SectionLue("Gris", "part", "0.75");
        Reglages changes = lus.avecSection(gris, changee).avec(Option.REFLETS, 2);
        Reglages gardes = changes.pour(lues(gris, "part", "0.5"));
        assertEquals("[[Gris] part=0.75]", gardes.getSectionsChangees().toString());
        assertEquals(changes, gardes);
        Reglages perdus = changes.pour(lues(gris, "part", "0.1"));
        assertEquals("[Gris] part=0.1", perdus.getSection(gris).toString());
        assertTrue(perdus.getSectionsChangees().isEmpty());
        assertEquals(2, perdus.get(Option.REFLETS));
    }

    @Test
    void seuleUneVarianteBrancheeAbsenteDuFichierEtQuiProposeDesSectionsEstEssayee() {
        assertNull(lus.getEssayee());
        Variante proposeuse = new Variante() {
            @Override
            public String getSection() {
                return "Proposeuse";
            }

            @Override
            public void installer(Section valeurs, Modele.Construction modele) {
            }

            @Override
            public Map<Section, Double> getSectionsProposees(Section sienne) {
                return Map.of(sienne.sansFichier("n", "2"), 0.5);
            }
        };
        Reglages absente = Options.lire().pour(Map.of(proposeuse, new SectionLue("Proposeuse")));
        assertEquals(proposeuse, absente.getEssayee());
        assertNull(absente.avecVariante(proposeuse, false).getEssayee());
    }
}
