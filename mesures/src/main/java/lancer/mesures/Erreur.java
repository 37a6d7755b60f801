package lancer.mesures;

import lancer.Couleur;

/**
 * De combien une image s'écarte de la vérité. Les deux premières mesures sont celles des couleurs linéaires, non limitées ; les
 * autres, celles de l'écran.
 */
public final class Erreur {

    /** Écart quadratique moyen, sur les trois composantes de tous les pixels ; 1/255 est un pas de l'écran. */
    public final double rmse;

    /** Le plus grand écart d'une composante. */
    public final double max;

    /** La ressemblance, 1 pour deux images semblables ; voir {@link Ssim}. */
    public final double ssim;

    /** Le plus grand écart d'une composante à l'écran, en pas, de 0 à 255. */
    public final int pas;

    /** Combien de pixels n'ont pas la couleur juste à l'écran. */
    public final int pixels;

    private Erreur(double rmse, double max, double ssim, int pas, int pixels) {
        this.rmse = rmse;
        this.max = max;
        this.ssim = ssim;
        this.pas = pas;
        this.pixels = pixels;
    }

    /** @throws IllegalArgumentException si les images n'ont pas la même taille */
    public static Erreur entre(ImageLineaire image, ImageLineaire verite) {
        memeTaille(image, verite);
        double max = 0;
        int pas = 0;
        int pixels = 0;
        for (int k = 0; k < image.getLargeur() * image.getHauteur(); k++) {
            Couleur vue = image.getCouleur(k);
            Couleur juste = verite.getCouleur(k);
            max = Math.max(max, ecart(vue, juste));
            int ecart = ecartDesCodes(vue.getCode(), juste.getCode());
            pas = Math.max(pas, ecart);
            pixels += ecart > 0 ? 1 : 0;
        }
        return new Erreur(rmse(image, verite), max, Ssim.entre(image, verite), pas, pixels);
    }

    /** L'écart quadratique moyen seul. */
    static double rmse(ImageLineaire image, ImageLineaire verite) {
        memeTaille(image, verite);
        double[] a = image.getComposantes();
        double[] b = verite.getComposantes();
        double somme = 0;
        for (int k = 0; k < a.length; k++) {
            somme += (a[k] - b[k]) * (a[k] - b[k]);
        }
        return Math.sqrt(somme / a.length);
    }

    /** Le plus grand écart d'une composante. */
    static double ecart(Couleur a, Couleur b) {
        return Math.max(Math.abs(a.r - b.r), Math.max(Math.abs(a.v - b.v), Math.abs(a.b - b.b)));
    }

    private static int ecartDesCodes(int a, int b) {
        int ecart = 0;
        for (int bits = 0; bits < 24; bits += 8) {
            ecart = Math.max(ecart, Math.abs((a >> bits & 0xFF) - (b >> bits & 0xFF)));
        }
        return ecart;
    }

    private static void memeTaille(ImageLineaire a, ImageLineaire b) {
        if (a.getLargeur() != b.getLargeur() || a.getHauteur() != b.getHauteur()) {
            throw new IllegalArgumentException("images de tailles différentes : " + a.getLargeur() + " × " + a.getHauteur() + " et "
                    + b.getLargeur() + " × " + b.getHauteur());
        }
    }
}
