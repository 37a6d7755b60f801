package lancer.rapide;

import lancer.Camera;
import lancer.Constantes;
import lancer.Rayon;
import lancer.contrat.Compteurs;

/**
 * Le garde-fou : quelques rayons de l'image, semés sur une grille de pixels, disent ce que coûte chaque structure. Là où elle
 * coûte plus qu'un bon arbre, on construit l'arbre, on lui pose les mêmes questions, et le moins cher reste. Aucune scène ne
 * tombe ainsi dans un trou (sol immense, amas dispersés), et l'arbre n'est pas construit là où il ne servirait pas.
 */
final class Choix {

    /** Rayons semés par côté de l'image, et réflexions suivies. */
    private static final int SEMIS = 24;
    private static final int REFLETS = 2;

    /**
     * Sphères et cases examinées par question, au-dessous desquelles l'arbre ne ferait pas mieux. À 24, le flocon de 7381 boules, qui
     * en examine 26 par reflet, construirait le sien pour rien : 38 ms, sur 560 pour tout le programme.
     */
    private static final double BON_MARCHE = 32;

    private final Spheres spheres;
    private final Sonde sonde = new Sonde(new Compteurs());

    /** Les questions posées, l'une derrière l'autre : départ, direction, et sphère ou longueur. */
    private static final int PAS = 8;

    Choix(Spheres spheres) {
        this.spheres = spheres;
    }

    /** Ce que vaut chaque sorte de question. */
    private static final class Questions {
        private double[] rayons = new double[PAS * SEMIS * SEMIS];
        private int nombre;
        private long cout;

        void noter(double px, double py, double pz, double vx, double vy, double vz, double longueur, int sauf) {
            if (PAS * (nombre + 1) > rayons.length) {
                rayons = java.util.Arrays.copyOf(rayons, 2 * rayons.length);
            }
            double[] q = {px, py, pz, vx, vy, vz, longueur, sauf};
            System.arraycopy(q, 0, rayons, PAS * nombre++, PAS);
        }

        boolean cheres() {
            return cout > BON_MARCHE * nombre;
        }
    }

    /** Remplace par {@code arbre}, dans {@code premiers}, {@code suivants} et {@code obstacles}, ce qui coûte plus que lui. */
    void faire(Camera camera, double[] lampes, Voisins[] premiersEtSuivants, Obstacles[] obstacles, Secours arbre) {
        Questions[] vues = {new Questions(), new Questions()};
        Questions[] ombres = new Questions[obstacles.length];
        for (int l = 0; l < ombres.length; l++) {
            ombres[l] = new Questions();
        }
        for (int j = 0; j < SEMIS; j++) {
            for (int i = 0; i < SEMIS; i++) {
                semer(camera.getRayon((i + 0.5) * camera.getLargeur() / SEMIS, (j + 0.5) * camera.getHauteur() / SEMIS),
                        premiersEtSuivants, vues, lampes, obstacles, ombres);
            }
        }
        for (int s = 0; s < 2; s++) {
            if (premiersEtSuivants[s] != arbre && vues[s].cheres() && cout(arbre, vues[s]) < vues[s].cout) {
                premiersEtSuivants[s] = arbre;
            }
        }
        for (int l = 0; l < ombres.length; l++) {
            if (obstacles[l] != arbre && ombres[l].cheres() && coutOmbre(arbre, ombres[l]) < ombres[l].cout) {
                obstacles[l] = arbre;
            }
        }
    }

    private void semer(Rayon rayon, Voisins[] voisins, Questions[] vues, double[] lampes, Obstacles[] obstacles,
            Questions[] ombres) {
        double px = rayon.getP().x;
        double py = rayon.getP().y;
        double pz = rayon.getP().z;
        double vx = rayon.getV().x;
        double vy = rayon.getV().y;
        double vz = rayon.getV().z;
        int sauf = -1;
        for (int niveau = 0; niveau <= REFLETS; niveau++) {
            int sorte = Math.min(niveau, 1);
            long avant = examines();
            int k = voisins[sorte].plusProche(sonde, px, py, pz, vx, vy, vz, sauf);
            vues[sorte].cout += examines() - avant;
            vues[sorte].noter(px, py, pz, vx, vy, vz, Constantes.INFINI, sauf);
            if (k < 0) {
                return;
            }
            px += sonde.distance * vx;
            py += sonde.distance * vy;
            pz += sonde.distance * vz;
            int s = Spheres.PAS * k;
            double[] g = spheres.geometrie;
            double nx = (px - g[s]) / g[s + 3];
            double ny = (py - g[s + 1]) / g[s + 3];
            double nz = (pz - g[s + 2]) / g[s + 3];
            for (int l = 0; l < obstacles.length; l++) {
                double lx = px - lampes[3 * l];
                double ly = py - lampes[3 * l + 1];
                double lz = pz - lampes[3 * l + 2];
                double d = Math.sqrt(lx * lx + ly * ly + lz * lz);
                if (nx * lx + ny * ly + nz * lz < 0 && d > 0 && d < Constantes.INFINI) {
                    avant = examines();
                    obstacles[l].cachee(sonde, lampes[3 * l], lampes[3 * l + 1], lampes[3 * l + 2], lx / d, ly / d, lz / d, d, k);
                    ombres[l].cout += examines() - avant;
                    ombres[l].noter(lampes[3 * l], lampes[3 * l + 1], lampes[3 * l + 2], lx / d, ly / d, lz / d, d, k);
                }
            }
            double vn = 2 * (vx * nx + vy * ny + vz * nz);
            vx -= vn * nx;
            vy -= vn * ny;
            vz -= vn * nz;
            double n = Math.sqrt(vx * vx + vy * vy + vz * vz);
            if (!(n > 0 && n < Constantes.INFINI)) {
                return;
            }
            vx /= n;
            vy /= n;
            vz /= n;
            sauf = k;
        }
    }

    private long examines() {
        return sonde.compteurs.testsSpheres + sonde.compteurs.noeudsVisites;
    }

    private long cout(Voisins arbre, Questions questions) {
        long avant = examines();
        double[] q = questions.rayons;
        for (int i = 0; i < PAS * questions.nombre; i += PAS) {
            arbre.plusProche(sonde, q[i], q[i + 1], q[i + 2], q[i + 3], q[i + 4], q[i + 5], (int) q[i + 7]);
        }
        return examines() - avant;
    }

    private long coutOmbre(Obstacles arbre, Questions questions) {
        long avant = examines();
        double[] q = questions.rayons;
        for (int i = 0; i < PAS * questions.nombre; i += PAS) {
            arbre.cachee(sonde, q[i], q[i + 1], q[i + 2], q[i + 3], q[i + 4], q[i + 5], q[i + 6], (int) q[i + 7]);
        }
        return examines() - avant;
    }
}
