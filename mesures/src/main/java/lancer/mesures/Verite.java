package lancer.mesures;

import lancer.Main;
import lancer.Scene;
import lancer.contrat.Echantillonnage;

/**
 * L'image qu'aurait donnée un calcul sans limite, ou ce qui en approche, et de combien elle s'en écarte peut-être encore : la
 * même avec moitié moins de peine en diffère de {@link #reste}. Comme la différence diminue à chaque doublement, c'est plus que
 * ce qui reste à gagner en doublant toujours, dès lors qu'elle diminue au moins de moitié.
 */
public final class Verite {

    /** Réflexions permises là où elles ne devraient pas être limitées : le plus que l'on puisse demander au programme. */
    public static final int PROFONDEUR = 1000;

    /** Sous-pixels d'un côté au-delà desquels on ne va pas : 4096 rayons par pixel. */
    public static final int N_MAX = 64;

    private static final int N_MIN = 4;

    /** L'image elle-même. */
    public final ImageLineaire image;

    /** Ce qu'il a fallu : sous-pixels d'un côté, ou réflexions permises. */
    public final int effort;

    /** Écart quadratique moyen avec l'image de moitié moins d'effort, en couleurs linéaires. */
    public final double reste;

    private Verite(ImageLineaire image, int effort, double reste) {
        this.image = image;
        this.effort = effort;
        this.reste = reste;
    }

    /**
     * La moyenne sur chaque pixel, avec ces limites-là de réflexion : la vérité des anticrénelages. Le nombre de sous-pixels
     * double tant que l'image change.
     *
     * @param scene ses objets, ses lampes, son air et ses reflets ; elle n'est pas changée
     * @param profondeur nombre de réflexions permises
     * @param seuil sous lequel un reflet n'est plus suivi
     * @param cible ce que {@link #reste} ne doit pas dépasser, si {@link #N_MAX} le permet
     */
    public static Verite desPixels(Scene scene, int largeur, int hauteur, int profondeur, double seuil, double cible) {
        ImageLineaire image = dessiner(scene, new Moyenne(N_MIN), largeur, hauteur, profondeur, seuil);
        for (int n = 2 * N_MIN; ; n *= 2) {
            ImageLineaire meilleure = dessiner(scene, new Moyenne(n), largeur, hauteur, profondeur, seuil);
            double reste = Erreur.rmse(image, meilleure);
            if (reste <= cible || n == N_MAX) {
                return new Verite(meilleure, n, reste);
            }
            image = meilleure;
        }
    }

    /** Un rayon par pixel, ni profondeur ni seuil ne l'arrêtant : la vérité des limites de réflexion. */
    public static Verite sansLimite(Scene scene, int largeur, int hauteur) {
        ImageLineaire moitie = dessiner(scene, Echantillonnage.CENTRE, largeur, hauteur, PROFONDEUR / 2, 0);
        ImageLineaire image = dessiner(scene, Echantillonnage.CENTRE, largeur, hauteur, PROFONDEUR, 0);
        return new Verite(image, PROFONDEUR, Erreur.rmse(moitie, image));
    }

    /** La moyenne sur chaque pixel, ni profondeur ni seuil n'arrêtant un rayon : la vérité de toute l'image. */
    public static Verite complete(Scene scene, int largeur, int hauteur, double cible) {
        return desPixels(scene, largeur, hauteur, PROFONDEUR, 0, cible);
    }

    private static ImageLineaire dessiner(Scene scene, Echantillonnage echantillonnage, int largeur, int hauteur, int profondeur,
            double seuil) {
        Scene copie = Scenes.copie(scene);
        copie.setEchantillonnage(echantillonnage);
        copie.setSeuil(seuil);
        return ImageLineaire.de(Main.preparer(copie, largeur, hauteur, false), profondeur,
                Runtime.getRuntime().availableProcessors());
    }
}
