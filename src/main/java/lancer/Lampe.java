package lancer;

/** Une lampe ponctuelle. Sa lumière est la même dans toutes les directions et à toute distance. Immuable. */
public class Lampe {

    private final Point position;
    private final Couleur couleur;

    /**
     * @param position en unités de la scène
     * @param couleur K_L, couleur et intensité ; une composante peut dépasser 1
     */
    public Lampe(Point position, Couleur couleur) {
        this.position = position;
        this.couleur = couleur;
    }

    public Point getPosition() {
        return position;
    }

    public Couleur getCouleur() {
        return couleur;
    }

    @Override
    public String toString() {
        return "Lampe(" + position + ", " + couleur + ")";
    }
}
