package lancer.image;

import java.util.Locale;
import lancer.Couleur;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;

/** Une image en mémoire : les codes des pixels, les couleurs non limitées, ou les deux. */
public final class ImageMemoire implements Toile {

    /** Format de texte d'une couleur non limitée. */
    public static final String COULEUR = "← %.3f %.3f %.3f";

    public final int largeur;
    public final int hauteur;

    /** Codes 0xFFRRGGBB, ligne du haut d'abord, 0 sans dessin ; couleurs non limitées ; l'un peut être {@code null}. */
    public final int[] codes;
    public final float[] lineaire;

    /** Les trois nombres, tous égaux, d'un pixel où la vue ne trouve rien. */
    public static final float CIEL = -1;

    /** Format de texte des trois nombres de {@link #lineaire} : une couleur, ou la grandeur que montre une vue. */
    public volatile String sens = COULEUR;

    /** Légende d'une vue, en une ligne : ce que montrent ses teintes ; vide pour des couleurs. */
    public volatile String echelle = "";

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

    /** Le plus isolé des pixels de ces rangs : le voisin qui lui ressemble le plus en diffère. @param fin rang exclu */
    public int plusIsole(int debut, int fin) {
        int choisi = debut;
        int plusGrand = -1;
        for (int k = debut; k < fin; k++) {
            // le premier voisin suffit le plus souvent
            if (ecart(k, k - 1) > plusGrand && isolement(k) > plusGrand) {
                choisi = k;
                plusGrand = isolement(k);
            }
        }
        return choisi;
    }

    private int isolement(int k) {
        return Math.min(Math.min(ecart(k, k - 1), ecart(k, k + 1)),
                Math.min(ecart(k, k - largeur), ecart(k, k + largeur)));
    }

    /** La plus grande différence des composantes, en niveaux ; la plus grande de toutes, s'il n'y a pas de voisin. */
    private int ecart(int k, int voisin) {
        if (voisin < 0 || voisin >= largeur * hauteur) {
            return 255;
        }
        int a = getCode(k);
        int b = getCode(voisin);
        return Math.max(Math.abs((a >> 16 & 0xFF) - (b >> 16 & 0xFF)),
                Math.max(Math.abs((a >> 8 & 0xFF) - (b >> 8 & 0xFF)), Math.abs((a & 0xFF) - (b & 0xFF))));
    }

    private int getCode(int k) {
        return codes != null ? codes[k] : getCouleur(k).getCode();
    }

    /** Dit si ce pixel est celui que cette couleur dessinerait. */
    public boolean contient(Couleur coul, int xe, int ye) {
        int k = ye * largeur + xe;
        boolean memesNombres = lineaire == null || lineaire[3 * k] == (float) coul.r
                && lineaire[3 * k + 1] == (float) coul.v && lineaire[3 * k + 2] == (float) coul.b;
        return memesNombres && (codes == null || codes[k] == coul.getCode());
    }

    /** Peint le pixel de cette teinte, et garde {@code valeur} comme couleur non limitée. */
    public void drawPixel(Couleur teinte, Couleur valeur, int xe, int ye) {
        drawPixel(valeur, xe, ye);
        codes[ye * largeur + xe] = teinte.getCode();
    }

    /** Les nombres de ce pixel, comme {@link #sens} ; vide si l'image n'en garde pas. */
    public String dire(int k) {
        if (lineaire == null) {
            return "";
        }
        return lineaire[3 * k] == CIEL && lineaire[3 * k + 1] == CIEL ? "ciel"
                // point décimal, comme dans les fichiers de scène
                : String.format(Locale.ROOT, sens, lineaire[3 * k], lineaire[3 * k + 1], lineaire[3 * k + 2]);
    }
}
