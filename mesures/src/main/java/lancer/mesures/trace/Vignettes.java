package lancer.mesures.trace;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Des images et leurs noms, trois par ligne : une partie d'une {@link Planche}. */
public final class Vignettes implements Contenu {

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

    @Override
    public List<Serie> series() {
        return Collections.emptyList();
    }

    @Override
    public double enTete(Graphics2D g, double largeur) {
        return 0;
    }

    @Override
    public void dessiner(Graphics2D g, Rectangle2D place, double enTete) {
        int lignes = (images.size() + COLONNES - 1) / COLONNES;
        double ligne = g.getFontMetrics(Style.LEGENDE).getHeight();
        double texte = 2 * ligne + 4;
        double largeur = place.getWidth() / COLONNES;
        double hauteur = place.getHeight() / lignes;
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        for (int k = 0; k < images.size(); k++) {
            BufferedImage image = images.get(k);
            double x = place.getX() + k % COLONNES * largeur;
            double y = place.getY() + k / COLONNES * hauteur;
            double echelle = Math.min((largeur - 12) / image.getWidth(), (hauteur - texte - 14) / image.getHeight());
            int l = (int) (echelle * image.getWidth());
            int h = (int) (echelle * image.getHeight());
            int gauche = (int) (x + (largeur - l) / 2);
            new Paragraphe(g, noms.get(k), Style.LEGENDE, largeur).dessiner(g, gauche, y, Style.ENCRE);
            new Paragraphe(g, details.get(k), Style.LEGENDE, largeur).dessiner(g, gauche, y + ligne, Style.GRIS);
            g.drawImage(image, gauche, (int) (y + texte), l, h, null);
            g.setColor(Style.GRIS);
            g.setStroke(Style.TRAIT_FIN);
            g.drawRect(gauche, (int) (y + texte), l, h);
        }
    }
}
