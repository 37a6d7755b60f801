package lancer.mesures;

import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.RechercheSimple;
import lancer.contrat.Toile;
import lancer.sortie.ImageMemoire;

/**
 * Une image dont quelques pixels, tirés au hasard, gardent leur couleur entière, pour que le chemin lisible (les boucles du
 * cours, {@link Lancer#getCouleurPixel}) les refasse et les compare, au bit près.
 */
final class Temoin implements Toile {

    /** Pixels gardés. */
    static final int PIXELS = 2000;

    /** Pixels refaits quoi qu'il en coûte : sur un million de sphères, l'un d'eux prend un dixième de seconde. */
    static final int PIXELS_MIN = 16;

    private static final long GRAINE = 800600;

    private final int largeur;
    private final ImageMemoire image;

    /** Les pixels gardés, dans l'ordre du tirage, et de chaque pixel de l'image son rang dans ce tirage, −1 s'il n'y est pas. */
    private final int[] pixels;
    private final int[] rangs;
    private final Couleur[] couleurs;

    Temoin(int largeur, int hauteur) {
        this.largeur = largeur;
        image = new ImageMemoire(largeur, hauteur, false);
        pixels = new Random(GRAINE).ints(0, largeur * hauteur).distinct().limit(Math.min(PIXELS, largeur * hauteur)).toArray();
        rangs = new int[largeur * hauteur];
        Arrays.fill(rangs, -1);
        for (int k = 0; k < pixels.length; k++) {
            rangs[pixels[k]] = k;
        }
        couleurs = new Couleur[pixels.length];
    }

    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        image.drawPixel(coul, xe, ye);
        int rang = rangs[ye * largeur + xe];
        if (rang >= 0) {
            couleurs[rang] = coul;
        }
    }

    /** Les codes de tous les pixels, gardés ou non. */
    int[] getCodes() {
        return image.getCodes();
    }

    /**
     * Refait les pixels gardés, dans l'ordre du tirage, sur tous les cœurs : {@link #PIXELS_MIN}, puis tant qu'il reste du temps.
     *
     * @param dureeNs temps accordé
     * @return le nombre de pixels refaits
     * @throws ImageFausse si l'un d'eux n'a pas la couleur gardée
     */
    int verifier(Scene scene, Camera camera, long dureeNs) {
        long debut = System.nanoTime();
        AtomicInteger suivant = new AtomicInteger();
        AtomicInteger verifies = new AtomicInteger();
        IntStream.range(0, Runtime.getRuntime().availableProcessors()).parallel().forEach(coeur -> {
            for (int k = suivant.getAndIncrement(); k < pixels.length
                    && (k < PIXELS_MIN || System.nanoTime() - debut < dureeNs); k = suivant.getAndIncrement()) {
                comparer(scene, camera, k);
                verifies.incrementAndGet();
            }
        });
        return verifies.get();
    }

    private void comparer(Scene scene, Camera camera, int k) {
        int xe = pixels[k] % largeur;
        int ye = pixels[k] / largeur;
        Scene lisible = scene.pourUnFil();
        lisible.setRecherche(new RechercheSimple(lisible.getObjets(), lisible.getCompteurs()));
        Couleur juste = new Lancer(lisible, camera).getCouleurPixel(xe + 0.5, ye + 0.5, Constantes.MAX_REFLETS);
        if (!identiques(juste, couleurs[k])) {
            throw new ImageFausse("le pixel (" + xe + ", " + ye + ") est " + couleurs[k] + " au lieu de " + juste);
        }
    }

    /** Mêmes bits : ni la tolérance d'un écran, ni l'égalité de 0 et −0. */
    private static boolean identiques(Couleur a, Couleur b) {
        return b != null && memesBits(a.r, b.r) && memesBits(a.v, b.v) && memesBits(a.b, b.b);
    }

    private static boolean memesBits(double a, double b) {
        return Double.doubleToRawLongBits(a) == Double.doubleToRawLongBits(b);
    }
}
