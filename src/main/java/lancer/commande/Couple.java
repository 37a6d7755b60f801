package lancer.commande;

/** Deux entiers : une taille ou une place, en pixels. */
public final class Couple {

    public final int x;
    public final int y;

    public Couple(int x, int y) {
        this.x = x;
        this.y = y;
    }

    @Override
    public boolean equals(Object autre) {
        return autre instanceof Couple && x == ((Couple) autre).x && y == ((Couple) autre).y;
    }

    @Override
    public int hashCode() {
        return 31 * x + y;
    }
}
