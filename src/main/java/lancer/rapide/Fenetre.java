package lancer.rapide;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntConsumer;
import java.util.stream.Collectors;
import lancer.Vecteur;

/**
 * Une fenêtre sur les directions qui partent d'un point, perpendiculaire à un axe et découpée en cases égales. Une
 * direction dont la composante w le long de l'axe est positive coupe la fenêtre en (u, v), les deux autres composantes
 * divisées par w. |u| et |v| ne dépassent pas 1.
 */
final class Fenetre {

    /** Élargissement d'une case, en u et v : les directions y sont calculées à 1e-15 près. */
    static final double MARGE = 1e-12;

    /** Écart sur un cosinus : quelques arrondis. */
    private static final double ECART = 0x1p-50;

    /** Sinus au-delà duquel une enveloppe est comparée à toutes les cases. */
    static final double GRANDE = 0.25;

    /** Les plans u = −w, u = w, v = −w et v = w : leurs vecteurs normaux (u, v, w), du côté du cadre. */
    private static final Vecteur[] COTES = {new Vecteur(1, 0, 1), new Vecteur(-1, 0, 1), new Vecteur(0, 1, 1),
        new Vecteur(0, -1, 1)};

    /** Axe de w, parmi x, y et z, et son signe. */
    private final int axe;
    private final double signe;
    private final double u0;
    private final double v0;
    private final double u1;
    private final double v1;
    private final double du;
    private final double dv;
    private final double parDu;
    private final double parDv;
    final int colonnes;
    final int lignes;

    /** @param face le double de l'axe, plus 1 si son sens est négatif */
    Fenetre(int face, double[] bords, int colonnes, int lignes) {
        axe = face / 2;
        signe = face % 2 == 0 ? 1 : -1;
        u0 = bords[0];
        u1 = bords[1];
        v0 = bords[2];
        v1 = bords[3];
        this.colonnes = colonnes;
        this.lignes = lignes;
        du = (u1 - u0) / colonnes;
        dv = (v1 - v0) / lignes;
        parDu = 1 / du;
        parDv = 1 / dv;
    }

    /** La face du cube que traverse cette direction. */
    static int face(double x, double y, double z) {
        double ax = Math.abs(x);
        double ay = Math.abs(y);
        double az = Math.abs(z);
        if (az >= ax && az >= ay) {
            return z > 0 ? 4 : 5;
        }
        if (ay >= ax) {
            return y > 0 ? 2 : 3;
        }
        return x > 0 ? 0 : 1;
    }

    /** La case de cette direction, −1 si elle est hors de la fenêtre. */
    int caseDe(double x, double y, double z) {
        double w = signe * (axe == 0 ? x : axe == 1 ? y : z);
        double parW = 1 / w;
        double u = (axe == 0 ? y : axe == 1 ? z : x) * parW;
        double v = (axe == 0 ? z : axe == 1 ? x : y) * parW;
        if (!(w > 0 && u >= u0 && u <= u1 && v >= v0 && v <= v1)) {
            return -1;
        }
        return rang((v - v0) * parDv, lignes) * colonnes + rang((u - u0) * parDu, colonnes);
    }

    private static int rang(double x, int n) {
        return Math.max(0, Math.min((int) x, n - 1));
    }

    /**
     * Élargit ces bords à la silhouette d'une enveloppe, coupée au cadre |u| ≤ 1, |v| ≤ 1.
     *
     * @param d direction du centre, de longueur 1
     * @param sinus celui du demi-angle, au plus {@link #GRANDE}
     */
    static void elargir(int face, double[] d, double sinus, double[] bords) {
        double[] vus = silhouette(face, d, sinus);
        if (vus != null && vus[0] <= 1 && vus[1] >= -1 && vus[2] <= 1 && vus[3] >= -1) {
            double cadre = 1 + MARGE;
            bords[0] = Math.min(bords[0], Math.max(-cadre, vus[0]));
            bords[1] = Math.max(bords[1], Math.min(cadre, vus[1]));
            bords[2] = Math.min(bords[2], Math.max(-cadre, vus[2]));
            bords[3] = Math.max(bords[3], Math.min(cadre, vus[3]));
        }
    }

    /**
     * Les bornes de u, puis de v, d'un cône d'axe c : (cu cw ± s √(cu² + cw² − s²)) / (cw² − s²).
     *
     * @return {@code null} s'il est hors du cadre : une direction du cadre est à 55 degrés de l'axe au plus
     */
    private static double[] silhouette(int face, double[] d, double sinus) {
        int axe = face / 2;
        double w = face % 2 == 0 ? d[axe] : -d[axe];
        if (!(w > 0.35)) {
            return null;
        }
        double u = d[(axe + 1) % 3];
        double v = d[(axe + 2) % 3];
        double q = w * w - sinus * sinus;
        double ru = sinus * Math.sqrt(u * u + q);
        double rv = sinus * Math.sqrt(v * v + q);
        return new double[] {(u * w - ru) / q - MARGE, (u * w + ru) / q + MARGE, (v * w - rv) / q - MARGE,
            (v * w + rv) / q + MARGE};
    }

    /**
     * Donne les cases que touche une enveloppe : le cône de la case et le sien se coupent.
     *
     * @param d direction du centre, de longueur 1
     * @param sinus celui du demi-angle ; 1 ou plus si le point est dans l'enveloppe
     */
    void chercher(double[] d, double sinus, IntConsumer touchee) {
        double[] vus = {u0, u1, v0, v1};
        if (sinus <= GRANDE) {
            vus = silhouette(2 * axe + (signe > 0 ? 0 : 1), d, sinus);
            if (vus == null || vus[0] > u1 || vus[1] < u0 || vus[2] > v1 || vus[3] < v0) {
                return;
            }
        }
        int i0 = rang((vus[0] - u0) * parDu, colonnes);
        int i1 = rang((vus[1] - u0) * parDu, colonnes);
        int j0 = rang((vus[2] - v0) * parDv, lignes);
        int j1 = rang((vus[3] - v0) * parDv, lignes);
        boolean peu = sinus <= GRANDE && i1 - i0 <= 1 && j1 - j0 <= 1;
        double cosinus = Math.sqrt(1 - sinus * sinus);
        double rayon = Math.sqrt(du * du + dv * dv) / 2 + MARGE;
        for (int j = j0; j <= j1; j++) {
            double v = v0 + (j + 0.5) * dv;
            for (int i = i0; i <= i1; i++) {
                double u = u0 + (i + 0.5) * du;
                double par = 1 / Math.sqrt(u * u + v * v + 1);
                double sa = rayon * par;
                // une case de demi-angle a est loin si l'angle des deux axes dépasse la somme des demi-angles
                double limite = Math.sqrt(1 - sa * sa) * cosinus - sa * sinus - ECART;
                double angle = (u * d[(axe + 1) % 3] + v * d[(axe + 2) % 3] + signe * d[axe]) * par;
                // NaN si le point est dans l'enveloppe : la négation donne alors toutes les cases
                if (peu || !(angle < limite)) {
                    touchee.accept(j * colonnes + i);
                }
            }
        }
    }

    /** Les bords de ce polygone de directions, coupé au cadre |u| ≤ 1, |v| ≤ 1 ; vides s'il n'y est pas. */
    static double[] entourer(int face, List<Vecteur> directions) {
        int axe = face / 2;
        List<Vecteur> coins = directions.stream().map(d -> {
            double[] xyz = {d.x, d.y, d.z};
            return new Vecteur(xyz[(axe + 1) % 3], xyz[(axe + 2) % 3], face % 2 == 0 ? xyz[axe] : -xyz[axe]);
        }).collect(Collectors.toList());
        for (Vecteur cote : COTES) {
            coins = couper(coins, cote);
        }
        double[] bords = vide();
        for (Vecteur coin : coins) {
            bords[0] = Math.min(bords[0], coin.x / coin.z - MARGE);
            bords[1] = Math.max(bords[1], coin.x / coin.z + MARGE);
            bords[2] = Math.min(bords[2], coin.y / coin.z - MARGE);
            bords[3] = Math.max(bords[3], coin.y / coin.z + MARGE);
        }
        return bords;
    }

    /** La part de ce polygone qui est de ce côté d'un plan (Sutherland et Hodgman, 1974). */
    private static List<Vecteur> couper(List<Vecteur> coins, Vecteur cote) {
        List<Vecteur> gardes = new ArrayList<>();
        for (int k = 0; k < coins.size(); k++) {
            Vecteur a = coins.get(k);
            Vecteur ab = coins.get((k + 1) % coins.size()).sub(a);
            double part = -a.dot(cote) / ab.dot(cote);
            if (a.dot(cote) >= 0) {
                gardes.add(a);
            }
            if (part > 0 && part < 1) {
                gardes.add(a.add(part, ab));
            }
        }
        return gardes;
    }

    /** Les bords de la fenêtre quand rien n'y est. */
    static double[] vide() {
        double[] bords = new double[4];
        Arrays.fill(bords, Double.POSITIVE_INFINITY);
        bords[1] = Double.NEGATIVE_INFINITY;
        bords[3] = Double.NEGATIVE_INFINITY;
        return bords;
    }
}
