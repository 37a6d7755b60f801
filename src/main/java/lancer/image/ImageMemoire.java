package lancer.image;

import lancer.Couleur;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;

/** Une image en mémoire : les codes à montrer, les couleurs non limitées, ou les deux. */
public final class ImageMemoire implements Toile {

    /** Une couleur non limitée, comme dans les fichiers de scène. */
    public static final String COULEUR = "← %.3f %.3f %.3f";

    public final int largeur;
    public final int hauteur;

    /** Les codes 0xFFRRGGBB, depuis le haut, 0 où rien n'est dessiné, et les couleurs non limitées ; null : aucun. */
    public final int[] codes;
    public final float[] lineaire;

    /** Texte qui dit comment elle est dessinée, et ce qu'elle a coûté ; {@code null} tant qu'elle n'est pas achevée. */
    public volatile String legende;

    /** Ce que disent les trois nombres de {@link #lineaire} d'un pixel : une couleur, ou ce qu'une vue y montre. */
    public volatile String sens = COULEUR;

    /** @param avecLineaire vrai pour garder aussi les couleurs non limitées */
    public ImageMemoire(int largeur, int hauteur, boolean avecLineaire) {
        this(largeur, hauteur, true, avecLineaire);
    }

    /** @param avecCodes vrai pour garder les codes, 4 octets par pixel ; les couleurs non limitées en prennent 12 */
    public ImageMemoire(int largeur, int hauteur, boolean avecCodes, boolean avecLineaire) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        this.codes = avecCodes ? new int[largeur * hauteur] : null;
        this.lineaire = avecLineaire ? new float[3 * largeur * hauteur] : null;
    }

    /** @throws PixelFautif si cette couleur est nulle, ou a une composante qui n'est pas finie */
    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        PixelFautif.verifier(coul, xe + 0.5, ye + 0.5);
        int k = ye * largeur + xe;
        if (codes != null) {
            codes[k] = coul.getCode();
        }
        if (lineaire != null) {
            lineaire[3 * k] = (float) coul.r;
            lineaire[3 * k + 1] = (float) coul.v;
            lineaire[3 * k + 2] = (float) coul.b;
        }
    }

    /** Montre cette teinte à la place de ce qu'elle dit. */
    public void drawPixel(Couleur teinte, Couleur valeur, int xe, int ye) {
        drawPixel(valeur, xe, ye);
        codes[ye * largeur + xe] = teinte.getCode();
    }
}
