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
    int[] objets = new int[16];
    final float[] pres;

    /** La case de chaque place, avant leur rangement, et nombre de places. */
    private int[] cases = new int[16];
    private int nombre;

    private Carte(PointDeVue point, Enveloppes enveloppes) {
        this.point = point;
        debut = new int[point.nombre + 1];
        pres = new float[enveloppes.objets.length];
    }

    /**
     * La carte de ce point.
     *
     * @param point {@code null} s'il n'en a pas
     * @param places nombre maximal de places
     * @return {@code null} s'il en faut davantage
     */
    static Carte de(PointDeVue point, Enveloppes enveloppes, int places) {
        if (point == null) {
            return null;
        }
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
        for (long o : ordre) {
            Recherche.obeir();
            point.cases(g, (int) o, c -> carte.ajouter(c, (int) o));
            if (carte.nombre > places) {
                return null;
            }
        }
        carte.ranger();
        return carte;
    }

    private void ajouter(int c, int objet) {
        if (nombre == objets.length) {
            objets = Arrays.copyOf(objets, 2 * nombre);
            cases = Arrays.copyOf(cases, 2 * nombre);
        }
        objets[nombre] = objet;
        cases[nombre++] = c;
    }

    /** Range les places par case, sans changer l'ordre de celles d'une case. */
    private void ranger() {
        for (int e = 0; e < nombre; e++) {
            debut[cases[e]]++;
        }
        for (int c = 1; c < debut.length; c++) {
            debut[c] += debut[c - 1];
        }
        int[] ranges = new int[nombre];
        for (int e = nombre - 1; e >= 0; e--) {
            ranges[--debut[cases[e]]] = objets[e];
        }
        objets = ranges;
        cases = null;
    }

    /** Dit si cette case a trop d'objets. */
    boolean estPleine(int c) {
        return debut[c + 1] - debut[c] > PLEINE;
    }
}
