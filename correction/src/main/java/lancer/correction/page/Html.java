package lancer.correction.page;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import lancer.correction.enfant.Echange;
import lancer.correction.jugement.Image;
import lancer.correction.modele.SourcesDuCours;

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

    /** Une image, dans la page même, s'il y en a une. @param reduction elle en montre un pixel sur tant, dans chaque sens */
    Html image(Image montree, int reduction, String legende) {
        if (montree == null) {
            return this;
        }
        BufferedImage image = new BufferedImage(montree.largeur / reduction, montree.hauteur / reduction, BufferedImage.TYPE_INT_RGB);
        IntStream.range(0, image.getWidth()).forEach(x -> IntStream.range(0, image.getHeight()).forEach(y ->
                image.setRGB(x, y, montree.code(reduction * x, reduction * y))));
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "png", octets);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return brut("<img alt=\"").dire(legende).brut("\" width=\"" + 2 * image.getWidth() + "\" height=\"" + 2 * image.getHeight()
                + "\" src=\"data:image/png;base64," + Base64.getEncoder().encodeToString(octets.toByteArray()) + "\">");
    }

    /** La même, et sa légende ; rien s'il n'y a pas d'image. */
    void figure(Image montree, int reduction, String legende) {
        if (montree != null) {
            brut("<figure>").image(montree, reduction, legende).element("figcaption", legende).brut("</figure>\n");
        }
    }

    /** La page entière, sans rien qui vienne d'ailleurs. */
    String page(String titre) {
        String[] modele = SourcesDuCours.ressource("page.html").split("TITRE|CORPS");
        return modele[0] + echappe(titre) + modele[1] + texte + modele[2];
    }
}
