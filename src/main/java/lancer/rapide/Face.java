package lancer.rapide;

import lancer.Camera;
import lancer.Constantes;
import lancer.precision.Intersection;

/**
 * Une fenêtre rectangulaire vue d'un point et découpée en cases. Elle donne la case d'une direction, et les cases que
 * couvre la silhouette d'une sphère. Une direction (x, y, z), avec z &gt; 0, coupe la fenêtre en u = x/z, v = y/z.
 */
final class Face {

    /**
     * Élargissement des silhouettes, en u et v. Les directions et les silhouettes sont calculées à 1e-15 près. Les
     * arrondis de {@link lancer.precision.Intersection#distance} élargissent une silhouette de 4e-15 au plus.
     */
    static final double MARGE = 4e-12;

    /** Plus grande ouverture d'une fenêtre, en u et v : 63 degrés de part et d'autre de l'axe. */
    static final double OUVERTURE = 2;

    /** Part de la distance au centre : si la surface est plus proche, la sphère touche toutes les cases. */
    private static final double CONTRE_LA_SURFACE = 1e-9;

    /** Distances entre lesquelles les carrés ne débordent pas. */
    static final double LOIN_MIN = 1e-120;
    static final double LOIN_MAX = 1e140;

    /** Si z dépasse r de moins de cette part de la distance, la silhouette n'est pas traitée comme une ellipse. */
    private static final double RASANTE = 1e-3;

    /** Le repère, ligne par ligne. */
    private final double[] e;
    private final double u0;
    private final double v0;
    private final double u1;
    private final double v1;
    private final double dv;
    private final double parDu;
    private final double parDv;
    final int colonnes;
    final int lignes;

    /** Distance d'un œil sur l'axe à l'image ; NaN si l'œil est trop près ou devant : aucun rayon n'a alors de case. */
    double focale = Double.NaN;

    /** Dernière silhouette : première et dernière ligne ; pour chaque ligne, colonnes touchées et couvertes. */
    int ligne0;
    int ligne1;
    int[] de;
    int[] a;
    int[] couvertDe;
    int[] couvertA;

    Face(double[] repere, double u0, double v0, double u1, double v1, int colonnes, int lignes) {
        this.e = repere;
        this.u0 = u0;
        this.v0 = v0;
        this.u1 = u1;
        this.v1 = v1;
        this.colonnes = colonnes;
        this.lignes = lignes;
        dv = (v1 - v0) / lignes;
        parDu = 1 / ((u1 - u0) / colonnes);
        parDv = 1 / dv;
        de = new int[lignes];
        a = new int[lignes];
        couvertDe = new int[lignes];
        couvertA = new int[lignes];
    }

    /** La fenêtre de l'image, vue de l'œil. @param cote celui d'une case, en pixels */
    static Face deLImage(Camera camera, double cote) {
        double focale = -camera.getOeil().z;
        double u = Constantes.ECHELLE / 2 / focale;
        double v = u * camera.getHauteur() / camera.getLargeur();
        Face face = new Face(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, -u, -v, u, v,
                (int) Math.ceil(camera.getLargeur() / cote), (int) Math.ceil(camera.getHauteur() / cote));
        face.focale = u > 0 && u < OUVERTURE ? focale : Double.NaN;
        return face;
    }

    /** La case de cette direction, -1 si elle n'est pas dans la fenêtre. */
    int caseDe(double x, double y, double z) {
        double w = e[6] * x + e[7] * y + e[8] * z;
        if (!(w > 0)) {
            return -1;
        }
        double parW = 1 / w;
        return casePlane((e[0] * x + e[1] * y + e[2] * z) * parW, (e[3] * x + e[4] * y + e[5] * z) * parW);
    }

    /** La case que traverse ce rayon ; -1 s'il est hors de l'image, ou ne va pas de l'écran à l'opposé de l'œil. */
    int caseDeLOeil(double px, double py, double pz, double vx, double vy, double vz) {
        // écart permis entre la direction du rayon et celle de l'œil, en z = 1 : le quart de la marge
        double ecart = MARGE / 4 * focale * vz;
        double parFocale = 1 / focale;
        return pz == 0 && Math.abs(vx * focale - px * vz) <= ecart && Math.abs(vy * focale - py * vz) <= ecart
                ? casePlane(px * parFocale, py * parFocale) : -1;
    }

    /** La case de ce point de la fenêtre, -1 s'il est dehors. */
    int casePlane(double u, double v) {
        double i = (u - u0) * parDu;
        double j = (v - v0) * parDv;
        return i >= 0 && j >= 0 && i <= colonnes && j <= lignes
                ? Math.min((int) j, lignes - 1) * colonnes + Math.min((int) i, colonnes - 1) : -1;
    }

    /** Cherche les cases que touche, ou couvre, une sphère vue en (dx, dy, dz). @return faux s'il n'y en a pas */
    boolean silhouette(double dx, double dy, double dz, double rayon) {
        double loin = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double r = rayon / loin;
        if (!(loin > LOIN_MIN && loin < LOIN_MAX && r < 1 - CONTRE_LA_SURFACE)) {
            return rectangle(0, lignes - 1, 0, colonnes - 1);
        }
        // les longueurs sont divisées par loin : la direction du centre est de longueur 1
        double x = dx / loin;
        double y = dy / loin;
        double z = dz / loin;
        double cx = e[0] * x + e[1] * y + e[2] * z;
        double cy = e[3] * x + e[4] * y + e[5] * z;
        double cz = e[6] * x + e[7] * y + e[8] * z;
        // la sphère est hors de la pyramide de la fenêtre : derrière, ou au-delà d'un côté
        double rm = r + MARGE * 4;
        if (cz < -rm || cx - u1 * cz > rm * Math.sqrt(1 + u1 * u1) || u0 * cz - cx > rm * Math.sqrt(1 + u0 * u0)
                || cy - v1 * cz > rm * Math.sqrt(1 + v1 * v1) || v0 * cz - cy > rm * Math.sqrt(1 + v0 * v0)) {
            return false;
        }
        return cz > r + RASANTE ? ellipse(cx, cy, cz, r) : rectangle(0, lignes - 1, 0, colonnes - 1);
    }

    /**
     * La silhouette est l'ellipse (cx u + cy v + cz)² = K (u² + v² + 1), avec K = 1 − r². À v donné, son bord est en
     * (cx m ± √(K (cz² − r²)(v+ − v)(v − v−))) / (cy² + cz² − r²), avec m = cy v + cz. Cette formule ne soustrait pas
     * de nombres voisins.
     */
    private boolean ellipse(double cx, double cy, double cz, double r) {
        // boîte englobante de l'ellipse
        double q = cz * cz - r * r;
        double ru = r * Math.sqrt(cx * cx + q);
        double rv = r * Math.sqrt(cy * cy + q);
        double uMin = (cx * cz - ru) / q;
        double uMax = (cx * cz + ru) / q;
        double vMin = (cy * cz - rv) / q;
        double vMax = (cy * cz + rv) / q;
        if (uMax + MARGE < u0 || uMin - MARGE > u1 || vMax + MARGE < v0 || vMin - MARGE > v1) {
            return false;
        }
        int colonne0 = rang((uMin - MARGE - u0) * parDu, colonnes);
        int colonne1 = rang((uMax + MARGE - u0) * parDu, colonnes);
        ligne0 = rang((vMin - MARGE - v0) * parDv, lignes);
        ligne1 = rang((vMax + MARGE - v0) * parDv, lignes);
        if (colonne1 - colonne0 <= 1 && ligne1 - ligne0 <= 1) {
            return rectangle(ligne0, ligne1, colonne0, colonne1);
        }
        // pour chaque ligne, g0 et d0 sont les bords en haut, g1 et d1 les bords en bas
        double kq = (1 - r * r) * q;
        double parA = 1 / (cy * cy + q);
        double vDeMin = cy * (1 + uMin * uMin) / (cz + cx * uMin);
        double vDeMax = cy * (1 + uMax * uMax) / (cz + cx * uMax);
        // pour déplacer le bord d'une marge, cet écart s'ajoute ou se retranche sous la racine
        double ecart = MARGE * (vMax - vMin) + MARGE * MARGE;
        double g0 = Double.POSITIVE_INFINITY;
        double d0 = Double.NEGATIVE_INFINITY;
        double gc0 = Double.POSITIVE_INFINITY;
        double dc0 = Double.NEGATIVE_INFINITY;
        for (int j = ligne0 - 1; j <= ligne1; j++) {
            double v = v0 + (j + 1) * dv;
            double milieu = cx * (cy * v + cz) * parA;
            double produit = (vMax - v) * (v - vMin);
            double g1 = Double.POSITIVE_INFINITY;
            double d1 = Double.NEGATIVE_INFINITY;
            double gc1 = Double.POSITIVE_INFINITY;
            double dc1 = Double.NEGATIVE_INFINITY;
            if (produit + ecart >= 0) {
                double racine = Math.sqrt(kq * (produit + ecart)) * parA;
                g1 = milieu - racine - MARGE;
                d1 = milieu + racine + MARGE;
                if (produit > ecart) {
                    racine = Math.sqrt(kq * (produit - ecart)) * parA;
                    gc1 = milieu - racine + MARGE;
                    dc1 = milieu + racine - MARGE;
                }
            }
            if (j >= ligne0) {
                double gauche = vDeMin >= v - dv - MARGE && vDeMin <= v + MARGE ? uMin - MARGE : Math.min(g0, g1);
                double droite = vDeMax >= v - dv - MARGE && vDeMax <= v + MARGE ? uMax + MARGE : Math.max(d0, d1);
                de[j] = rang((gauche - u0) * parDu, colonnes);
                a[j] = rang((droite - u0) * parDu, colonnes);
                // l'ellipse est convexe : une case est couverte si ses quatre coins le sont
                couvertDe[j] = (int) Math.ceil((Math.max(gc0, gc1) - u0) * parDu);
                couvertA[j] = (int) Math.floor((Math.min(dc0, dc1) - u0) * parDu) - 1;
            }
            g0 = g1;
            d0 = d1;
            gc0 = gc1;
            dc0 = dc1;
        }
        return true;
    }

    /** Touche ces lignes et ces colonnes, sans en couvrir aucune case. */
    private boolean rectangle(int premiere, int derniere, int gauche, int droite) {
        ligne0 = premiere;
        ligne1 = derniere;
        for (int j = premiere; j <= derniere; j++) {
            de[j] = gauche;
            a[j] = droite;
            couvertA[j] = -1;
        }
        return true;
    }

    /** La partie entière de x, ramenée dans [0, n − 1]. */
    static int rang(double x, int n) {
        return x <= 0 ? 0 : x >= n ? n - 1 : (int) x;
    }
}
