package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** La mesure d'une scène. */
class MesureTest {

    private static Mesure mesure(long spheres, long temps) {
        return Mesure.faite(new long[] {spheres, 10, 20, 30, 40, 50, 60, 70}, temps);
    }

    @ParameterizedTest(name = "de {0} sphères en {1} à {2} sphères en {3} : {4}")
    @CsvSource({"8, 100, 64, 100, 0", "8, 100, 64, 800, 1", "2, 100, 8, 200, 0.5", "4, 800, 32, 100, -1"})
    void laCroissanceEstLExposantDuTemps(long n1, long t1, long n2, long t2, double exposant) {
        assertEquals(exposant, mesure(n2, t2).croissance(mesure(n1, t1)), 1e-15);
    }

    @Test
    void lesRayonsSontDeTroisSortes() {
        Mesure mesure = mesure(3, 500);
        assertEquals(60, mesure.rayons());
        assertEquals(60 / 500e-9, mesure.rayonsParSeconde(), 1);
    }

    @Test
    void uneMesurePasseEnUneLigneDUneMachineVirtuelleALAutre() {
        Mesure lue = Mesure.lire(Mesure.faite(new long[] {1, 2, 3, 4, 5, 6, 7, 8}, 30, 10, 20).toString());
        assertEquals(Mesure.Issue.MESUREE, lue.issue);
        assertEquals("MESUREE 1 2 3 4 5 6 7 8 30 10 20", lue.toString());
        assertEquals("1 2 3 4 5 6 7 8", lue.spheres + " " + lue.primaires + " " + lue.ombre + " " + lue.reflechis + " "
                + lue.pixelsVerifies + " " + lue.lectureNs + " " + lue.preparationNs + " " + lue.premiereNs);
        assertEquals(20, lue.temps.mediane());
        Mesure sautee = Mesure.lire(Mesure.sautee("trop  chère : 3 h").toString());
        assertEquals(Mesure.Issue.SAUTEE, sautee.issue);
        assertEquals("trop  chère : 3 h", sautee.raison);
        Mesure fautive = Mesure.lire(Mesure.fautive("image fausse").toString());
        assertEquals(Mesure.Issue.FAUTIVE, fautive.issue);
        assertEquals("image fausse", fautive.raison);
    }

    @ParameterizedTest(name = "« {0} »")
    @ValueSource(strings = {"", "MESUREE", "MESUREE 1 2 3 4 5 6 7 8", "MESUREE 1 2 3 4 5 6 7 8 neuf", "bonjour"})
    void uneLigneVenueDAilleursEstUneFaute(String ligne) {
        Mesure lue = Mesure.lire(ligne);
        assertEquals(Mesure.Issue.FAUTIVE, lue.issue);
        assertTrue(lue.raison.startsWith("mesure illisible"), lue.raison);
    }
}
