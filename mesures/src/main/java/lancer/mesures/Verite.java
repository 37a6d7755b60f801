package lancer.mesures;

import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Echantillonnage;
import lancer.temoins.LancerSurveille;

/**
 * L'image qu'aurait donnée un calcul sans limite, ou ce qui en approche, et de combien elle s'en écarte peut-être encore : la
 * même avec moitié moins d'effort en diffère de {@link #reste}. Si la différence diminue au moins de moitié à chaque doublement,
 * doubler sans fin ne la changerait pas davantage.
 */
public final class Verite {

    /** Réflexions permises là où elles ne devraient pas être limitées : le plus que l'on puisse demander au programme. */
    public static final int PROFONDEUR = 1000;

    /** Sous-pixels d'un côté au-delà desquels on ne va pas : 4096 rayons par pixel, après 1024, 256 et 64. */
    public static final int N_MAX = 64;

    private static final int N_MIN = 8;

    /** L'image elle-même. */
    public final ImageLineaire image;

    /** Ce que l'on s'est permis : sous-pixels d'un côté, ou réflexions. */
    public final int effort;

    /** Écart quadratique moyen avec l'image de moitié moins d'effort, en couleurs linéaires. */
    public final double reste;

    /** Les rayons qu'il a fallu. */
    public final Compteurs compteurs;

    private Verite(ImageLineaire image, int effort, ImageLineaire moitie, Compteurs compteurs) {
        this.image = image;
        this.effort = effort;
        this.reste = Erreur.rmse(moitie, image);
        this.compteurs = compteurs;
    }

    /**
     * La moyenne sur chaque pixel, avec ces limites-là de réflexion : la vérité des anticrénelages. Le nombre de sous-pixels
     * double, dans chaque pixel, tant que sa couleur change de plus que la tolérance.
     *
     * @param scene ses objets, ses lampes, son air et ses reflets ; elle n'est pas changée
     * @param profondeur nombre de réflexions permises
     * @param seuil sous lequel un reflet n'est plus suivi
     * @param tolerance sur une composante linéaire ; 1/255 est un pas de l'écran
     * @param nMax sous-pixels d'un côté, au plus ; 16 au moins
     */
    public static Verite desPixels(Scene scene, int largeur, int hauteur, int profondeur, double seuil, double tolerance,
            int nMax) {
        ImageLineaire moitie = new ImageLineaire(largeur, hauteur);
        Lancer lancer = preparer(scene, new Doublement(N_MIN, nMax, tolerance, moitie), largeur, hauteur, seuil);
        return new Verite(dessiner(lancer, profondeur), nMax, moitie, lancer.getCompteurs());
    }

    /** Un rayon par pixel, ni profondeur ni seuil ne l'arrêtant : la vérité des limites de réflexion. */
    public static Verite sansLimite(Scene scene, int largeur, int hauteur) {
        ImageLineaire moitie = dessiner(preparer(scene, Echantillonnage.CENTRE, largeur, hauteur, 0), PROFONDEUR / 2);
        Lancer lancer = preparer(scene, Echantillonnage.CENTRE, largeur, hauteur, 0);
        return new Verite(dessiner(lancer, PROFONDEUR), PROFONDEUR, moitie, lancer.getCompteurs());
    }

    /** La moyenne sur chaque pixel, ni profondeur ni seuil n'arrêtant un rayon : la vérité de toute l'image. */
    public static Verite complete(Scene scene, int largeur, int hauteur, double tolerance) {
        return desPixels(scene, largeur, hauteur, PROFONDEUR, 0, tolerance, N_MAX);
    }

    private static Lancer preparer(Scene scene, Echantillonnage echantillonnage, int largeur, int hauteur, double seuil) {
        return LancerSurveille.preparer(scene.avec(echantillonnage, seuil), largeur, hauteur, false);
    }

    private static ImageLineaire dessiner(Lancer lancer, int profondeur) {
        return ImageLineaire.de(lancer, profondeur, Runtime.getRuntime().availableProcessors());
    }
}
