package lancer.mesures.trace;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;

/** Des images et leurs noms, en rangées : ce que montre une {@link Planche}. */
public final class Vignettes {

    private static final int COLONNES = 3;

    private final List<BufferedImage> images = new ArrayList<>();
    private final List<String> noms = new ArrayList<>();
    private final List<String> details = new ArrayList<>();

    /** Une image de plus, son nom et ce qu'il y a à en dire, une ligne chacun. */
    public Vignettes image(BufferedImage image, String nom, String detail) {
        images.add(image);
        noms.add(nom);
        details.add(detail);
        return this;
    }

    /** Dessine tout entier dans ce rectangle. */
    void dessiner(Graphics2D g, Rectangle2D place) {
        double largeur = place.getWidth() / COLONNES;
        double hauteur = place.getHeight() / ((images.size() + COLONNES - 1) / COLONNES);
        double ligne = g.getFontMetrics(Style.TEXTE).getHeight();
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        for (int k = 0; k < images.size(); k++) {
            BufferedImage image = images.get(k);
            double echelle = Math.min((largeur - 12) / image.getWidth(), (hauteur - 2 * ligne - 18) / image.getHeight());
            int l = (int) (echelle * image.getWidth());
            int h = (int) (echelle * image.getHeight());
            int x = (int) (place.getX() + k % COLONNES * largeur + (largeur - l) / 2);
            double y = place.getY() + k / COLONNES * hauteur;
            Style.texte(g, noms.get(k), Style.TEXTE, Style.ENCRE, x, y, largeur, true);
            Style.texte(g, details.get(k), Style.TEXTE, Style.GRIS, x, y + ligne, largeur, true);
            g.drawImage(image, x, (int) (y + 2 * ligne + 4), l, h, null);
            g.setColor(Style.GRIS);
            g.setStroke(Style.TRAIT_FIN);
            g.drawRect(x, (int) (y + 2 * ligne + 4), l, h);
        }
    }
}
