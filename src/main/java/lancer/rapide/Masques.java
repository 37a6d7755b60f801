package lancer.rapide;

import lancer.Camera;
import lancer.Constantes;
import lancer.Point;
import lancer.precision.Intersection;

/**
 * Masques d'une petite scène : un bit d'un {@code long} par sphère qu'un rayon peut rencontrer. Il y a un masque par
 * tuile de l'écran, un par sphère de départ et par cube de directions, un par lampe et par sphère éclairée. Le départ
 * du rayon est vérifié avant d'utiliser un masque. S'il ne convient pas, l'arbre répond.
 */
final class Masques implements Intersections {

    /** Nombre maximal de sphères : celui des bits. */
    static final int MAX = Long.SIZE;

    /** Nombre de cubes de directions par côté du cube [−1, 1]³. */
    private static final int COTE = 8;
    private static final int CUBES = COTE * COTE * COTE;

    /** Côté d'une tuile de l'écran, en pixels. */
    private static final int TUILE = 8;

    /** Élargissement d'une sphère de départ ou éclairée, en part des longueurs ; un départ en vérifie la moitié. */
    private static final double MARGE = 1e-9;

    private final Spheres spheres;
    /** Arbre qui répond aux rayons qu'aucun masque n'accepte. */
    private final Arbre secours;
    private final double portee;
    private final Face image;
    private final long[] parTuile;
    private final long[] parDirection;
    /** Pour chaque sphère, carré de la plus grande distance permise de son centre au départ d'un rayon. */
    private final double[] limites;

    /** @param portee plus grande coordonnée des sphères et de l'œil */
    Masques(Spheres spheres, Arbre secours, double portee, Camera camera) {
        this.spheres = spheres;
        this.secours = secours;
        this.portee = portee;
        int n = spheres.nombre;
        image = Face.deLImage(camera, TUILE);
        parTuile = new long[image.colonnes * image.lignes];
        parDirection = new long[CUBES * n];
        limites = new double[n];
        for (int k = 0; k < n; k++) {
            noterTuiles(k);
            limites[k] = limite(k, portee);
            noterDirections(k);
        }
    }

    private double limite(int k, double longueur) {
        double r = spheres.geometrie[Spheres.PAS * k + 3] + MARGE / 2 * longueur;
        return r * r;
    }

    private void noterTuiles(int k) {
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        if (!image.silhouette(g[s], g[s + 1], g[s + 2] + image.focale, g[s + 3])) {
            return;
        }
        for (int j = image.ligne0; j <= image.ligne1; j++) {
            for (int i = image.de[j]; i <= image.a[j]; i++) {
                parTuile[j * image.colonnes + i] |= 1L << k;
            }
        }
    }

    /**
     * Note les sphères b que peut rencontrer un rayon parti de la sphère a. L'angle de sa direction et de AB est au
     * plus asin((rA + rB) / AB). Dans un cube de centre c et de demi-côté h, le cosinus d'une direction avec w est au
     * plus c·w + h(|wx| + |wy| + |wz|).
     */
    private void noterDirections(int a) {
        double[] g = spheres.geometrie;
        double demi = 1.0 / COTE;
        for (int b = 0; b < spheres.nombre; b++) {
            if (b == a) {
                continue;
            }
            int sa = Spheres.PAS * a;
            int sb = Spheres.PAS * b;
            double x = g[sb] - g[sa];
            double y = g[sb + 1] - g[sa + 1];
            double z = g[sb + 2] - g[sa + 2];
            double d = Math.sqrt(x * x + y * y + z * z);
            double sinus = (g[sa + 3] + g[sb + 3] + MARGE * portee) / d;
            double cosinus = sinus < 1 ? Math.sqrt(1 - sinus * sinus) - MARGE : -2;
            x /= d;
            y /= d;
            z /= d;
            double plus = demi * (Math.abs(x) + Math.abs(y) + Math.abs(z));
            int c = CUBES * a;
            for (int k = 0; k < COTE; k++) {
                double cz = ((2 * k + 1) * demi - 1) * z + plus;
                for (int j = 0; j < COTE; j++) {
                    double cy = ((2 * j + 1) * demi - 1) * y + cz;
                    for (int i = 0; i < COTE; i++, c++) {
                        // deux centres confondus ont un cosinus NaN : la négation les note partout
                        if (!(((2 * i + 1) * demi - 1) * x + cy < cosinus)) {
                            parDirection[c] |= 1L << b;
                        }
                    }
                }
            }
        }
    }

    @Override
    public int plusProche(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            int sauf) {
        long masque;
        double[] g = spheres.geometrie;
        if (sauf < 0) {
            int t = image.caseDeLOeil(px, py, pz, vx, vy, vz);
            if (t < 0) {
                return secours.plusProche(etat, px, py, pz, vx, vy, vz, sauf);
            }
            masque = parTuile[t];
        } else {
            int s = Spheres.PAS * sauf;
            double x = px - g[s];
            double y = py - g[s + 1];
            double z = pz - g[s + 2];
            if (!(x * x + y * y + z * z <= limites[sauf])) {
                return secours.plusProche(etat, px, py, pz, vx, vy, vz, sauf);
            }
            int i = Math.min(COTE - 1, (int) ((vx + 1) * (COTE / 2)));
            int j = Math.min(COTE - 1, (int) ((vy + 1) * (COTE / 2)));
            int k = Math.min(COTE - 1, (int) ((vz + 1) * (COTE / 2)));
            masque = parDirection[CUBES * sauf + (k * COTE + j) * COTE + i];
        }
        etat.compteurs.noeudsVisites++;
        etat.compteurs.testsSpheres += Long.bitCount(masque);
        double distance = Constantes.INFINI;
        int trouvee = -1;
        for (; masque != 0; masque &= masque - 1) {
            int k = Long.numberOfTrailingZeros(masque);
            int s = Spheres.PAS * k;
            double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
            if (d < 0) {
                d = etat.trancher(spheres, k, d, distance, px, py, pz, vx, vy, vz);
            }
            if (d <= distance && Spheres.avant(d, k, distance, trouvee)) {
                distance = d;
                trouvee = k;
            }
        }
        etat.distance = distance;
        return trouvee;
    }

    /** Pour chaque sphère éclairée A, les sphères que peut rencontrer un segment de la lampe à un point de A. */
    final class Ombres implements Occultations {

        private final long[] parSphere = new long[spheres.nombre];
        private final double[] limitesIci = new double[spheres.nombre];
        private final double lx;
        private final double ly;
        private final double lz;

        Ombres(Point lampe) {
            lx = lampe.x;
            ly = lampe.y;
            lz = lampe.z;
            double longueur = Math.max(portee,
                    Math.max(Math.abs(lampe.x), Math.max(Math.abs(lampe.y), Math.abs(lampe.z))));
            double[] g = spheres.geometrie;
            int n = spheres.nombre;
            double[] x = new double[n];
            double[] y = new double[n];
            double[] z = new double[n];
            double[] loin = new double[n];
            double[] angle = new double[n];
            for (int k = 0; k < n; k++) {
                int s = Spheres.PAS * k;
                x[k] = g[s] - lampe.x;
                y[k] = g[s + 1] - lampe.y;
                z[k] = g[s + 2] - lampe.z;
                loin[k] = Math.sqrt(x[k] * x[k] + y[k] * y[k] + z[k] * z[k]);
                double r = g[s + 3] + MARGE * longueur;
                angle[k] = r < loin[k] ? Math.asin(r / loin[k]) : Math.PI;
                limitesIci[k] = limite(k, longueur);
            }
            for (int a = 0; a < n; a++) {
                double auPlus = loin[a] + g[Spheres.PAS * a + 3];
                for (int b = 0; b < n; b++) {
                    double cosinus = (x[a] * x[b] + y[a] * y[b] + z[a] * z[b]) / (loin[a] * loin[b]);
                    double somme = angle[a] + angle[b] + MARGE;
                    boolean vues = !(somme < Math.PI) || !(cosinus < Math.cos(somme) - MARGE);
                    if (b != a && vues && !(loin[b] - g[Spheres.PAS * b + 3] > auPlus + MARGE * longueur)) {
                        parSphere[a] |= 1L << b;
                    }
                }
            }
        }

        @Override
        public boolean cachee(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
                double distance, int sauf) {
            double[] g = spheres.geometrie;
            if (sauf >= 0 && px == lx && py == ly && pz == lz) {
                int s = Spheres.PAS * sauf;
                double x = px + distance * vx - g[s];
                double y = py + distance * vy - g[s + 1];
                double z = pz + distance * vz - g[s + 2];
                if (x * x + y * y + z * z <= limitesIci[sauf]) {
                    etat.compteurs.noeudsVisites++;
                    for (long masque = parSphere[sauf]; masque != 0; masque &= masque - 1) {
                        int k = Long.numberOfTrailingZeros(masque);
                        etat.compteurs.testsSpheres++;
                        int i = Spheres.PAS * k;
                        double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[i], g[i + 1], g[i + 2],
                                g[i + 3]);
                        if (d < distance && (d >= 0
                                || etat.trancher(spheres, k, d, distance, px, py, pz, vx, vy, vz) < distance)) {
                            return true;
                        }
                    }
                    return false;
                }
            }
            return secours.reprendre(etat, px, py, pz, vx, vy, vz, distance, sauf);
        }
    }
}
