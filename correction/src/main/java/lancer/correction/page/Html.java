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

/** Écriture de HTML, où un texte d'étudiant ne peut être pris pour du HTML. */
final class Html {

    private final StringBuilder texte = new StringBuilder();

    /** Ajoute du HTML. */
    Html brut(String html) {
        texte.append(html);
        return this;
    }

    /** Ajoute un texte quelconque. */
    Html dire(Object valeur) {
        texte.append(echappe(String.valueOf(valeur)));
        return this;
    }

    /** Ajoute un élément qui ne contient que ce texte. */
    Html element(String balise, Object valeur) {
        return brut("<" + balise + ">").dire(valeur).brut("</" + balise.replaceFirst(" .*", "") + ">");
    }

    /** Ajoute un titre et une liste, si elle n'est pas vide. */
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

    /** Ajoute une image dans la page, s'il y en a une. @param reduction un pixel sur ce nombre est montré, dans chaque sens */
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

    /** Ajoute une image et sa légende, s'il y a une image. */
    void figure(Image montree, int reduction, String legende) {
        if (montree != null) {
            brut("<figure>").image(montree, reduction, legende).element("figcaption", legende).brut("</figure>\n");
        }
    }

    @Override
    public String toString() {
        return texte.toString();
    }

    /** La page entière, sans référence extérieure. */
    String page(String titre) {
        String[] modele = SourcesDuCours.ressource("page.html").split("TITRE|CORPS");
        return modele[0] + echappe(titre) + modele[1] + texte + modele[2];
    }
}
