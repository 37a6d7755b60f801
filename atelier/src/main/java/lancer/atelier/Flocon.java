package lancer.atelier;

import java.io.IOException;

/** Voir {@link Generateur#flocon}. */
final class Flocon {

    /** Le flocon tient dans une boule deux fois plus grande que la première : ici, juste dans l'image. */
    private static final double RAYON = 1.5;
    private static final double Y = -0.12;
    private static final double Z = 11;

    /** Les neuf directions, l'axe étant z : six à l'équateur, trois à cette hauteur. */
    private static final double HAUTEUR = Math.sqrt(2.0 / 3.0);
    private static final double[][] DIRECTIONS = new double[9][];

    static {
        for (int i = 0; i < 6; i++) {
            DIRECTIONS[i] = direction(i * Math.PI / 3, 0);
        }
        for (int i = 0; i < 3; i++) {
            DIRECTIONS[6 + i] = direction(Math.PI / 6 + i * 2 * Math.PI / 3, HAUTEUR);
        }
    }

    private final Plume plume;
    private final int profondeur;
    private final String[] materiaux;

    Flocon(Plume plume, int profondeur) {
        this.plume = plume;
        this.profondeur = profondeur;
        materiaux = new String[profondeur + 1];
        for (int i = 0; i <= profondeur; i++) {
            // de l'or au bleu, une teinte par génération
            double[] kd = Teinte.couleur(0.11 - 0.15 * i, 0.72, 0.62);
            materiaux[i] = Plume.materiau(kd, Teinte.gris(0.35), 60);
        }
    }

    void ecrire() throws IOException {
        plume.commentaires("Un flocon de sphères : chaque boule en porte neuf, trois fois plus petites, et ainsi "
                        + profondeur + " fois.", "",
                "À regarder : les reflets de chaque génération dans les autres. Pour mesurer : le nombre de sphères est",
                "multiplié par neuf à chaque génération, le temps bien moins si la recherche est rapide.", "",
                "Écrite par lancer.atelier.Generateur flocon " + profondeur);
        double norme = Math.sqrt(0.2 * 0.2 + 0.8 * 0.8 + 0.55 * 0.55);
        boule(0, Y, Z, RAYON, 0.2 / norme, 0.8 / norme, -0.55 / norme, 0);
        plume.lampe("principale", -40, 60, -50, 1, 0.95, 0.86);
        plume.lampe("appoint", 50, 20, -20, 0.35, 0.4, 0.5);
        plume.vider();
    }

    /** Une boule et toutes celles qu'elle porte ; (ax, ay, az) est la direction où elle a poussé, de longueur 1. */
    private void boule(double x, double y, double z, double rayon, double ax, double ay, double az, int generation)
            throws IOException {
        plume.sphere(x, y, z, rayon, materiaux[generation]);
        if (generation == profondeur) {
            return;
        }
        // u et v complètent l'axe en un repère ; u est normal à x, ou à y si l'axe est trop près de x
        boolean versX = Math.abs(ax) < 0.6;
        double ux = versX ? 0 : az;
        double uy = versX ? -az : 0;
        double uz = versX ? ay : -ax;
        double norme = Math.sqrt(ux * ux + uy * uy + uz * uz);
        ux /= norme;
        uy /= norme;
        uz /= norme;
        double vx = ay * uz - az * uy;
        double vy = az * ux - ax * uz;
        double vz = ax * uy - ay * ux;
        double ecart = rayon + rayon / 3;
        for (double[] d : DIRECTIONS) {
            double wx = d[0] * ux + d[1] * vx + d[2] * ax;
            double wy = d[0] * uy + d[1] * vy + d[2] * ay;
            double wz = d[0] * uz + d[1] * vz + d[2] * az;
            boule(x + ecart * wx, y + ecart * wy, z + ecart * wz, rayon / 3, wx, wy, wz, generation + 1);
        }
    }

    private static double[] direction(double angle, double hauteur) {
        double r = Math.sqrt(1 - hauteur * hauteur);
        return new double[] {r * StrictMath.cos(angle), r * StrictMath.sin(angle), hauteur};
    }
}
