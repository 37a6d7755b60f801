package lancer.fenetre.vue.figures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.util.Arrays;
import java.util.List;
import lancer.commande.Option;
import lancer.commande.Options;
import lancer.dessin.Durees;
import lancer.fenetre.etat.Essai;
import org.junit.jupiter.api.Test;

/** Les temps d'un réglage, et la place que la figure de F3 lui donne. */
class EssaiTest {

    private static Essai essai(int reflets, double erreur, double... secondes) {
        return new Essai(Options.lire().avec(Option.REFLETS, reflets),
                new Durees(Arrays.stream(secondes).mapToLong(t -> Math.round(t * 1e9)).toArray()), erreur, 0.1);
    }

    @Test
    void unTempsEstLaMedianeDeLaSecondeMoitieAvecSonIntervalle() {
        Essai essai = essai(1, 2, 90, 80, 70, 3, 1, 2);
        assertEquals("2,000 s (de 1,000 à 3,000), erreur de 2,00 ± 0,10 niveaux", essai.dire());
        assertEquals("1,000 s (de 1,000 à 1,000), aucun écart vu", essai(1, 0, 1).dire());
        double[] longs = new double[60];
        Arrays.setAll(longs, k -> k);
        Durees souvent = essai(1, 2, longs).durees;
        assertEquals(44.5e9, souvent.getMediane());
        assertTrue(souvent.getMin() > 38e9 && souvent.getMax() < 51e9, "l'intervalle de la médiane se resserre");
    }

    @Test
    void unReglageEstAssezDessineApresTroisFoisEtUneSecondeEtDemieOuQuaranteFois() {
        assertFalse(essai(1, 2, 3, 3).suffit());
        assertTrue(essai(1, 2, 3, 3, 3).suffit());
        assertFalse(essai(1, 2, new double[39]).suffit());
        assertTrue(essai(1, 2, new double[40]).suffit());
    }

    /** L'abscisse où se désigne ce réglage, du premier au dernier. */
    private static int[] abscisses(List<Essai> essais) {
        GraphiqueVitesse graphique = new GraphiqueVitesse();
        graphique.setSize(420, 400);
        graphique.montrer(essais, essais.get(0).reglages, null);
        int[] places = new int[essais.size()];
        for (int x = 0; x < 420; x++) {
            for (int y = 0; y < 400; y++) {
                if (graphique.sous(new Point(x, y)) != null) {
                    places[essais.indexOf(graphique.sous(new Point(x, y)))] = x;
                }
            }
        }
        return places;
    }

    @Test
    void chaqueReglageEstASaMedianeEtLesAxesVontDuPremierAuDernier() {
        Essai un = essai(0, 30, 1, 1, 1.1, 1.1);
        Essai deux = essai(1, 3, 1, 1, 1.2, 1.2);
        Essai trois = essai(2, 0.5, 1, 1, 4, 4);
        int[] places = abscisses(Arrays.asList(un, deux, trois));
        assertTrue(places[0] < places[1] && places[1] < places[2], "même si leurs intervalles se touchent : " + Arrays.toString(places));
        assertEquals(Math.log(1.2 / 1.1) / Math.log(4 / 1.1), (places[1] - places[0]) / (double) (places[2] - places[0]), 0.02);
        assertTrue(places[2] - places[0] > 250, "les points prennent la place : " + Arrays.toString(places));
    }

    @Test
    void lesFlechesVontDUnPointAuSuivantSansSortir() {
        List<Essai> essais = Arrays.asList(essai(2, 0.5, 4), essai(0, 30, 1), essai(1, 3, 2));
        assertEquals(essais.get(1), voisin(essais, null, 1), "le plus rapide d'abord");
        assertEquals(essais.get(2), voisin(essais, essais.get(1), 1));
        assertEquals(essais.get(0), voisin(essais, essais.get(0), 1));
        assertEquals(essais.get(1), voisin(essais, essais.get(1), -1));
    }

    private static Essai voisin(List<Essai> essais, Essai vise, int pas) {
        GraphiqueVitesse graphique = new GraphiqueVitesse();
        graphique.montrer(essais, essais.get(0).reglages, vise == null ? null : vise.reglages);
        return graphique.voisin(pas);
    }

    @Test
    void leNombreDeDessinsQuiSuffirontSuitLeTempsDesPremiers() {
        assertEquals(3, new Essai(essai(1, 2, 1).reglages, new Durees(), 0, 0).getVoulus());
        assertEquals(3, essai(1, 2, 10).getVoulus());
        assertEquals(15, essai(1, 2, 0.1, 0.1).getVoulus());
        assertEquals(40, essai(1, 2, 0.001).getVoulus());
    }

    @Test
    void uneMachineOccupeeSeVoitAUnTempsQuiVarieDePlusDeTrentePourCent() {
        assertFalse(essai(1, 2, 9, 9, 1, 1.2).varie());
        assertTrue(essai(1, 2, 9, 9, 1, 1.4).varie());
    }
}
