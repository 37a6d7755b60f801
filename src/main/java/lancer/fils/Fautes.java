package lancer.fils;

import java.util.BitSet;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;

/** Les pixels dont le calcul a échoué. Un échec arrête le dessin ou, s'il est toléré, peint le pixel en magenta. */
public final class Fautes {

    private static final Couleur MAGENTA = new Couleur(1, 0, 1);

    private final int largeur;
    private final BitSet pixels = new BitSet();
    private PixelFautif premiereFaute;
    private volatile boolean tolerees;

    /** @param largeur celle de l'image, en pixels */
    public Fautes(int largeur) {
        this.largeur = largeur;
    }

    /** Tolère désormais les échecs : les pixels sont comptés et peints en magenta. */
    public void tolerer() {
        tolerees = true;
    }

    /**
     * Note l'échec d'un point de l'écran.
     *
     * @return la couleur à sa place
     * @throws PixelFautif si les échecs ne sont pas tolérés
     */
    public synchronized Couleur noter(Throwable e, double xe, double ye) {
        PixelFautif faute = e instanceof PixelFautif ? (PixelFautif) e : new PixelFautif(xe, ye, e);
        if (!tolerees) {
            throw faute;
        }
        // Java ne donne plus de pile à une exception souvent levée : elle ne dirait pas où
        boolean situee = faute.getCause().getStackTrace().length > 0;
        if (premiereFaute == null || situee && rang(faute) < rang(premiereFaute)) {
            premiereFaute = faute;
        }
        pixels.set(rang(faute));
        return MAGENTA;
    }

    private int rang(PixelFautif faute) {
        return faute.y * largeur + faute.x;
    }

    /** Repeint les pixels fautifs de ce pavé : un échantillonnage a pu mêler leur couleur à des couleurs justes. */
    public synchronized void peindre(Pave pave, Toile toile) {
        for (int j = pave.j0; j < pave.j1 && premiereFaute != null; j++) {
            for (int i = pave.i0; i < pave.i1; i++) {
                if (pixels.get(j * largeur + i)) {
                    toile.drawPixel(MAGENTA, i, j);
                }
            }
        }
    }

    /** Phrase qui donne le nombre de pixels fautifs ; {@code null} s'il n'y en a pas. */
    public synchronized String enMots() {
        int nombre = pixels.cardinality();
        String dits = nombre == 1 ? "un pixel n'a pu être calculé" : nombre + " pixels n'ont pu être calculés";
        return nombre == 0 ? null : dits;
    }

    /** La première faute située, ligne par ligne, {@code null} s'il n'y en a pas. */
    public synchronized PixelFautif getPremiere() {
        return premiereFaute;
    }
}
