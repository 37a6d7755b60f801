package lancer.fils;

import java.util.BitSet;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;

/** Les pixels qu'un dessin n'a pu calculer, et qu'il peint en damier au lieu de s'arrêter ; pour tous ses fils. */
public final class Fautes {

    /** Nombre d'échecs après lequel, si rien n'a réussi, il n'y a pas d'image à attendre. */
    private static final int TROP = 1000;

    private static final Couleur MAGENTA = new Couleur(1, 0, 1);

    private final int largeur;
    private final BitSet pixels = new BitSet();
    private PixelFautif premiere;
    private volatile boolean reussi;

    /** @param largeur celle de l'image, en pixels */
    Fautes(int largeur) {
        this.largeur = largeur;
    }

    /** Note qu'un pixel au moins a pu être calculé. */
    void reussir() {
        if (!reussi) {
            reussi = true;
        }
    }

    /**
     * Note cette faute, et rend la couleur qui la montre.
     *
     * @throws PixelFautif la première, s'il y en a mille et que rien n'a réussi
     */
    synchronized Couleur noter(PixelFautif faute) {
        int rang = faute.y * largeur + faute.x;
        if (premiere == null || rang < pixels.nextSetBit(0)) {
            premiere = faute;
        }
        pixels.set(rang);
        if (!reussi && pixels.cardinality() >= TROP) {
            throw premiere;
        }
        return damier(faute.x, faute.y);
    }

    private static Couleur damier(int x, int y) {
        return (x + y) % 2 == 0 ? MAGENTA : new Couleur();
    }

    /** Peint les pixels fautifs de ce pavé, que d'autres échantillons ont pu mêler à leurs voisins. */
    synchronized void peindre(Pave pave, Toile toile) {
        for (int j = pave.j0; j < pave.j1 && premiere != null; j++) {
            int fin = j * largeur + pave.i1;
            for (int k = pixels.nextSetBit(j * largeur + pave.i0); k >= 0 && k < fin; k = pixels.nextSetBit(k + 1)) {
                toile.drawPixel(damier(k % largeur, j), k % largeur, j);
            }
        }
    }

    /** Le nombre de ces pixels, en une phrase ; {@code null} s'il n'y en a pas. */
    public synchronized String enMots() {
        return premiere == null ? null : pixels.cardinality() == 1 ? "un pixel n'a pu être calculé"
                : pixels.cardinality() + " pixels n'ont pu être calculés";
    }

    /** Première faute, dans l'ordre de la lecture, {@code null} s'il n'y en a pas. */
    public synchronized PixelFautif getPremiere() {
        return premiere;
    }
}
