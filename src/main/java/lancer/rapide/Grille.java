package lancer.rapide;

import java.util.Arrays;
import lancer.Constantes;
import lancer.Sphere;
import lancer.precision.Doute;

/**
 * Une grille régulière de cases, traversées l'une après l'autre (Amanatides et Woo, 1987) : deux à trois fois plus
 * rapide que l'arbre pour les rayons réfléchis, qui ne vont pas loin, tant que les sphères sont de tailles et de places
 * comparables. Les quelques très grosses sont à part.
 */
final class Grille implements Voisins {

    /** Cases par sphère. */
    static final double DENSITE = 2;

    /**
     * Comme {@link Etendue#marge}, quatre fois plus large : une traversée ajoute ses pas, et leurs arrondis. Elle
     * couvre un rayon qui part de {@link #DEPART_MAX} fois plus loin que la grille.
     */
    private static final double MARGE = 0x1.0p-34;
    private static final double DEPART_MAX = 64;

    private final Spheres spheres;
    private final int[] grosses;
    private final int nx;
    private final int ny;
    private final int nz;
    private final double x0;
    private final double y0;
    private final double z0;
    private final double x1;
    private final double y1;
    private final double z1;
    private final double cote;
    private final double parCote;
    private final double portee;
    final int[] debut;
    final int[] entrees;
    private final Voisins secours;

    Grille(Spheres spheres, int[] lesquelles, int[] grosses, Etendue boite, Voisins secours) {
        this.spheres = spheres;
        this.grosses = grosses;
        this.secours = secours;
        portee = boite.portee();
        double marge = MARGE * portee;
        double dx = boite.xMax - boite.xMin;
        double dy = boite.yMax - boite.yMin;
        double dz = boite.zMax - boite.zMin;
        double c = Math.cbrt(dx * dy * dz / (DENSITE * Math.max(1, lesquelles.length)));
        c = Math.max(c, Math.max(dx, Math.max(dy, dz)) / 512);
        nx = (int) (dx / c) + 1;
        ny = (int) (dy / c) + 1;
        nz = (int) (dz / c) + 1;
        cote = Math.max(Math.max(dx / nx, dy / ny), dz / nz) + 4 * marge;
        parCote = 1 / cote;
        // centrée : la même marge de chaque côté
        x0 = (boite.xMin + boite.xMax - nx * cote) / 2;
        y0 = (boite.yMin + boite.yMax - ny * cote) / 2;
        z0 = (boite.zMin + boite.zMax - nz * cote) / 2;
        x1 = x0 + nx * cote;
        y1 = y0 + ny * cote;
        z1 = z0 + nz * cote;
        int[] nombres = new int[nx * ny * nz + 1];
        int total = 0;
        double[] g = spheres.geometrie;
        int[] fins = null;
        int[] liste = null;
        for (int passe = 0; passe < 2; passe++) {
            for (int k : lesquelles) {
                int s = Spheres.PAS * k;
                double x = g[s];
                double y = g[s + 1];
                double z = g[s + 2];
                double r = g[s + 3] + marge;
                double r2 = r * r;
                int ia = rang((x - r - x0) * parCote, nx);
                int ib = rang((x + r - x0) * parCote, nx);
                int ja = rang((y - r - y0) * parCote, ny);
                int jb = rang((y + r - y0) * parCote, ny);
                int ka = rang((z - r - z0) * parCote, nz);
                int kb = rang((z + r - z0) * parCote, nz);
                for (int kk = ka; kk <= kb; kk++) {
                    double ez = ecart(z, z0 + kk * cote, cote);
                    for (int jj = ja; jj <= jb; jj++) {
                        double ey = ecart(y, y0 + jj * cote, cote);
                        int ligne = (kk * ny + jj) * nx;
                        for (int ii = ia; ii <= ib; ii++) {
                            double ex = ecart(x, x0 + ii * cote, cote);
                            if (ex * ex + ey * ey + ez * ez <= r2) {
                                if (passe == 0) {
                                    nombres[ligne + ii]++;
                                } else {
                                    liste[fins[ligne + ii]++] = k;
                                }
                            }
                        }
                    }
                }
            }
            if (passe == 0) {
                for (int i = 0; i < nombres.length; i++) {
                    int n = nombres[i];
                    nombres[i] = total;
                    total += n;
                }
                liste = new int[total];
                fins = Arrays.copyOf(nombres, nombres.length);
            }
        }
        debut = nombres;
        entrees = liste;
    }

    private static double ecart(double x, double bas, double cote) {
        return Math.max(0, Math.max(bas - x, x - bas - cote));
    }

    private static int rang(double x, int n) {
        return x <= 0 ? 0 : x >= n ? n - 1 : (int) x;
    }

    @Override
    public int plusProche(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz, int sauf) {
        if (!(Math.max(Math.abs(px), Math.max(Math.abs(py), Math.abs(pz))) <= DEPART_MAX * portee)) {
            return secours.plusProche(sonde, px, py, pz, vx, vy, vz, sauf);
        }
        double[] g = spheres.geometrie;
        sonde.distance = Double.MAX_VALUE;
        sonde.trouvee = -1;
        for (int k : grosses) {
            if (k != sauf) {
                sonde.compteurs.testsSpheres++;
                int s = Spheres.PAS * k;
                double d = Sphere.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
                sonde.retenir(spheres, k, d, px, py, pz, vx, vy, vz);
            }
        }
        int k = marcher(sonde, px, py, pz, vx, vy, vz, sauf, false);
        while (k >= 0) {
            sonde.retenir(spheres, k, sonde.doute, px, py, pz, vx, vy, vz);
            k = marcher(sonde, px, py, pz, vx, vy, vz, sauf, true);
        }
        if (sonde.trouvee < 0) {
            sonde.distance = Constantes.INFINI;
        }
        return sonde.trouvee;
    }

    /**
     * Traverse les cases, en retenant dans la sonde la sphère la plus proche, jusqu'à la dernière case utile ou jusqu'à
     * une sphère en doute. Elle ne contient aucun appel : à cause de lui, même jamais fait, tout ce que la boucle tient
     * en registres irait en mémoire.
     *
     * @param reprise vrai pour repartir d'où la marche précédente s'est arrêtée
     * @return la sphère en doute, à trancher avant de reprendre ; -1 quand c'est fini
     */
    private int marcher(Sonde sonde, double px, double py, double pz, double vx, double vy, double vz, int sauf,
            boolean reprise) {
        double[] g = spheres.geometrie;
        double distance = sonde.distance;
        int trouvee = sonde.trouvee;
        double ix = Arbre.inverse(vx);
        double iy = Arbre.inverse(vy);
        double iz = Arbre.inverse(vz);
        double tx;
        double ty;
        double tz;
        int resteX;
        int resteY;
        int resteZ;
        int c;
        int e;
        int tests = 0;
        int cases = 0;
        if (reprise) {
            tx = sonde.tx;
            ty = sonde.ty;
            tz = sonde.tz;
            resteX = sonde.resteX;
            resteY = sonde.resteY;
            resteZ = sonde.resteZ;
            c = sonde.arretCase;
            e = sonde.arretEntree;
        } else {
            double entree = Math.max(Math.max(((ix < 0 ? x1 : x0) - px) * ix, ((iy < 0 ? y1 : y0) - py) * iy),
                    Math.max(((iz < 0 ? z1 : z0) - pz) * iz, 0));
            double sortie = Math.min(Math.min(((ix < 0 ? x0 : x1) - px) * ix, ((iy < 0 ? y0 : y1) - py) * iy),
                    Math.min(((iz < 0 ? z0 : z1) - pz) * iz, distance));
            if (!(entree <= sortie)) {
                return -1;
            }
            int i = rang((px + entree * vx - x0) * parCote, nx);
            int j = rang((py + entree * vy - y0) * parCote, ny);
            int k3 = rang((pz + entree * vz - z0) * parCote, nz);
            tx = (x0 + (ix < 0 ? i : i + 1) * cote - px) * ix;
            ty = (y0 + (iy < 0 ? j : j + 1) * cote - py) * iy;
            tz = (z0 + (iz < 0 ? k3 : k3 + 1) * cote - pz) * iz;
            resteX = ix < 0 ? i : nx - 1 - i;
            resteY = iy < 0 ? j : ny - 1 - j;
            resteZ = iz < 0 ? k3 : nz - 1 - k3;
            c = (k3 * ny + j) * nx + i;
            e = debut[c];
            cases++;
        }
        int pasX = ix < 0 ? -1 : 1;
        int pasY = iy < 0 ? -nx : nx;
        int pasZ = iz < 0 ? -nx * ny : nx * ny;
        double sautX = cote * Math.abs(ix);
        double sautY = cote * Math.abs(iy);
        double sautZ = cote * Math.abs(iz);
        int douteuse = -1;
        marche:
        while (true) {
            int fin = debut[c + 1];
            for (; e < fin; e++) {
                int k = entrees[e];
                if (k == sauf) {
                    continue;
                }
                tests++;
                int s = Spheres.PAS * k;
                double d = Sphere.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
                if (d <= distance && spheres.avant(d, k, distance, trouvee)) {
                    if (d < 0) {
                        if (Doute.auMoins(d) > distance) {
                            continue;
                        }
                        douteuse = k;
                        sonde.doute = d;
                        sonde.tx = tx;
                        sonde.ty = ty;
                        sonde.tz = tz;
                        sonde.resteX = resteX;
                        sonde.resteY = resteY;
                        sonde.resteZ = resteZ;
                        sonde.arretCase = c;
                        sonde.arretEntree = e + 1;
                        break marche;
                    }
                    distance = d;
                    trouvee = k;
                }
            }
            if (tx < ty) {
                if (tx < tz) {
                    if (tx > distance || --resteX < 0) {
                        break;
                    }
                    tx += sautX;
                    c += pasX;
                    e = debut[c];
                    cases++;
                    continue;
                }
            } else if (ty < tz) {
                if (ty > distance || --resteY < 0) {
                    break;
                }
                ty += sautY;
                c += pasY;
                e = debut[c];
                cases++;
                continue;
            }
            if (tz > distance || --resteZ < 0) {
                break;
            }
            tz += sautZ;
            c += pasZ;
            e = debut[c];
            cases++;
        }
        sonde.compteurs.testsSpheres += tests;
        sonde.compteurs.noeudsVisites += cases;
        sonde.distance = distance;
        sonde.trouvee = trouvee;
        return douteuse;
    }
}
