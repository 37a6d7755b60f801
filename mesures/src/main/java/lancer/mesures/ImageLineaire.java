package lancer.mesures;

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
        lancer.TracerPixels(image, profondeur, fils);
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
}
