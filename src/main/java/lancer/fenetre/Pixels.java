package lancer.fenetre;

import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.util.Arrays;
import java.util.List;
import lancer.image.ImageMemoire;
import lancer.image.Reduction;

/** Les images de Java des pixels d'une image. La dernière image réduite est gardée. */
final class Pixels {

    /** Nombre de lignes et de colonnes qui donnent un pixel réduit, tant que l'image n'est pas achevée. */
    private static final int LIGNES_REGARDEES = 4;

    private BufferedImage reduite;
    /** Ce dont dépend l'image réduite. */
    private List<Object> reduiteDe;

    /** Une image de Java qui partage ce tableau de codes. @param vides vrai si un code 0 y est transparent */
    static BufferedImage de(int[] codes, int largeur, boolean vides) {
        DirectColorModel couleurs = new DirectColorModel(vides ? 32 : 24, 0xFF0000, 0xFF00, 0xFF,
                vides ? 0xFF000000 : 0);
        return new BufferedImage(couleurs, Raster.createPackedRaster(new DataBufferInt(codes, codes.length), largeur,
                codes.length / largeur, largeur, couleurs.getMasks(), null), false, null);
    }

    /**
     * Peint à cette place les pixels visibles seulement : AWT ne peut peindre une image entière très agrandie.
     *
     * @param de le premier pixel visible @param a le dernier
     */
    void peindre(Graphics2D g, ImageMemoire image, boolean achevee, Rectangle place, Point de, Point a) {
        if (place.width < image.largeur) {
            g.drawImage(reduire(image, achevee, place.width, place.height), place.x, place.y, null);
            return;
        }
        double l = (double) place.width / image.largeur;
        double h = (double) place.height / image.hauteur;
        g.drawImage(de(image.codes, image.largeur, true), (int) Math.round(place.x + l * de.x),
                (int) Math.round(place.y + h * de.y), (int) Math.round(place.x + l * (a.x + 1)),
                (int) Math.round(place.y + h * (a.y + 1)), de.x, de.y, a.x + 1, a.y + 1, null);
    }

    /** L'image réduite à cette taille. Chaque pixel est une moyenne, exacte si l'image est achevée. */
    private BufferedImage reduire(ImageMemoire image, boolean achevee, int largeur, int hauteur) {
        List<Object> voulue = Arrays.asList(image, achevee, largeur);
        if (!achevee || !voulue.equals(reduiteDe)) {
            reduite = de(Reduction.moyenne(image, largeur, hauteur,
                    achevee ? 1 : 1 + image.largeur / (LIGNES_REGARDEES * largeur)), largeur, true);
            reduiteDe = voulue;
        }
        return reduite;
    }
}
