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

    /** Nombre de pavés de l'image. @param cote leur côté, en pixels */
    public static int nombre(int largeur, int hauteur, int cote) {
        return enColonnes(largeur, cote) * enColonnes(hauteur, cote);
    }

    /** Pavé de rang {@code k} parmi ceux de ce côté, ligne par ligne. */
    public static Pave deRang(int k, int largeur, int hauteur, int cote) {
        int i0 = k % enColonnes(largeur, cote) * cote;
        int j0 = k / enColonnes(largeur, cote) * cote;
        return new Pave(i0, j0, Math.min(i0 + cote, largeur), Math.min(j0 + cote, hauteur));
    }

    /** Pavé du dessin qui contient ce pixel. */
    public static Pave autour(int x, int y, int largeur, int hauteur) {
        return deRang(y / COTE * enColonnes(largeur, COTE) + x / COTE, largeur, hauteur, COTE);
    }

    /** Le k-ième pavé dans un ordre dispersé : les premiers sont répartis sur toute l'image. */
    public static Pave eparpille(int k, int largeur, int hauteur, int cote) {
        int nombre = nombre(largeur, hauteur, cote);
        // proche du nombre d'or, et premier avec le nombre de pavés : chaque pavé vient une fois
        int pas = Math.max(1, (int) (nombre * 0.618));
        while (pgcd(pas, nombre) > 1) {
            pas++;
        }
        return deRang((int) ((long) k * pas % nombre), largeur, hauteur, cote);
    }

    private static int enColonnes(int largeur, int cote) {
        return (largeur + cote - 1) / cote;
    }

    private static int pgcd(int a, int b) {
        return b == 0 ? a : pgcd(b, a % b);
    }
}
