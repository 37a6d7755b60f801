package lancer.atelier;

import java.io.IOException;
import java.util.Arrays;

/** Des boules rangées comme les graines d'un tournesol, sur un sol : n boules, et celle du sol. */
final class Tournesol {

    /** De chaque graine à la suivante : le cercle partagé selon le nombre d'or, comme le fait le tournesol (Vogel, 1979). */
    private static final double ANGLE_D_OR = Math.PI * (3 - Math.sqrt(5));

    /** Distance de la dernière graine à l'axe, en unités de la scène. */
    private static final double RAYON = 2.95;

    /** Les graines grossissent du cœur au bord : distance à l'axe comme rang^0,6 ; 0,5 les ferait égales. */
    private static final double CROISSANCE = 0.6;

    /** Rayon d'une boule, en part du côté de la surface plane qui lui revient ; au-delà, des voisines se toucheraient. */
    private static final double PART = 0.46;

    /** Rang de la première graine : près de l'axe la formule les serrerait trop. */
    private static final double RANG = 2;

    private static final double SOL = 20000;
    private static final double Y = 0.1;
    private static final double Z = 10.2;
    private static final double PENTE = Math.toRadians(40);

    private static final int TEINTES = 64;

    private Tournesol() {
    }

    static void ecrire(Plume plume, int n) throws IOException {
        plume.commentaires("Un tournesol de " + n + " boules, rangées comme ses graines, sur un sol sombre et poli.", "",
                "À regarder :",
                "- les spirales : personne ne les a tracées, chaque boule est seulement tournée de 137,5 degrés après la",
                "  précédente ; on en compte toujours un nombre de Fibonacci : 21, 34, 55 selon le sens et la distance au cœur ;",
                "- les ombres et les reflets entre voisines, et la fleur entière dans le sol ;",
                "- le temps du dessin : chaque rayon a " + n + " boules à essayer si la recherche est simple.", "",
                "Écrite par lancer.atelier.Generateur tournesol " + n);
        double cos = StrictMath.cos(PENTE);
        double sin = StrictMath.sin(PENTE);
        plume.sphere("sol", 0, Y - SOL * cos, Z + SOL * sin, SOL,
                Plume.materiau(new double[] {0.06, 0.08, 0.10}, new double[] {0.28, 0.25, 0.16}, 60));
        String[] materiaux = new String[TEINTES];
        Arrays.setAll(materiaux, i -> materiau(i / (TEINTES - 1.0)));
        for (int i = 0; i < n; i++) {
            double part = (i + RANG) / (n + RANG);
            double rho = StrictMath.pow(part, CROISSANCE);
            double aire = 2 * Math.PI * CROISSANCE * StrictMath.pow(part, 2 * CROISSANCE - 1) / (n + RANG);
            double rayon = RAYON * PART * Math.sqrt(aire);
            double angle = i * ANGLE_D_OR;
            double a = RAYON * rho * StrictMath.cos(angle);
            double b = RAYON * rho * StrictMath.sin(angle);
            double h = rayon + hauteur(rho);
            plume.sphere("" + (i + 1), a, Y + h * cos + b * sin, Z - h * sin + b * cos, rayon,
                    materiaux[(int) Math.min(TEINTES - 1, rho * TEINTES)]);
        }
        plume.lampe("soleil", -300, 330, -230, 1.15, 1.06, 0.94);
        plume.lampe("appoint", 380, 160, -160, 0.34, 0.36, 0.42);
    }

    /** Le profil de la fleur : un dôme qui retombe jusqu'au sol, creusé au cœur. */
    private static double hauteur(double rho) {
        return 1.15 * (1 - rho * rho) - 0.35 * StrictMath.exp(-rho * rho / 0.035);
    }

    /** Du jaune du cœur au turquoise du bord, par le rouge, le rose, le violet et le bleu. */
    private static String materiau(double rho) {
        double[] kd = Plume.couleur(0.14 - 0.64 * rho, 0.86 - 0.14 * rho, 0.78);
        return Plume.materiau(kd, Plume.couleur(0, 0, 0.2), 80);
    }
}
