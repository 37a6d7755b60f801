package lancer.fenetre;

import java.awt.AWTException;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.util.stream.IntStream;

/** Ce qui se voit à l'écran. */
final class Ecran {

    private Ecran() {
    }

    /**
     * L'endroit de l'écran où se voit cette image, au pixel près, ou {@code null}. L'écran entier est fouillé : sans
     * gestionnaire de fenêtres, il arrive que Java se trompe sur l'endroit où est la sienne.
     */
    static Point trouver(int[] image, int largeur) throws AWTException {
        Rectangle ecran = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
        int[] vu = EssaiFenetre.codes(new Robot().createScreenCapture(ecran));
        int hauteur = image.length / largeur;
        // un pixel qui n'est pas de la couleur du coin écarte d'un coup tout fond de cette couleur
        int temoin = IntStream.range(0, image.length).filter(k -> image[k] != image[0]).findFirst().orElse(0);
        int place = temoin / largeur * ecran.width + temoin % largeur;
        for (int y = 0; y + hauteur <= ecran.height; y++) {
            for (int x = 0; x + largeur <= ecran.width; x++) {
                int debut = y * ecran.width + x;
                if (vu[debut + place] == image[temoin] && estLa(vu, debut, ecran.width, image, largeur)) {
                    return new Point(x, y);
                }
            }
        }
        return null;
    }

    private static boolean estLa(int[] vu, int debut, int pas, int[] image, int largeur) {
        for (int k = 0; k < image.length; k++) {
            if (vu[debut + k / largeur * pas + k % largeur] != image[k]) {
                return false;
            }
        }
        return true;
    }
}
