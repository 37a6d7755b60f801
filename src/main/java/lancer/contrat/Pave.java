package lancer.contrat;

/** Un rectangle de pixels, que dessine un seul fil. Immuable. */
public final class Pave {

    /** Côté d'un pavé du dessin, en pixels ; les pavés du bord peuvent être plus petits. */
    public static final int COTE = 32;

    /** Première colonne, première ligne ; dernière colonne et dernière ligne, plus un. */
    public final int i0;
    public final int j0;
    public final int i1;
    public final int j1;

    public Pave(int i0, int j0, int i1, int j1) {
        this.i0 = i0;
        this.j0 = j0;
        this.i1 = i1;
        this.j1 = j1;
    }

    /** Nombre de pavés de l'image. */
    public static int nombre(int largeur, int hauteur) {
        return entiers(largeur) * entiers(hauteur);
    }

    /** Pavé de rang {@code k}, ligne par ligne. */
    public static Pave deRang(int k, int largeur, int hauteur) {
        return autour(k % entiers(largeur) * COTE, k / entiers(largeur) * COTE, largeur, hauteur);
    }

    /** Pavé du dessin qui contient ce pixel. */
    public static Pave autour(int x, int y, int largeur, int hauteur) {
        int i0 = x / COTE * COTE;
        int j0 = y / COTE * COTE;
        return new Pave(i0, j0, Math.min(i0 + COTE, largeur), Math.min(j0 + COTE, hauteur));
    }

    private static int entiers(int pixels) {
        return (pixels + COTE - 1) / COTE;
    }
}
