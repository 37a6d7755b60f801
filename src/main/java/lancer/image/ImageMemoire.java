package lancer.image;

import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import lancer.Couleur;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;

/** Une image en mémoire : les codes des pixels, les couleurs non limitées, ou les deux. */
public final class ImageMemoire implements Toile {

    public final int largeur;
    public final int hauteur;

    /** Codes 0xFFRRGGBB, ligne du haut d'abord, 0 sans dessin ; couleurs non limitées ; l'un peut être {@code null}. */
    public final int[] codes;
    public final float[] lineaire;

    /** Le texte des trois nombres de {@link #lineaire} : une couleur, ou la grandeur que montre une vue. */
    public volatile Function<Couleur, String> sens =
            c -> String.format(Locale.ROOT, "← %.3f %.3f %.3f", c.r, c.v, c.b);

    /** Les teintes d'une vue, dans leur ordre, et ce que chacune veut dire ; vide pour des couleurs. */
    public volatile List<Teinte> teintes = Collections.emptyList();

    /** Les codes qui se montrent à l'écran, si ce ne sont pas ceux du fichier ; {@code null} sinon. */
    public volatile int[] aLEcran;

    /** Légende d'une vue, en une ligne : ce que montrent ses teintes ; vide pour des couleurs. */
    public volatile String echelle = "";

    /** Une teinte, et ce qu'elle veut dire ; vide si elle mène de la précédente à la suivante. */
    public static final class Teinte {

        public final String mot;
        public final Couleur couleur;

        public Teinte(String mot, Couleur couleur) {
            this.mot = mot;
            this.couleur = couleur;
        }
    }

    /** @param avecLineaire vrai pour garder aussi les couleurs non limitées */
    public ImageMemoire(int largeur, int hauteur, boolean avecLineaire) {
        this(largeur, hauteur, true, avecLineaire);
    }

    /** @param avecCodes vrai pour garder les codes, de 4 octets par pixel ; les couleurs non limitées en prennent 12 */
    public ImageMemoire(int largeur, int hauteur, boolean avecCodes, boolean avecLineaire) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        this.codes = avecCodes ? new int[largeur * hauteur] : null;
        this.lineaire = avecLineaire ? new float[3 * largeur * hauteur] : null;
    }

    /** @throws PixelFautif si cette couleur est nulle ou a une composante qui n'est pas finie */
    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        PixelFautif.exigerFinie(coul, xe + 0.5, ye + 0.5);
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

    /** La couleur de ce pixel, arrondie si l'image n'a que des codes. @param k son rang, ligne par ligne */
    public Couleur getCouleur(int k) {
        if (lineaire != null) {
            return new Couleur(lineaire[3 * k], lineaire[3 * k + 1], lineaire[3 * k + 2]);
        }
        return new Couleur((codes[k] >> 16 & 0xFF) / 255.0, (codes[k] >> 8 & 0xFF) / 255.0, (codes[k] & 0xFF) / 255.0);
    }

    /** Peint le pixel de cette teinte, et garde {@code valeur} comme couleur non limitée. */
    public void drawPixel(Couleur teinte, Couleur valeur, int xe, int ye) {
        drawPixel(valeur, xe, ye);
        codes[ye * largeur + xe] = teinte.getCode();
    }

    /** Les nombres de ce pixel, comme {@link #sens} ; vide si l'image n'en garde pas. */
    public String dire(int k) {
        return lineaire == null ? "" : sens.apply(getCouleur(k));
    }
}
