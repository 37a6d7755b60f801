package lancer.mesures;

import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import lancer.Couleur;
import lancer.Lancer;
import lancer.contrat.Toile;

/** Une image de couleurs non limitées, en double précision. */
public final class ImageLineaire implements Toile {

    private final int largeur;

    /** Rouge, vert, bleu de chaque pixel, ligne par ligne depuis le haut. */
    private final double[] composantes;

    public ImageLineaire(int largeur, int hauteur) {
        this.largeur = largeur;
        composantes = new double[3 * largeur * hauteur];
    }

    /** L'image que dessine {@code lancer} ; elle ne dépend pas du nombre de fils. */
    public static ImageLineaire de(Lancer lancer, int profondeur, int fils) {
        ImageLineaire image = new ImageLineaire(lancer.getCamera().getLargeur(), lancer.getCamera().getHauteur());
        lancer.TracerImage(image, profondeur, fils);
        return image;
    }

    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        int k = 3 * (ye * largeur + xe);
        composantes[k] = coul.r;
        composantes[k + 1] = coul.v;
        composantes[k + 2] = coul.b;
    }

    /** Trois composantes par pixel, ligne par ligne depuis le haut, sans copie. */
    public double[] getComposantes() {
        return composantes;
    }

    /** Le pixel de rang {@code k}, ligne par ligne. */
    public Couleur getCouleur(int k) {
        return new Couleur(composantes[3 * k], composantes[3 * k + 1], composantes[3 * k + 2]);
    }

    private int hauteur() {
        return composantes.length / 3 / largeur;
    }

    /** L'image à l'écran. */
    public BufferedImage image() {
        BufferedImage image = new BufferedImage(largeur, hauteur(), BufferedImage.TYPE_INT_RGB);
        for (int k = 0; k < composantes.length / 3; k++) {
            image.setRGB(k % largeur, k / largeur, getCouleur(k).getCode());
        }
        return image;
    }

    /** Un gris par pixel : le plus grand écart de ses composantes limitées à [0, 1], en niveaux, arrondi au-dessus. */
    public BufferedImage ecarts(ImageLineaire autre) {
        BufferedImage image = new BufferedImage(largeur, hauteur(), BufferedImage.TYPE_INT_RGB);
        for (int k = 0; k < composantes.length / 3; k++) {
            double ecart = IntStream.range(3 * k, 3 * k + 3).mapToDouble(c -> Math.abs(Math.min(1, composantes[c])
                    - Math.min(1, autre.composantes[c]))).max().getAsDouble();
            image.setRGB(k % largeur, k / largeur, 0x010101 * (int) Math.min(255, Math.ceil(255 * ecart)));
        }
        return image;
    }
}
