package lancer.correction.page;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.Locale;
import java.util.function.IntBinaryOperator;
import javax.imageio.ImageIO;

/** De quoi écrire du HTML où rien de ce que vient d'un étudiant ne soit pris pour du HTML. */
final class Html {

    private final StringBuilder texte = new StringBuilder();

    /** Du HTML, tel quel. */
    Html brut(String html) {
        texte.append(html);
        return this;
    }

    /** Un texte, quel qu'il soit. */
    Html dire(Object valeur) {
        texte.append(echappe(String.valueOf(valeur)));
        return this;
    }

    /** Un élément qui ne contient que ce texte. */
    Html element(String balise, Object valeur) {
        return brut("<" + balise + ">").dire(valeur).brut("</" + balise.replaceFirst(" .*", "") + ">");
    }

    /** Un nombre à deux décimales au plus, à la française. */
    static String nombre(double x) {
        return String.format(Locale.FRANCE, "%.2f", x).replaceFirst(",?0+$", "");
    }

    static String echappe(String texte) {
        StringBuilder propre = new StringBuilder();
        texte.codePoints().forEach(c -> {
            switch (c) {
                case '<':
                    propre.append("&lt;");
                    break;
                case '>':
                    propre.append("&gt;");
                    break;
                case '&':
                    propre.append("&amp;");
                    break;
                case '"':
                    propre.append("&quot;");
                    break;
                case '\'':
                    propre.append("&#39;");
                    break;
                default:
                    // ni commandes, ni signes qui changent le sens de l'écriture
                    propre.appendCodePoint(c < ' ' && c != '\n' || c >= 0x202A && c <= 0x202E || c >= 0x2066
                            && c <= 0x2069
                            || c >= 0xD800 && c <= 0xDFFF ? '�' : c);
            }
        });
        return propre.toString();
    }

    /** Une image, dans la page même. @param pixel de (x, y), 0xRRVVBB */
    static String image(int largeur, int hauteur, IntBinaryOperator pixel, String legende) {
        BufferedImage image = new BufferedImage(largeur, hauteur, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < hauteur; y++) {
            for (int x = 0; x < largeur; x++) {
                image.setRGB(x, y, pixel.applyAsInt(x, y));
            }
        }
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "png", octets);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return "<img alt=\"" + echappe(legende) + "\" width=\"" + 2 * largeur + "\" height=\"" + 2 * hauteur
                + "\" src=\"data:image/png;base64," + Base64.getEncoder().encodeToString(octets.toByteArray()) + "\">";
    }

    /** La page entière, sans rien qui vienne d'ailleurs. */
    String page(String titre) {
        return "<!DOCTYPE html>\n<html lang=\"fr\">\n<head>\n<meta charset=\"utf-8\">\n"
                + "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
                + "style-src 'unsafe-inline'\">\n"
                + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" + echappe(titre)
                + "</title>\n<style>"
                + STYLE + "</style>\n</head>\n<body>\n" + texte + "\n</body>\n</html>\n";
    }

    private static final String STYLE = "body{font:15px/1.45 system-ui,'DejaVu "
            + "Sans',sans-serif;color:#1d2129;max-width:1240px;margin:1.5em auto;padding:0 1em}"
            + "h1{font-size:1.5em;margin:.2em 0}h2{font-size:1.15em;margin:1.6em 0 .5em}"
            + "table{border-collapse:collapse}td,th{padding:.25em "
            + ".5em;text-align:left;vertical-align:top;border-bottom:1px solid #e3e6ea}"
            + "th{font-weight:600;color:#55606e;font-size:.88em}"
            + ".n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}"
            + ".gris{color:#66717f}.petit{font-size:.88em}.c{text-align:center}"
            + ".e{display:inline-block;min-width:2.7em;padding:.05em "
            + ".3em;border-radius:3px;text-align:center;font-size:.85em;font-variant-numeric:tabular-nums}"
            + ".reussi,.complet{background:#cfe8d5;color:#14532d}.cache{background:#dcebc0;color:#3f4d0f}"
            + ".partiel{background:#fdecc8;color:#7a4b00}"
            + ".rate{background:#f7d3d0;color:#8a1f17}.vide{background:#e9ecef;color:#66717f}"
            + "figure{display:inline-block;margin:0 1em 1em 0}figcaption{font-size:.88em;color:#55606e}"
            + "img{image-rendering:pixelated;background:#000;display:block}"
            + "code{font:13px 'DejaVu Sans Mono',monospace;overflow-wrap:anywhere}.ecart "
            + "td{background:#fff3f2;font-weight:600}"
            + "details{margin:.15em 0}summary{cursor:pointer}ul{margin:.3em 0;padding-left:1.3em}a{color:#1f5fa8}"
            + ".avis{background:#fdecc8;padding:.5em .8em;border-radius:4px}.vignette img{width:80px;height:60px}svg "
            + "text{font-size:12px;fill:#1d2129}"
            + ".classe{width:100%}.classe th{vertical-align:bottom}.classe td,.classe th{padding:.25em .3em}"
            + ".classe td:not([rowspan]):not([colspan]){border:0}.classe td:nth-child(2){min-width:9em}"
            + ".debout{text-align:center}.debout span{writing-mode:vertical-rl;transform:rotate(180deg);"
            + "display:inline-block;max-height:9.5em}";
}
