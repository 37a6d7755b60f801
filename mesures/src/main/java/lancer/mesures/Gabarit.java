package lancer.mesures;

import java.util.SplittableRandom;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;
import lancer.temoins.LancerSurveille;

/**
 * De quoi mesurer l'erreur d'une image sans calculer la vérité : deux images a et b de la scène sans limite, chacune sans biais et
 * d'erreurs sans rapport. La moyenne de (x − a)(x − b) sur tous les pixels tend alors vers celle de (x − vérité)², pour bien moins
 * de rayons que {@link Verite}, dont elle ne diffère que d'un peu de hasard. Couleurs limitées à [0, 1], en niveaux.
 */
final class Gabarit {

    private static final double NIVEAUX = 255;

    /** Sous-pixels d'un côté ; un rayon au hasard dans chacun. */
    private static final int COTE = 8;

    /** Ce qui est négligé d'un reflet : 0,004 niveau pour une lumière de 1. */
    private static final double SEUIL = 1.0 / 65536;

    private final double[] a;
    private final double[] b;

    /** @param scene elle n'est pas changée */
    Gabarit(Scene scene, int largeur, int hauteur) {
        a = image(scene, largeur, hauteur, 1);
        b = image(scene, largeur, hauteur, 2);
    }

    private static double[] image(Scene scene, int largeur, int hauteur, long graine) {
        Lancer lancer = LancerSurveille.preparer(scene.avec(new AuHasard(graine), SEUIL), largeur, hauteur, false);
        return ImageLineaire.de(lancer, Verite.PROFONDEUR, Runtime.getRuntime().availableProcessors()).getComposantes();
    }

    /** L'erreur quadratique moyenne de cette image, en niveaux. */
    double erreur(ImageLineaire image) {
        return erreur(image, a, b);
    }

    /** La même contre une vérité. */
    static double erreur(ImageLineaire image, ImageLineaire verite) {
        return erreur(image, verite.getComposantes(), verite.getComposantes());
    }

    private static double erreur(ImageLineaire image, double[] a, double[] b) {
        double[] x = image.getComposantes();
        double somme = 0;
        for (int k = 0; k < x.length; k++) {
            double niveau = niveau(x[k]);
            somme += (niveau - niveau(a[k])) * (niveau - niveau(b[k]));
        }
        return Math.sqrt(Math.max(0, somme / x.length));
    }

    private static double niveau(double composante) {
        return NIVEAUX * Math.max(0, Math.min(1, composante));
    }

    /** Un rayon en un point au hasard de chaque sous-pixel ; toujours le même pour une graine. Immuable. */
    private static final class AuHasard implements Echantillonnage {

        private final long graine;

        AuHasard(long graine) {
            this.graine = graine;
        }

        @Override
        public int tracer(Pave pave, Vue vue, Toile toile) {
            for (int j = pave.j0; j < pave.j1; j++) {
                for (int i = pave.i0; i < pave.i1; i++) {
                    SplittableRandom hasard = new SplittableRandom(graine << 2 * Short.SIZE | j << Short.SIZE | i);
                    Couleur somme = new Couleur();
                    for (int k = 0; k < COTE * COTE; k++) {
                        somme = somme.add(vue.couleur(i + (k % COTE + hasard.nextDouble()) / COTE,
                                j + (k / COTE + hasard.nextDouble()) / COTE));
                    }
                    toile.drawPixel(somme.div(COTE * COTE), i, j);
                }
            }
            return 0;
        }
    }
}
