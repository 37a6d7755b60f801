package lancer.rapide;

/** Les fenêtres d'une lampe : une seule, ajustée, si les sphères sont d'un même côté ; sinon, six faces d'un cube. */
final class Faces {

    private static final double[][] CUBE = {
        {0, 1, 0, 0, 0, 1, 1, 0, 0}, {0, 1, 0, 0, 0, 1, -1, 0, 0},
        {0, 0, 1, 1, 0, 0, 0, 1, 0}, {0, 0, 1, 1, 0, 0, 0, -1, 0},
        {1, 0, 0, 0, 1, 0, 0, 0, 1}, {1, 0, 0, 0, 1, 0, 0, 0, -1}};

    private Faces() {
    }

    /** @param cases nombre approché de cases, toutes fenêtres ensemble */
    static Face[] pour(Spheres spheres, double ox, double oy, double oz, int cases) {
        Face seule = ajustee(spheres, ox, oy, oz, cases);
        if (seule != null) {
            return new Face[] {seule};
        }
        // ordre des faces : +x, −x, +y, −y, +z, −z
        Face[] faces = new Face[CUBE.length];
        int cote = (int) Math.ceil(Math.sqrt(cases / 6.0));
        double bord = 1 + Face.MARGE;
        for (int f = 0; f < faces.length; f++) {
            faces[f] = new Face(CUBE[f], -bord, -bord, bord, bord, cote, cote);
        }
        return faces;
    }

    /** La face du cube que traverse cette direction. */
    static int duCube(double x, double y, double z) {
        double ax = Math.abs(x);
        double ay = Math.abs(y);
        double az = Math.abs(z);
        return az >= ax && az >= ay ? z > 0 ? 4 : 5 : ay >= ax ? y > 0 ? 2 : 3 : x > 0 ? 0 : 1;
    }

    /** La fenêtre tournée vers le milieu des sphères, ajustée à leurs silhouettes ; {@code null} si trop grande. */
    private static Face ajustee(Spheres spheres, double ox, double oy, double oz, int cases) {
        double[] g = spheres.geometrie;
        Boite boite = Boite.de(spheres, spheres.toutes());
        double[] e = repere((boite.xMin + boite.xMax) / 2 - ox, (boite.yMin + boite.yMax) / 2 - oy,
                (boite.zMin + boite.zMax) / 2 - oz);
        if (e == null) {
            return null;
        }
        double u0 = Face.OUVERTURE;
        double u1 = -Face.OUVERTURE;
        double v0 = Face.OUVERTURE;
        double v1 = -Face.OUVERTURE;
        for (int s = 0; s < g.length; s += Spheres.PAS) {
            double x = g[s] - ox;
            double y = g[s + 1] - oy;
            double z = g[s + 2] - oz;
            double r = g[s + 3];
            double cx = e[0] * x + e[1] * y + e[2] * z;
            double cy = e[3] * x + e[4] * y + e[5] * z;
            double cz = e[6] * x + e[7] * y + e[8] * z;
            if (!(cz > 1.01 * r && cz > Face.OUVERTURE / 10 * r)) {
                return null;
            }
            double q = (cz - r) * (cz + r);
            double ru = r * Math.sqrt(cx * cx + q);
            double rv = r * Math.sqrt(cy * cy + q);
            u0 = Math.min(u0, (cx * cz - ru) / q);
            u1 = Math.max(u1, (cx * cz + ru) / q);
            v0 = Math.min(v0, (cy * cz - rv) / q);
            v1 = Math.max(v1, (cy * cz + rv) / q);
        }
        if (!(u0 > -Face.OUVERTURE && u1 < Face.OUVERTURE && v0 > -Face.OUVERTURE && v1 < Face.OUVERTURE)) {
            return null;
        }
        u0 -= 4 * Face.MARGE;
        v0 -= 4 * Face.MARGE;
        u1 += 4 * Face.MARGE;
        v1 += 4 * Face.MARGE;
        double cote = Math.sqrt((u1 - u0) * (v1 - v0) / cases);
        return new Face(e, u0, v0, u1, v1, Math.max(1, Math.min(cases, (int) ((u1 - u0) / cote))),
                Math.max(1, Math.min(cases, (int) ((v1 - v0) / cote))));
    }

    /** Repère orthonormé dont la troisième direction est (x, y, z) ; {@code null} si sa longueur est hors limites. */
    private static double[] repere(double x, double y, double z) {
        double n = Math.sqrt(x * x + y * y + z * z);
        if (!(n > Face.LOIN_MIN && n < Face.LOIN_MAX)) {
            return null;
        }
        x /= n;
        y /= n;
        z /= n;
        // un vecteur perpendiculaire à (x, y, z), puis leur produit vectoriel
        boolean versX = Math.abs(x) < 0.6;
        double ax = versX ? 0 : -z;
        double ay = versX ? z : 0;
        double az = versX ? -y : x;
        double m = Math.sqrt(ax * ax + ay * ay + az * az);
        ax /= m;
        ay /= m;
        az /= m;
        return new double[] {ax, ay, az, y * az - z * ay, z * ax - x * az, x * ay - y * ax, x, y, z};
    }
}
