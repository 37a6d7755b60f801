package lancer.antialias;

import lancer.Couleur;

/** Ce dont les couleurs d'un pavé surprennent : chacune est comparée à quatre autres. Un seul fil l'utilise. */
final class Surprise {

    private double somme;
    private int nombre;
    /** Les deux plus grands carrés. */
    private double premier;
    private double deuxieme;

    /**
     * Note le carré de ce dont une couleur sort de l'étendue de quatre autres. Un bord ou un dégradé, même courbe, n'y
     * est presque rien ; un détail plus petit qu'une case surprend, et en laisse deviner d'autres, jamais vus.
     */
    void comparer(Couleur vue, Couleur a, Couleur b, Couleur c, Couleur d) {
        double carre = (carre(vue.r, a.r, b.r, c.r, d.r) + carre(vue.v, a.v, b.v, c.v, d.v)
                + carre(vue.b, a.b, b.b, c.b, d.b)) / 3;
        somme += carre;
        nombre++;
        deuxieme = Math.max(deuxieme, Math.min(premier, carre));
        premier = Math.max(premier, carre);
    }

    private static double carre(double vue, double a, double b, double c, double d) {
        double min = Math.min(Math.min(a, b), Math.min(c, d));
        double max = Math.max(Math.max(a, b), Math.max(c, d));
        double dehors = Coins.limite(vue) - Coins.limite(Math.max(min, Math.min(max, vue)));
        return dehors * dehors;
    }

    /** Dit si la moyenne quadratique dépasse cette limite. */
    boolean depasse(double limite) {
        return somme > limite * limite * nombre;
    }

    /**
     * Ce que ce pavé laisse craindre des autres. Ce qui n'a été vu qu'une fois mesure ce qui ne l'a pas été (I. J.
     * Good, <i>The population frequencies of species</i>, 1953) : le carré d'un point, s'il dépasse la limite à lui
     * seul et qu'il est le seul du pavé, en limites² ; moins la moitié du nombre de points comparés.
     */
    double getSoupcon(double limite) {
        double tous = limite * limite * nombre;
        return (premier > tous && deuxieme <= tous ? premier / (limite * limite) : 0) - nombre / 2.0;
    }
}
