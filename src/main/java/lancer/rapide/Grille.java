package lancer.rapide;

import java.util.Arrays;
import lancer.Constantes;
import lancer.contrat.Recherche;
import lancer.precision.Intersection;

/**
 * Grille régulière, dont un rayon traverse les cases l'une après l'autre (Amanatides et Woo, 1987). Pour les rayons
 * réfléchis, souvent courts, elle est plus rapide que l'arbre. Elle suppose que les sphères ont des
 * tailles et des écarts comparables : les quelques sphères démesurées sont examinées à part.
 */
final class Grille implements Intersections {

    /** Nombre de cases par sphère. */
    private static final double DENSITE = 2;

    /** Nombre maximal de sphères démesurées ({@link Demesurees}). */
    private static final int GROSSES_MAX = 8;

    /** Nombres de cases des boîtes englobantes et de places, par sphère, au-delà desquels la grille est refusée. */
    private static final int BOITES_PAR_SPHERE = 64;
    private static final int PLACES_PAR_SPHERE = 12;

    /**
     * Élargissement des sphères, relatif à la plus grande coordonnée. Il couvre les arrondis de {@link Noeuds#MARGE} et
     * ceux d'une traversée par addition de pas. Un départ est au plus {@link #DEPART_MAX} fois plus loin que la grille.
     */
    private static final double MARGE = 0x1.0p-34;
    private static final double DEPART_MAX = 64;

    /** Réponses de {@link #marcher} : la traversée est finie, ou le crédit est épuisé. */
    private static final int TERMINEE = -1;
    private static final int COMPTE_VIDE = -2;

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
    private final double marge;
    /** La première place de chaque case dans {@link #entrees}. */
    private int[] debut;
    int[] entrees;
    /** Arbre qui répond si le rayon part de trop loin ou si le crédit est épuisé. */
    private final Arbre secours;

    private Grille(Spheres spheres, int[] lesquelles, int[] grosses, Arbre secours) {
        this.spheres = spheres;
        this.grosses = grosses;
        this.secours = secours;
        Boite boite = Boite.de(spheres, lesquelles);
        portee = boite.portee();
        marge = MARGE * portee;
        double dx = boite.xMax - boite.xMin;
        double dy = boite.yMax - boite.yMin;
        double dz = boite.zMax - boite.zMin;
        double cases = DENSITE * lesquelles.length;
        double c = Math.max(Math.cbrt(dx * dy * dz / cases), Math.max(dx, Math.max(dy, dz)) / 512);
        // une scène plate aurait trop de cases : elles sont agrandies
        while ((dx / c + 1) * (dy / c + 1) * (dz / c + 1) > 4 * cases + 64) {
            c *= 1.25;
        }
        nx = (int) (dx / c) + 1;
        ny = (int) (dy / c) + 1;
        nz = (int) (dz / c) + 1;
        cote = Math.max(Math.max(dx / nx, dy / ny), dz / nz) + 4 * marge;
        parCote = 1 / cote;
        // la grille est centrée sur la boîte
        x0 = (boite.xMin + boite.xMax - nx * cote) / 2;
        y0 = (boite.yMin + boite.yMax - ny * cote) / 2;
        z0 = (boite.zMin + boite.zMax - nz * cote) / 2;
        x1 = x0 + nx * cote;
        y1 = y0 + ny * cote;
        z1 = z0 + nz * cote;
    }

    /** La grille de ces sphères ; {@code null} si elles occupent trop de cases, ou si trop sont démesurées. */
    static Grille de(Spheres spheres, Arbre secours) {
        Demesurees demesurees = new Demesurees(spheres);
        int[] lesquelles = new int[spheres.nombre];
        int[] grosses = new int[GROSSES_MAX];
        int m = 0;
        for (int k = 0; k < spheres.nombre; k++) {
            if (!demesurees.contient(k)) {
                lesquelles[m++] = k;
            } else if (k - m == GROSSES_MAX) {
                return null;
            } else {
                grosses[k - m] = k;
            }
        }
        if (m == 0) {
            return null;
        }
        lesquelles = Arrays.copyOf(lesquelles, m);
        Grille grille = new Grille(spheres, lesquelles, Arrays.copyOf(grosses, spheres.nombre - m), secours);
        return grille.remplir(lesquelles) ? grille : null;
    }

    /** Note chaque sphère dans les cases qu'elle touche. @return faux si elles sont trop nombreuses */
    private boolean remplir(int[] lesquelles) {
        debut = new int[nx * ny * nz + 1];
        long cases = 0;
        for (int k : lesquelles) {
            Recherche.obeir();
            cases += noter(k);
            if (cases > (long) BOITES_PAR_SPHERE * lesquelles.length) {
                return false;
            }
        }
        int total = Tri.cumuler(debut);
        if (total > PLACES_PAR_SPHERE * (long) lesquelles.length) {
            return false;
        }
        entrees = new int[total];
        // de la dernière à la première, car chaque case se remplit par la fin
        for (int q = lesquelles.length - 1; q >= 0; q--) {
            Recherche.obeir();
            noter(lesquelles[q]);
        }
        return true;
    }

    /** Compte une sphère dans les cases qu'elle touche, ou l'y place. @return le nombre de cases de sa boîte */
    private long noter(int k) {
        double[] g = spheres.geometrie;
        int s = Spheres.PAS * k;
        double x = g[s];
        double y = g[s + 1];
        double z = g[s + 2];
        double r = g[s + 3] + marge;
        int ia = Face.rang((x - r - x0) * parCote, nx);
        int ib = Face.rang((x + r - x0) * parCote, nx);
        int ja = Face.rang((y - r - y0) * parCote, ny);
        int jb = Face.rang((y + r - y0) * parCote, ny);
        int ka = Face.rang((z - r - z0) * parCote, nz);
        int kb = Face.rang((z + r - z0) * parCote, nz);
        for (int kk = ka; kk <= kb; kk++) {
            double ez = ecart(z, z0 + kk * cote, cote);
            for (int jj = ja; jj <= jb; jj++) {
                double ey = ecart(y, y0 + jj * cote, cote);
                int ligne = (kk * ny + jj) * nx;
                for (int ii = ia; ii <= ib; ii++) {
                    double ex = ecart(x, x0 + ii * cote, cote);
                    if (ex * ex + ey * ey + ez * ez <= r * r) {
                        if (entrees == null) {
                            debut[ligne + ii]++;
                        } else {
                            entrees[--debut[ligne + ii]] = k;
                        }
                    }
                }
            }
        }
        return (ib - ia + 1L) * (jb - ja + 1) * (kb - ka + 1);
    }

    private static double ecart(double x, double bas, double cote) {
        return Math.max(0, Math.max(bas - x, x - bas - cote));
    }

    @Override
    public int plusProche(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            int sauf) {
        if (!(Math.max(Math.abs(px), Math.max(Math.abs(py), Math.abs(pz))) <= DEPART_MAX * portee)) {
            return secours.plusProche(etat, px, py, pz, vx, vy, vz, sauf);
        }
        etat.distance = Double.MAX_VALUE;
        etat.trouvee = -1;
        etat.credit += EtatDeRecherche.PAR_RAYON - grosses.length;
        for (int grosse : grosses) {
            if (grosse != sauf) {
                etat.compteurs.testsSpheres++;
                etat.retenir(spheres, grosse, px, py, pz, vx, vy, vz);
            }
        }
        etat.haut = 0;
        int k = marcher(etat, px, py, pz, vx, vy, vz, sauf);
        while (k >= 0 && etat.haut < etat.pile.length) {
            etat.pile[etat.haut++] = k;
            etat.retenir(spheres, k, px, py, pz, vx, vy, vz);
            k = marcher(etat, px, py, pz, vx, vy, vz, sauf);
        }
        if (k != TERMINEE) {
            return secours.plusProche(etat, px, py, pz, vx, vy, vz, sauf);
        }
        if (etat.trouvee < 0) {
            etat.distance = Constantes.INFINI;
        }
        return etat.trouvee;
    }

    /**
     * Traverse les cases, et retient dans {@code etat} la sphère la plus proche. S'arrête après la dernière case utile,
     * sur une sphère en doute (tranchée ailleurs : voir docs/etendre.md), ou quand le crédit est épuisé.
     *
     * @return la sphère en doute, à trancher et à noter dans la pile, {@link #TERMINEE} ou {@link #COMPTE_VIDE}
     */
    private int marcher(EtatDeRecherche etat, double px, double py, double pz, double vx, double vy, double vz,
            int sauf) {
        double[] g = spheres.geometrie;
        double distance = etat.distance;
        int trouvee = etat.trouvee;
        double ix = Arbre.inverse(vx);
        double iy = Arbre.inverse(vy);
        double iz = Arbre.inverse(vz);
        double entree = Math.max(Math.max(((ix < 0 ? x1 : x0) - px) * ix, ((iy < 0 ? y1 : y0) - py) * iy),
                Math.max(((iz < 0 ? z1 : z0) - pz) * iz, 0));
        double sortie = Math.min(Math.min(((ix < 0 ? x0 : x1) - px) * ix, ((iy < 0 ? y0 : y1) - py) * iy),
                Math.min(((iz < 0 ? z0 : z1) - pz) * iz, distance));
        if (!(entree <= sortie)) {
            return TERMINEE;
        }
        // case d'entrée, et distances où le rayon en sort par chaque axe
        int i = Face.rang((px + entree * vx - x0) * parCote, nx);
        int j = Face.rang((py + entree * vy - y0) * parCote, ny);
        int k3 = Face.rang((pz + entree * vz - z0) * parCote, nz);
        double tx = (x0 + (ix < 0 ? i : i + 1) * cote - px) * ix;
        double ty = (y0 + (iy < 0 ? j : j + 1) * cote - py) * iy;
        double tz = (z0 + (iz < 0 ? k3 : k3 + 1) * cote - pz) * iz;
        int resteX = ix < 0 ? i : nx - 1 - i;
        int resteY = iy < 0 ? j : ny - 1 - j;
        int resteZ = iz < 0 ? k3 : nz - 1 - k3;
        int c = (k3 * ny + j) * nx + i;
        // pas d'une case à la suivante, par axe
        int pasX = ix < 0 ? -1 : 1;
        int pasY = iy < 0 ? -nx : nx;
        int pasZ = iz < 0 ? -nx * ny : nx * ny;
        double sautX = cote * Math.abs(ix);
        double sautY = cote * Math.abs(iy);
        double sautZ = cote * Math.abs(iz);
        int permis = (int) Math.min(etat.credit, Integer.MAX_VALUE);
        int tests = 0;
        int cases = 0;
        int reponse = TERMINEE;
        marche:
        while (true) {
            int e = debut[c];
            int fin = debut[c + 1];
            if (tests + cases + fin - e >= permis) {
                reponse = COMPTE_VIDE;
                break;
            }
            cases++;
            for (; e < fin; e++) {
                int k = entrees[e];
                if (k == sauf) {
                    continue;
                }
                tests++;
                int s = Spheres.PAS * k;
                double d = Intersection.distanceOuDoute(px, py, pz, vx, vy, vz, g[s], g[s + 1], g[s + 2], g[s + 3]);
                if (d <= distance && Spheres.avant(d, k, distance, trouvee)) {
                    if (d < 0) {
                        int t = etat.haut - 1;
                        while (t >= 0 && etat.pile[t] != k) {
                            t--;
                        }
                        if (t >= 0 || Intersection.auMoins(d) > distance) {
                            continue;
                        }
                        reponse = k;
                        break marche;
                    }
                    distance = d;
                    trouvee = k;
                }
            }
            // le rayon sort de la case par l'axe de la plus petite distance
            if (tx < ty && tx < tz) {
                if (tx > distance || --resteX < 0) {
                    break;
                }
                tx += sautX;
                c += pasX;
            } else if (ty < tz) {
                if (ty > distance || --resteY < 0) {
                    break;
                }
                ty += sautY;
                c += pasY;
            } else {
                if (tz > distance || --resteZ < 0) {
                    break;
                }
                tz += sautZ;
                c += pasZ;
            }
        }
        etat.credit -= tests + cases;
        etat.compteurs.testsSpheres += tests;
        etat.compteurs.noeudsVisites += cases;
        etat.distance = distance;
        etat.trouvee = trouvee;
        return reponse;
    }
}
