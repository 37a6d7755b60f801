package lancer.rapide;

/**
 * Une face d'un cube de directions, perpendiculaire à un axe. Une fenêtre y est découpée en cases égales. Une direction
 * dont la composante w le long de l'axe est positive coupe la face en (u, v), les deux autres composantes divisées par
 * w. |u| et |v| ne dépassent pas 1.
 */
final class FaceDeCube {

    /** Sinus au-delà duquel une enveloppe est comparée à toutes les cases, et n'élargit pas la fenêtre. */
    static final double GRANDE = 0.25;

    /** Élargissement d'une case, en u et v : les directions y sont calculées à 1e-15 près. */
    private static final double MARGE = 1e-12;

    /** Écart sur un cosinus : quelques arrondis. */
    private static final double ECART = 0x1p-50;

    /** Axe de w, parmi x, y et z, et son signe. */
    private final int axe;
    private final double signe;

    private double u0 = Double.POSITIVE_INFINITY;
    private double v0 = Double.POSITIVE_INFINITY;
    private double u1 = Double.NEGATIVE_INFINITY;
    private double v1 = Double.NEGATIVE_INFINITY;
    private double du;
    private double dv;
    private double parDu;
    private double parDv;
    private int colonnes;
    private int lignes;
    private int premiere;

    /** @param numero le double de l'axe, plus 1 si son sens est négatif */
    FaceDeCube(int numero) {
        axe = numero / 2;
        signe = numero % 2 == 0 ? 1 : -1;
    }

    /** Le numéro de la face que traverse cette direction. */
    static int numero(double x, double y, double z) {
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

    /**
     * Élargit la fenêtre à la silhouette d'une enveloppe.
     *
     * @param d direction du centre, de longueur 1
     * @param sinus celui du demi-angle, au plus {@link #GRANDE}
     */
    void elargir(double[] d, double sinus) {
        double[] vus = silhouette(d, sinus);
        if (vus != null && vus[0] <= 1 && vus[1] >= -1 && vus[2] <= 1 && vus[3] >= -1) {
            double cadre = 1 + MARGE;
            u0 = Math.min(u0, Math.max(-cadre, vus[0]));
            u1 = Math.max(u1, Math.min(cadre, vus[1]));
            v0 = Math.min(v0, Math.max(-cadre, vus[2]));
            v1 = Math.max(v1, Math.min(cadre, vus[3]));
        }
    }

    /** L'aire de la fenêtre, 0 s'il n'y en a pas. */
    double aire() {
        return u0 < u1 ? (u1 - u0) * (v1 - v0) : 0;
    }

    /**
     * Découpe la fenêtre en cases de ce côté.
     *
     * @param cases nombre maximal de colonnes, et de lignes
     * @param rang celui de la première case
     * @return le rang qui suit la dernière
     */
    int decouper(double cote, int cases, int rang) {
        if (!(u0 < u1)) {
            return rang;
        }
        premiere = rang;
        colonnes = 1 + (int) Math.min(cases, (u1 - u0) / cote);
        lignes = 1 + (int) Math.min(cases, (v1 - v0) / cote);
        du = (u1 - u0) / colonnes;
        dv = (v1 - v0) / lignes;
        parDu = 1 / du;
        parDv = 1 / dv;
        return rang + colonnes * lignes;
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
        return premiere + rang((v - v0) * parDv, lignes) * colonnes + rang((u - u0) * parDu, colonnes);
    }

    private static int rang(double x, int n) {
        return Math.max(0, Math.min((int) x, n - 1));
    }

    /**
     * Les bornes de u, puis de v, d'un cône d'axe c : (cu cw ± s √(cu² + cw² − s²)) / (cw² − s²).
     *
     * @return {@code null} s'il est hors du cadre : une direction du cadre est à 55 degrés de l'axe au plus
     */
    private double[] silhouette(double[] d, double sinus) {
        double w = signe * d[axe];
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
     * Ajoute les cases que touche une enveloppe : le cône de la case et le sien se coupent.
     *
     * @param d direction du centre, de longueur 1
     * @param sinus celui du demi-angle ; 1 ou plus si le point est dans l'enveloppe
     */
    void chercher(double[] d, double sinus, Rangs touchees) {
        double[] vus = sinus <= GRANDE ? silhouette(d, sinus) : new double[] {u0, u1, v0, v1};
        // une fenêtre vide n'en touche aucune
        if (vus == null || !(vus[0] <= u1 && vus[1] >= u0 && vus[2] <= v1 && vus[3] >= v0)) {
            return;
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
                    touchees.ajouter(premiere + j * colonnes + i);
                }
            }
        }
    }
}
