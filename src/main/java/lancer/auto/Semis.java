package lancer.auto;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Couleur;
import lancer.Point;
import lancer.Sphere;
import lancer.contrat.Pave;

/** Pixels semés dans l'image par petits carreaux, et un rayon de chacun : où l'erreur doit être. */
final class Semis {

    /** Côté d'un carreau, en pixels, et combien en semer ; plus grand rayon d'un petit objet, en pixels. */
    static final int COTE = 6;
    private static final int CARREAUX = 1000;
    private static final double PETIT = 1;

    final int largeur;

    /** Pixels, carreau après carreau ; ce qu'un rayon sans limite voit en chacun ; son prix, tous rayons comptés. */
    final int[] pixels;
    final double[][] niveaux;
    final double prix;

    /** Pixels des objets si petits à l'écran qu'un rayon par pixel peut les manquer : la scène le sait. */
    final BitSet petits = new BitSet();

    Semis(Essais essais, double permis) {
        Camera camera = essais.prepare.getCamera();
        largeur = camera.getLargeur();
        essais.prepare.getScene().getObjets().stream().filter(Sphere.class::isInstance)
                .forEach(boule -> marquer((Sphere) boule, camera));
        int[] tous = IntStream.range(0, Math.min(CARREAUX, Pave.nombre(largeur, camera.getHauteur(), COTE)))
                .mapToObj(rang -> Pave.eparpille(rang, largeur, camera.getHauteur(), COTE))
                .flatMapToInt(carreau -> IntStream.range(carreau.j0, carreau.j1).flatMap(j ->
                        IntStream.range(largeur * j + carreau.i0, largeur * j + carreau.i1))).toArray();
        niveaux = new double[tous.length][];
        int faits = essais.passer(tous.length, Essais.PROFONDEUR, Essais.SANS_LIMITE, permis, (k, vue) ->
                niveaux[k] = niveaux(vue.couleur(tous[k] % largeur + 0.5, tous[k] / largeur + 0.5)));
        pixels = Arrays.copyOf(tous, faits);
        prix = essais.rayons.get() / Math.max(1.0, faits);
    }

    /** Le plus grand écart du pixel {@code k} et de ses voisins semés près de lui, sur une composante, en niveaux. */
    double contraste(int k) {
        double contraste = 0;
        for (int v = Math.max(0, k - COTE - 1); v <= Math.min(pixels.length - 1, k + COTE + 1); v++) {
            boolean voisin = Math.abs(pixels[v] % largeur - pixels[k] % largeur) <= 1
                    && Math.abs(pixels[v] / largeur - pixels[k] / largeur) <= 1;
            for (int c = 0; c < 3 && voisin; c++) {
                contraste = Math.max(contraste, Math.abs(niveaux[v][c] - niveaux[k][c]));
            }
        }
        return contraste;
    }

    private void marquer(Sphere boule, Camera camera) {
        Point vu = camera.projeter(boule.getCentre());
        double rayon = boule.getRayon() * vu.z;
        int i = (int) Math.max(0, vu.x - rayon);
        int fin = (int) Math.min(largeur, Math.ceil(vu.x + rayon));
        boolean petite = boule.getCentre().z > camera.getEcran(0, 0).z && rayon <= PETIT && i < fin;
        for (int j = (int) Math.max(0, vu.y - rayon); petite && j < Math.min(camera.getHauteur(), vu.y + rayon); j++) {
            petits.set(j * largeur + i, j * largeur + fin);
        }
    }

    /** Les trois composantes, limitées et en niveaux. */
    static double[] niveaux(Couleur couleur) {
        return Arrays.stream(new double[] {couleur.r, couleur.v, couleur.b})
                .map(composante -> 255 * Math.max(0, Math.min(1, composante))).toArray();
    }

    /** La moyenne de (x − a)(x − b) : sans biais, le carré de l'écart de x à ce que a et b, indépendants, estiment. */
    static double produit(double[] x, double[] a, double[] b) {
        return ((x[0] - a[0]) * (x[0] - b[0]) + (x[1] - a[1]) * (x[1] - b[1]) + (x[2] - a[2]) * (x[2] - b[2])) / 3;
    }
}
