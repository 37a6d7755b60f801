package lancer.mesures;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.BiPredicate;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Releve;
import lancer.contrat.Vue;
import lancer.dessin.Dessin;

/**
 * Mesure de l'erreur d'une image. La référence est la moyenne exacte de chaque pixel, sans limite de réflexions. Deux images a et b, sans
 * limite, en sont des estimations indépendantes et sans biais. La moyenne de (x − a)(x − b) estime donc sans biais celle de (x −
 * référence)². Les couleurs sont limitées à [0, 1], en niveaux. La mesure se fait sur toute l'image, ou sur un pixel tiré au hasard dans
 * chaque carré, le même pour toutes les images comparées.
 */
public final class Gabarit {

    /** Nombre maximal de réflexions du programme. */
    public static final int PROFONDEUR = 1000;

    private static final double NIVEAUX = 255;

    /** Écart visible, en niveaux. */
    public static final int VISIBLE = 8;

    /** Nombre de sous-pixels par côté ; chacun reçoit un rayon en un point au hasard. */
    public static final int COTE = 8;

    /** Nombre de rayons de chaque pixel tiré, pour les deux images. */
    public static final int RAYONS = 2 * COTE * COTE;

    private final double[] a;
    private final double[] b;

    /** Rangs des pixels tirés, ligne par ligne. */
    private final int[] pixels;

    /**
     * @param scene n'est pas modifiée
     * @param pas côté des carrés dont un pixel est tiré ; 1 pour tous les pixels
     * @param cote nombre de sous-pixels par côté
     * @param parmi les pixels, par colonne et ligne, dont les autres ne sont pas tirés
     */
    public Gabarit(Scene scene, int largeur, int hauteur, int pas, int cote, BiPredicate<Integer, Integer> parmi) {
        boolean[] semes = semer(largeur, hauteur, pas);
        IntStream.range(0, semes.length).forEach(k -> semes[k] &= parmi.test(k % largeur, k / largeur));
        pixels = IntStream.range(0, semes.length).filter(k -> semes[k]).toArray();
        a = image(scene, largeur, hauteur, k -> semes[k], cote, 1).getComposantes();
        b = image(scene, largeur, hauteur, k -> semes[k], cote, 2).getComposantes();
    }

    /** Un pavé sur quatre, régulièrement espacés : dit si ce pixel en est. */
    public static boolean dunPaveSurQuatre(int i, int j) {
        return (i / Pave.COTE + 2 * (j / Pave.COTE)) % 4 == 0;
    }

    private static boolean[] semer(int largeur, int hauteur, int pas) {
        boolean[] semes = new boolean[largeur * hauteur];
        SplittableRandom hasard = new SplittableRandom(pas);
        for (int j = 0; j < hauteur; j += pas) {
            for (int i = 0; i < largeur; i += pas) {
                semes[(j + hasard.nextInt(Math.min(pas, hauteur - j))) * largeur
                        + i + hasard.nextInt(Math.min(pas, largeur - i))] = true;
            }
        }
        return semes;
    }

    /**
     * Une estimation de la vérité : un rayon en un point au hasard de chaque sous-pixel, toujours le même pour une graine.
     *
     * @param voulus les pixels à estimer, par leurs rangs ; les autres restent noirs
     */
    public static ImageLineaire image(Scene scene, int largeur, int hauteur, IntPredicate voulus, int cote, long graine) {
        Echantillonnage auHasard = (pave, demandes, vue, toile) -> {
            for (int j = pave.j0; j < pave.j1; j++) {
                for (int i = pave.i0; i < pave.i1; i++) {
                    if (voulus.test(j * largeur + i)) {
                        SplittableRandom hasard = new SplittableRandom(graine << 2 * Short.SIZE | j << Short.SIZE | i);
                        toile.drawPixel(moyenne(vue, i, j, cote, hasard), i, j);
                    }
                }
            }
            return Releve.RIEN;
        };
        Lancer lancer = Dessin.lancer(scene.avec(scene.getModele().avec(auHasard, 0)), largeur, hauteur, false);
        return ImageLineaire.de(lancer, PROFONDEUR, Runtime.getRuntime().availableProcessors());
    }

    /** La moyenne d'un rayon au hasard dans chacun des sous-pixels d'un pixel. */
    private static Couleur moyenne(Vue vue, int i, int j, int cote, SplittableRandom hasard) {
        Couleur somme = new Couleur();
        for (int k = 0; k < cote * cote; k++) {
            somme = somme.add(vue.couleur(i + (k % cote + hasard.nextDouble()) / cote, j + (k / cote + hasard.nextDouble()) / cote));
        }
        return somme.div(cote * cote);
    }

    /** Le carré de l'erreur de chaque pixel tiré, en niveaux², estimé sans biais : il peut être négatif. */
    public double[] carres(ImageLineaire image) {
        double[] x = image.getComposantes();
        double[] carres = new double[pixels.length];
        for (int p = 0; p < pixels.length; p++) {
            for (int k = 3 * pixels[p]; k < 3 * pixels[p] + 3; k++) {
                // là où les deux ensemble saturent l'écran, limiter chacune serait un biais
                double moins = a[k] + b[k] >= 2 ? 1 : 0;
                double niveau = niveau(x[k]);
                carres[p] += (niveau - niveau(Math.max(moins, a[k]))) * (niveau - niveau(Math.max(moins, b[k]))) / 3;
            }
        }
        return carres;
    }

    /** La part des pixels tirés dont une composante s'écarte de la référence de plus de {@value #VISIBLE} niveaux. */
    public double visibles(ImageLineaire image) {
        double[] x = image.getComposantes();
        return (double) Arrays.stream(pixels).filter(p -> IntStream.range(3 * p, 3 * p + 3)
                .anyMatch(k -> Math.abs(niveau(x[k]) - (niveau(a[k]) + niveau(b[k])) / 2) > VISIBLE)).count() / pixels.length;
    }

    private static double niveau(double composante) {
        return NIVEAUX * Math.max(0, Math.min(1, composante));
    }
}
