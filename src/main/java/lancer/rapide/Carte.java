package lancer.rapide;

import java.util.Arrays;
import lancer.contrat.Recherche;

/**
 * Les enveloppes vues d'un point, notées par case de direction (« light buffer », Haines et Greenberg, 1986). Chaque
 * case donne, de la plus proche à la plus lointaine, celles qui s'y voient.
 */
final class Carte {

    /** Nombre d'objets d'une case au-delà duquel elle est pleine : l'arbre la remplace. */
    private static final int PLEINE = 30;

    final PointDeVue point;

    /** Première place de chaque case ; celle de la suivante est sa fin. */
    final int[] debut;

    /** Le rang d'un objet pour chaque place, et pour chaque rang une borne inférieure de sa distance au point. */
    int[] objets;
    final float[] pres;

    private Carte(PointDeVue point, Enveloppes enveloppes) {
        this.point = point;
        debut = new int[point.nombre + 1];
        pres = new float[enveloppes.objets.length];
    }

    /**
     * La carte de ce point.
     *
     * @param places nombre maximal de places
     * @return {@code null} s'il en faut davantage
     */
    static Carte de(PointDeVue point, Enveloppes enveloppes, int places) {
        Carte carte = new Carte(point, enveloppes);
        double[] g = enveloppes.geometrie;
        long[] ordre = new long[enveloppes.bornes.length];
        for (int o = 0; o < ordre.length; o++) {
            int k = enveloppes.bornes[o];
            carte.pres[k] = point.auMoins(g, k);
            // la moitié haute, positive, donne l'ordre
            ordre[o] = (long) Float.floatToRawIntBits(carte.pres[k]) << Integer.SIZE | k;
        }
        Arrays.sort(ordre);
        Rangs vus = new Rangs();
        Rangs cases = new Rangs();
        for (long o : ordre) {
            Recherche.obeir();
            point.chercher(g, (int) o, cases);
            while (vus.nombre < cases.nombre) {
                vus.ajouter((int) o);
            }
            if (cases.nombre > places) {
                return null;
            }
        }
        carte.ranger(vus, cases);
        return carte;
    }

    /** Range ces objets par case, sans changer l'ordre de ceux d'une case. */
    private void ranger(Rangs vus, Rangs cases) {
        for (int e = 0; e < cases.nombre; e++) {
            debut[cases.rangs[e]]++;
        }
        for (int c = 1; c < debut.length; c++) {
            debut[c] += debut[c - 1];
        }
        objets = new int[vus.nombre];
        for (int e = cases.nombre - 1; e >= 0; e--) {
            objets[--debut[cases.rangs[e]]] = vus.rangs[e];
        }
    }

    /** Dit si cette case a trop d'objets. */
    boolean estPleine(int c) {
        return debut[c + 1] - debut[c] > PLEINE;
    }
}
