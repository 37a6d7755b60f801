package lancer.mesures.trace;

import lancer.mesures.Intervalle;

/** Un point mesuré. Une barre montre l'intervalle de chaque coordonnée. Les méthodes complètent ce point et le rendent. */
public final class Marque {

    public final Intervalle x;
    public final Intervalle y;

    /** Texte écrit à côté ; vide s'il n'y en a pas. */
    String etiquette = "";

    /** Faux pour un point sans intérêt, dessiné en creux. */
    boolean pleine = true;

    public Marque(Intervalle x, Intervalle y) {
        this.x = x.montrable();
        this.y = y.montrable();
    }

    public static Marque en(double x, double y) {
        return new Marque(Intervalle.exact(x), Intervalle.exact(y));
    }

    public Marque nommee(String texte) {
        etiquette = texte;
        return this;
    }

    public Marque creuse() {
        pleine = false;
        return this;
    }
}
