package lancer.rapide;

/** Une boîte englobante de sphères. */
final class Boite {

    double xMin = Double.POSITIVE_INFINITY;
    double yMin = Double.POSITIVE_INFINITY;
    double zMin = Double.POSITIVE_INFINITY;
    double xMax = Double.NEGATIVE_INFINITY;
    double yMax = Double.NEGATIVE_INFINITY;
    double zMax = Double.NEGATIVE_INFINITY;

    void ajouter(double x, double y, double z, double r) {
        xMin = Math.min(xMin, x - r);
        yMin = Math.min(yMin, y - r);
        zMin = Math.min(zMin, z - r);
        xMax = Math.max(xMax, x + r);
        yMax = Math.max(yMax, y + r);
        zMax = Math.max(zMax, z + r);
    }

    /** @param autre {@code null} pour une boîte vide */
    void ajouter(Boite autre) {
        if (autre != null) {
            ajouter(autre.xMin, autre.yMin, autre.zMin, 0);
            ajouter(autre.xMax, autre.yMax, autre.zMax, 0);
        }
    }

    static Boite de(Spheres spheres, int[] lesquelles) {
        Boite boite = new Boite();
        double[] g = spheres.geometrie;
        for (int k : lesquelles) {
            int s = Spheres.PAS * k;
            boite.ajouter(g[s], g[s + 1], g[s + 2], g[s + 3]);
        }
        return boite;
    }

    /** La moitié de l'aire de la boîte. */
    double aire() {
        double a = xMax - xMin;
        double b = yMax - yMin;
        double c = zMax - zMin;
        return a * b + b * c + c * a;
    }

    /** La plus grande coordonnée, en valeur absolue. */
    double portee() {
        return Math.max(Math.max(Math.max(-xMin, xMax), Math.max(-yMin, yMax)), Math.max(-zMin, zMax));
    }
}
