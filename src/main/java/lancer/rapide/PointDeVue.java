package lancer.rapide;

import java.util.Arrays;
import lancer.Point;
import lancer.Vecteur;

/**
 * Les enveloppes vues d'un point, l'œil ou une lampe, par direction, de la plus proche à la plus lointaine (« light
 * buffer », Haines et Greenberg, 1986).
 */
final class PointDeVue {

    /**
     * Écart permis du point à la droite d'un rayon, en part de la portée ; une enveloppe en a le double. Celui d'un
     * rayon parti de plus loin est moins sûr, mais ce qu'il touche est plus loin encore, et plus élargi.
     */
    private static final double ECART = 5e-14;

    /** Élargissement d'un cône : une direction et l'erreur d'une distance sont de quelques arrondis. */
    private static final double MARGE = 1e-14;

    /** Ce qui couvre l'arrondi de la distance selon laquelle une liste est triée, en part de cette distance. */
    private static final double ARRONDI_DU_TRI = 0x1p-26;

    /** Plus petite distance dont le carré garde ses chiffres. */
    private static final double LOIN_MIN = 1e-120;

    private final double x;
    private final double y;
    private final double z;
    private final double ecart;
    private final double[] g;
    final Cellules cellules;

    /**
     * @param depart un point d'où part un rayon qui passe par p : une lampe elle-même, ou un point de l'écran
     * @param cubes voir {@link Cellules#de}
     */
    PointDeVue(Point p, Point depart, Enveloppes enveloppes, int cubes, int placesMax) {
        x = p.x;
        y = p.y;
        z = p.z;
        ecart = p == depart ? 0 : ECART * Math.max(Enveloppes.plusGrande(x, y, z),
                Enveloppes.plusGrande(depart.x, depart.y, depart.z));
        g = enveloppes.geometrie;
        double[] cones = new double[g.length];
        long[] cles = new long[enveloppes.petits.length];
        // les derniers chiffres d'une distance font place au rang : il en reste 2^-26 jusqu'à trente millions d'objets
        long rangs = (Long.highestOneBit(enveloppes.objets.length) << 1) - 1;
        for (int o = 0; o < cles.length; o++) {
            int k = enveloppes.petits[o];
            cles[o] = Double.doubleToRawLongBits(viser(cones, k)) & ~rangs | k;
        }
        Arrays.sort(cles);
        int[] ordre = Arrays.stream(cles).mapToInt(cle -> (int) (cle & rangs)).toArray();
        cellules = Cellules.de(cones, ordre, MARGE, true, cubes, placesMax);
    }

    /**
     * Note le cône de l'enveloppe k. Le demi-angle a d'un cône a pour corde 2 sin(a/2).
     *
     * @return la distance de l'enveloppe, 0 si elle contient le point
     */
    private double viser(double[] cones, int k) {
        int s = Enveloppes.PAS * k;
        double dx = g[s] - x;
        double dy = g[s + 1] - y;
        double dz = g[s + 2] - z;
        double loin = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double r = g[s + 3] + 2 * ecart;
        double sinus = r / loin;
        if (loin > LOIN_MIN && loin < Enveloppes.LONGUEUR_MAX && sinus < 1) {
            cones[s] = dx / loin;
            cones[s + 1] = dy / loin;
            cones[s + 2] = dz / loin;
            cones[s + 3] = sinus * Math.sqrt(2 / (1 + Math.sqrt(1 - sinus * sinus)));
            return loin - r;
        }
        cones[s + 3] = 2;
        return 0;
    }

    /**
     * De combien l'ordre des enveloppes peut être faux pour un rayon qui part de P : l'arrondi du tri, en part de la
     * distance de P à ce point, et trois écarts, car une enveloppe à moins de deux écarts est rangée comme si elle
     * contenait le point.
     */
    double erreur(Point p) {
        double avance = Math.sqrt((p.x - x) * (p.x - x) + (p.y - y) * (p.y - y) + (p.z - z) * (p.z - z));
        return ARRONDI_DU_TRI * avance + 3 * ecart;
    }

    /**
     * Dit si, pour un rayon (P, V) qui vient de ce point, l'enveloppe de ce rang et toutes celles qui la suivent dans
     * l'ordre sont au-delà d'une distance.
     *
     * @param limite cette distance, plus l'{@link #erreur} de l'ordre
     */
    boolean metAuDela(double limite, int rang, Point p, Vecteur v) {
        int s = Enveloppes.PAS * rang;
        double b = (g[s] - p.x) * v.x + (g[s + 1] - p.y) * v.y + (g[s + 2] - p.z) * v.z;
        return b * (1 - ARRONDI_DU_TRI) - g[s + 3] > limite;
    }

    /** Dit si ce rayon passe par ce point, puis s'en éloigne. */
    boolean envoie(Point p, Vecteur v) {
        double ax = p.x - x;
        double ay = p.y - y;
        double az = p.z - z;
        double cx = ay * v.z - az * v.y;
        double cy = az * v.x - ax * v.z;
        double cz = ax * v.y - ay * v.x;
        return cx * cx + cy * cy + cz * cz <= ecart * ecart && ax * v.x + ay * v.y + az * v.z >= 0;
    }
}
