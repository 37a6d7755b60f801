package lancer.fils;

import java.util.BitSet;
import java.util.concurrent.CancellationException;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;

/** Les pixels dont le calcul a échoué. Un échec arrête le dessin ou, s'il est toléré, peint le pixel en damier. */
public final class Fautes {

    /** Nombre d'échecs après lequel le dessin s'arrête, si aucun pixel n'a réussi. */
    private static final int TROP = 1000;

    private static final Couleur MAGENTA = new Couleur(1, 0, 1);

    private final int largeur;
    private final BitSet pixels = new BitSet();
    private PixelFautif premiere;
    private volatile boolean tolerees;
    private volatile boolean reussi;

    /** @param largeur celle de l'image, en pixels */
    public Fautes(int largeur) {
        this.largeur = largeur;
    }

    /** Tolère désormais les échecs : les pixels sont comptés et peints en damier. */
    public void tolerer() {
        tolerees = true;
    }

    /** @throws PixelFautif si cette couleur, qui est rendue, est nulle ou a une composante qui n'est pas finie */
    public Couleur verifier(Couleur couleur, double xe, double ye) {
        PixelFautif.verifier(couleur, xe, ye);
        if (!reussi) {
            reussi = true;
        }
        return couleur;
    }

    /**
     * Note l'échec d'un point de l'écran.
     *
     * @return la couleur du damier
     * @throws PixelFautif si les échecs ne sont pas tolérés, ou après mille échecs sans aucun succès
     */
    public Couleur noter(Throwable e, double xe, double ye) {
        if (e instanceof CancellationException) {
            throw (CancellationException) e;
        }
        if (e instanceof OutOfMemoryError) {
            // le manque de mémoire n'est pas un échec du pixel
            throw (OutOfMemoryError) e;
        }
        PixelFautif faute = e instanceof PixelFautif ? (PixelFautif) e : new PixelFautif(xe, ye, e);
        if (!tolerees) {
            throw faute;
        }
        return noter(faute);
    }

    private synchronized Couleur noter(PixelFautif faute) {
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

    /** Repeint les pixels fautifs de ce pavé : un échantillonnage a pu mêler le damier à des couleurs justes. */
    public synchronized void peindre(Pave pave, Toile toile) {
        for (int j = pave.j0; j < pave.j1 && premiere != null; j++) {
            int fin = j * largeur + pave.i1;
            for (int k = pixels.nextSetBit(j * largeur + pave.i0); k >= 0 && k < fin; k = pixels.nextSetBit(k + 1)) {
                toile.drawPixel(damier(k % largeur, j), k % largeur, j);
            }
        }
    }

    /** Phrase qui donne le nombre de pixels fautifs ; {@code null} s'il n'y en a pas. */
    public synchronized String enMots() {
        return premiere == null ? null : pixels.cardinality() == 1 ? "un pixel n'a pu être calculé"
                : pixels.cardinality() + " pixels n'ont pu être calculés";
    }

    /** Première faute, ligne par ligne, {@code null} s'il n'y en a pas. */
    public synchronized PixelFautif getPremiere() {
        return premiere;
    }
}
