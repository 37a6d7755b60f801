package lancer.mesures.trace;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Stroke;
import java.math.RoundingMode;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.ui.HorizontalAlignment;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.VerticalAlignment;

/**
 * Le style commun des courbes : tailles, couleurs lisibles par les daltoniens (M. Okabe et K. Ito, <i>Color Universal Design</i>, 2008),
 * caractères lisibles quand l'image est réduite de moitié.
 */
public final class Style {

    static {
        // à fixer avant la première couleur : si l'écran ne répond pas, Java refuserait de dessiner
        System.setProperty("java.awt.headless", "true");
    }

    /** Taille ordinaire d'une planche, en pixels. Les pages la montrent deux fois plus petite. */
    public static final int LARGEUR = 1600;
    public static final int HAUTEUR = 1000;

    /** La palette d'Okabe et Ito. */
    public static final Color NOIR = new Color(0x000000);
    public static final Color ORANGE = new Color(0xE69F00);
    public static final Color CIEL = new Color(0x56B4E9);
    public static final Color VERT = new Color(0x009E73);
    public static final Color BLEU = new Color(0x0072B2);
    public static final Color VERMILLON = new Color(0xD55E00);
    public static final Color POURPRE = new Color(0xCC79A7);

    /** Couleurs des axes, des textes et des fonds. */
    public static final Color ENCRE = new Color(0x222222);
    public static final Color GRIS = new Color(0x707070);
    public static final Color GRILLE = new Color(0xE2E2E2);
    public static final Color FRONT = new Color(0xBDBDBD);
    public static final Color BANDE = new Color(0xF3F3F3);

    static final Font TITRE = new Font(Font.SANS_SERIF, Font.BOLD, 36);
    static final Font CONSTAT = new Font(Font.SANS_SERIF, Font.BOLD, 25);
    static final Font TEXTE = new Font(Font.SANS_SERIF, Font.PLAIN, 24);
    static final Font ETIQUETTE = new Font(Font.SANS_SERIF, Font.PLAIN, 22);
    static final Font NOTE = new Font(Font.SANS_SERIF, Font.PLAIN, 18);

    static final Stroke TRAIT = trait(3f);
    static final Stroke TRAIT_FIN = trait(2f);
    static final Stroke TRAIT_FRONT = trait(11f);
    static final Stroke POINTILLE = new BasicStroke(2.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 1, new float[] {3, 8}, 0);

    /** Marge autour de la planche, en pixels. */
    static final int MARGE = 28;

    private Style() {
    }

    /** Un texte aligné à gauche et coupé entre ses mots, sans séparer une ponctuation ou un nombre du mot voisin. */
    static TextTitle titre(String texte, Font police, Color couleur) {
        String insecable = texte.replaceAll("« ", "«\u00A0").replaceAll(" ([»:;%?!×])", "\u00A0$1")
                .replaceAll("; (?=[0-9])", ";\u00A0").replaceAll("([0-9×]) (?=[0-9×a-z])", "$1\u00A0");
        TextTitle titre = new TextTitle(insecable, police, couleur, RectangleEdge.TOP, HorizontalAlignment.LEFT,
                VerticalAlignment.TOP, RectangleInsets.ZERO_INSETS);
        titre.setTextAlignment(HorizontalAlignment.LEFT);
        return titre;
    }

    static BasicStroke trait(float epaisseur) {
        return new BasicStroke(epaisseur, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    /** Un nombre à la française : virgule, espace entre les milliers, trois chiffres significatifs au plus sous mille. */
    public static String nombre(double valeur) {
        return valeur != 0 && Math.abs(valeur) < 1e-4 ? puissance(valeur) : chiffres(valeur, 3);
    }

    /** Un nombre à la française, à deux chiffres significatifs, pour un titre. */
    public static String arrondi(double valeur) {
        return chiffres(valeur, 2);
    }

    /** Erreur d'une image : « 0,29 niveau ». */
    public static String niveaux(double erreur) {
        return arrondi(erreur) + (erreur < 2 ? " niveau" : " niveaux");
    }

    /** « 10⁵ », « 2,5 × 10⁻⁷ ». */
    public static String puissance(double valeur) {
        int exposant = (int) Math.floor(Math.log10(Math.abs(valeur)) + 1e-9);
        double mantisse = valeur / Math.pow(10, exposant);
        String devant = Math.round(mantisse * 10) == 10 ? "" : decimales(mantisse, 1) + " × ";
        return devant + "10" + enExposant(exposant);
    }

    /** Nombre écrit avec {@code combien} chiffres significatifs au plus, sans ôter de chiffres avant la virgule. */
    private static String chiffres(double valeur, int combien) {
        int entiers = valeur == 0 ? 1 : (int) Math.floor(Math.log10(Math.abs(valeur)) + 1e-9) + 1;
        return decimales(valeur, Math.max(0, combien - entiers));
    }

    /** Nombre écrit avec {@code decimales} décimales au plus. */
    private static String decimales(double valeur, int decimales) {
        DecimalFormatSymbols symboles = new DecimalFormatSymbols(Locale.ROOT);
        symboles.setDecimalSeparator(',');
        symboles.setGroupingSeparator('\u00A0');
        symboles.setMinusSign('\u2212');
        DecimalFormat format = new DecimalFormat("#,##0", symboles);
        format.setMaximumFractionDigits(decimales);
        format.setRoundingMode(RoundingMode.HALF_UP);
        return format.format(valeur);
    }

    private static String enExposant(int exposant) {
        StringBuilder s = new StringBuilder();
        for (char c : Integer.toString(exposant).toCharArray()) {
            s.append(c == '-' ? '\u207B' : "\u2070\u00B9\u00B2\u00B3\u2074\u2075\u2076\u2077\u2078\u2079".charAt(c - '0'));
        }
        return s.toString();
    }
}
