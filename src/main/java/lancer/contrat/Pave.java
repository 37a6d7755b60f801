package lancer.contrat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

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

    /** Les pavés de l'image, battus toujours pareil : le compilateur de Java voit tôt toutes sortes de pixels. */
    public static List<Pave> battus(int largeur, int hauteur) {
        List<Pave> paves = new ArrayList<>();
        for (int j = 0; j < hauteur; j += COTE) {
            for (int i = 0; i < largeur; i += COTE) {
                paves.add(autour(i, j, largeur, hauteur));
            }
        }
        Collections.shuffle(paves, new Random(1));
        return paves;
    }

    /** Pavé du dessin qui contient ce pixel. */
    public static Pave autour(int x, int y, int largeur, int hauteur) {
        int i0 = x / COTE * COTE;
        int j0 = y / COTE * COTE;
        return new Pave(i0, j0, Math.min(i0 + COTE, largeur), Math.min(j0 + COTE, hauteur));
    }
}
