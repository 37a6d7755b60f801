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

    /** Nombre de grandes enveloppes au-delà duquel il n'y a pas de carte : chacune est comparée à toutes les cases. */
    private static final int GRANDES_MAX = 16;

    final PointDeVue point;

    /** Première place de chaque case, et nombre de places, −1 si elle est pleine. */
    final int[] debut;
    final byte[] nombre;

    /** Pour chaque place, le rang d'un objet et une borne inférieure de sa distance au point. */
    final int[] objets;
    final float[] pres;

    private Carte(PointDeVue point, int places) {
        this.point = point;
        debut = new int[point.nombre];
        nombre = new byte[point.nombre];
        objets = new int[places];
        pres = new float[places];
    }

    /**
     * La carte de ce point.
     *
     * @param places nombre maximal de places
     * @return {@code null} s'il en faut davantage, ou s'il y a trop de grandes enveloppes
     */
    static Carte de(PointDeVue point, Enveloppes enveloppes, int places) {
        if (point == null) {
            return null;
        }
        double[] g = enveloppes.geometrie;
        long[] ordre = new long[enveloppes.bornes.length];
        for (int o = 0; o < ordre.length; o++) {
            // la moitié haute, positive, donne l'ordre
            int k = enveloppes.bornes[o];
            ordre[o] = (long) Float.floatToRawIntBits(point.auMoins(g, k)) << 32 | k;
        }
        Arrays.sort(ordre);
        int[] cases = new int[2 * ordre.length + 16];
        int[] quelle = new int[cases.length];
        int[] comptes = new int[point.nombre];
        int total = 0;
        int grandes = 0;
        for (int o = 0; o < ordre.length; o++) {
            Recherche.obeir();
            int[] siennes = point.cases(g, (int) ordre[o]);
            grandes += siennes.length > point.nombre / 8 ? 1 : 0;
            if (grandes > GRANDES_MAX || total + siennes.length > places) {
                return null;
            }
            if (total + siennes.length > cases.length) {
                cases = Arrays.copyOf(cases, 2 * cases.length + siennes.length);
                quelle = Arrays.copyOf(quelle, cases.length);
            }
            for (int c : siennes) {
                cases[total] = c;
                quelle[total++] = o;
                comptes[c]++;
            }
        }
        return ranger(point, ordre, comptes, Arrays.copyOf(cases, total), quelle);
    }

    /** Range par case les objets, donnés par distance croissante. */
    private static Carte ranger(PointDeVue point, long[] ordre, int[] comptes, int[] cases, int[] quelle) {
        int places = 0;
        for (int n : comptes) {
            places += n > PLEINE ? 0 : n;
        }
        Carte carte = new Carte(point, places);
        int place = 0;
        for (int c = 0; c < comptes.length; c++) {
            carte.debut[c] = place;
            carte.nombre[c] = (byte) (comptes[c] > PLEINE ? -1 : 0);
            place += comptes[c] > PLEINE ? 0 : comptes[c];
        }
        for (int e = 0; e < cases.length; e++) {
            int c = cases[e];
            if (carte.nombre[c] >= 0) {
                int ici = carte.debut[c] + carte.nombre[c]++;
                carte.objets[ici] = (int) ordre[quelle[e]];
                carte.pres[ici] = Float.intBitsToFloat((int) (ordre[quelle[e]] >>> 32));
            }
        }
        return carte;
    }
}
