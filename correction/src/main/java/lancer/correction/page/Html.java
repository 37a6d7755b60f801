package lancer.correction.page;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.function.IntBinaryOperator;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import lancer.correction.enfant.Echange;
import lancer.correction.modele.Modele;

/** Façon d'écrire du HTML où rien de ce que vient d'un étudiant ne soit pris pour du HTML. */
final class Html {

    private final StringBuilder texte = new StringBuilder();

    /** HTML, tel quel. */
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

    /** Un titre et une liste, s'il y a de quoi. */
    void liste(String titre, List<String> textes) {
        if (!textes.isEmpty()) {
            element("h2", titre).brut("<ul>");
            textes.forEach(texte -> element("li", texte));
            brut("</ul>\n");
        }
    }

    /** Un nombre à deux décimales au plus, à la française. */
    static String nombre(double x) {
        return String.format(Locale.FRANCE, "%.2f", x).replaceFirst(",?0+$", "");
    }

    static String echappe(String texte) {
        return Echange.NUISIBLES.matcher(texte).replaceAll("�").replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
                .replace("\"", "&quot;").replace("'", "&#39;");
    }

    /** Une image, dans la page même. @param pixel de (x, y), 0xRRVVBB */
    static String image(int largeur, int hauteur, IntBinaryOperator pixel, String legende) {
        BufferedImage image = new BufferedImage(largeur, hauteur, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, largeur, hauteur, IntStream.range(0, largeur * hauteur)
                .map(p -> pixel.applyAsInt(p % largeur, p / largeur)).toArray(), 0, largeur);
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
                + Modele.ressource("page.css") + "</style>\n</head>\n<body>\n" + texte + "\n</body>\n</html>\n";
    }
}
