package lancer.auto;

import lancer.contrat.Pave;

/** Deux pixels sur deux, moins au bord de l'image : ce qu'on en essaie. Immuable. */
final class Bloc {

    static final int COTE = 2;
    static final int PIXELS = COTE * COTE;

    /**
     * Ce qu'un échantillonnage peut regarder avant et après un pixel pour en décider. Un qui regarderait plus loin
     * serait jugé à peu près, comme au bord d'un pavé.
     */
    private static final int AVANT = 1;
    private static final int APRES = 2;

    /** Première colonne et première ligne ; colonne et ligne qui suivent les dernières. */
    final int i0;
    final int j0;
    final int i1;
    final int j1;

    private Bloc(int i0, int j0, int i1, int j1) {
        this.i0 = i0;
        this.j0 = j0;
        this.i1 = i1;
        this.j1 = j1;
    }

    /** Nombre de blocs de l'image. */
    static int nombre(int largeur, int hauteur) {
        return enColonnes(largeur) * ((hauteur + COTE - 1) / COTE);
    }

    /** Le bloc de rang {@code k}, dans l'ordre de la lecture. */
    static Bloc deRang(int k, int largeur, int hauteur) {
        int i0 = k % enColonnes(largeur) * COTE;
        int j0 = k / enColonnes(largeur) * COTE;
        return new Bloc(i0, j0, Math.min(i0 + COTE, largeur), Math.min(j0 + COTE, hauteur));
    }

    private static int enColonnes(int largeur) {
        return (largeur + COTE - 1) / COTE;
    }

    /** Vrai si ce pavé dessine le bloc : le côté d'un pavé est un nombre entier de blocs. */
    boolean estDans(Pave pave) {
        return i0 >= pave.i0 && i1 <= pave.i1 && j0 >= pave.j0 && j1 <= pave.j1;
    }

    boolean contient(int i, int j) {
        return i >= i0 && i < i1 && j >= j0 && j < j1;
    }

    int pixels() {
        return (i1 - i0) * (j1 - j0);
    }

    /** La place du pixel dans le bloc, de 0 à {@link #PIXELS} − 1. */
    int place(int i, int j) {
        return (j - j0) * COTE + i - i0;
    }

    /** Le bloc et ce qui l'entoure, sans sortir du pavé : de quoi y dessiner ses pixels comme dans l'image. */
    Pave entoure(Pave pave) {
        return new Pave(Math.max(pave.i0, i0 - AVANT), Math.max(pave.j0, j0 - AVANT), Math.min(pave.i1, i1 + APRES),
                Math.min(pave.j1, j1 + APRES));
    }
}
