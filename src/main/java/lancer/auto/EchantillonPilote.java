package lancer.auto;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Couleur;
import lancer.Point;
import lancer.Sphere;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/** Un rayon par pixel dans de petits carreaux répartis sur l'image. Leurs contrastes annoncent où est l'erreur. */
final class EchantillonPilote {

    /** Côté d'un carreau, et plus grand rayon d'un petit objet, en pixels. */
    static final int COTE = 6;
    private static final double PETIT = 1;

    final int largeur;
    /** Pixels, carreau après carreau ; niveaux de leur centre, sans limite des reflets ; rayons moyens par pixel. */
    final int[] pixels;
    final double[][] niveaux;
    final double prix;
    /** Pixels des objets si petits à l'écran qu'un rayon par pixel peut les manquer. */
    final BitSet petits = new BitSet();

    EchantillonPilote(Essais essais, double permis) {
        Camera camera = essais.prepare.getCamera();
        int hauteur = camera.getHauteur();
        largeur = camera.getLargeur();
        essais.prepare.getScene().getObjets().stream().filter(Sphere.class::isInstance)
                .forEach(boule -> marquer((Sphere) boule, camera));
        // leur nombre est au plus la racine du nombre de pixels
        int carreaux = (int) Math.sqrt((double) largeur * hauteur);
        int[] tous = IntStream.range(0, Math.min(carreaux, Pave.nombre(largeur, hauteur, COTE)))
                .mapToObj(rang -> Pave.eparpille(rang, largeur, hauteur, COTE))
                .flatMapToInt(carreau -> IntStream.range(carreau.j0, carreau.j1).flatMap(j ->
                        IntStream.range(largeur * j + carreau.i0, largeur * j + carreau.i1))).toArray();
        niveaux = new double[tous.length][];
        int faits = essais.passer(tous.length, Essais.PROFONDEUR, Essais.SANS_LIMITE, permis, (k, vue) ->
                niveaux[k] = centre(tous[k], vue));
        pixels = Arrays.copyOf(tous, faits);
        prix = essais.rayons.get() / Math.max(1.0, faits);
    }

    /** Le plus grand écart d'une composante, en niveaux, du pixel {@code k} à ses voisins de l'échantillon. */
    double contraste(int k) {
        return IntStream.range(Math.max(0, k - COTE - 1), Math.min(pixels.length, k + COTE + 2))
                .filter(v -> Math.abs(pixels[v] % largeur - pixels[k] % largeur) <= 1
                        && Math.abs(pixels[v] / largeur - pixels[k] / largeur) <= 1).boxed()
                .flatMapToDouble(v -> IntStream.range(0, 3).mapToDouble(c -> Math.abs(niveaux[v][c] - niveaux[k][c])))
                .max().orElse(0);
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

    double[] centre(int pixel, Vue vue) {
        return niveaux(vue.couleur(pixel % largeur + 0.5, pixel / largeur + 0.5));
    }

    /** Les trois composantes, limitées et en niveaux. */
    static double[] niveaux(Couleur couleur) {
        return Arrays.stream(new double[] {couleur.r, couleur.v, couleur.b})
                .map(composante -> 255 * Math.max(0, Math.min(1, composante))).toArray();
    }

    /** Moyenne de (x − a)(x − b) : carré de l'écart, sans biais si a et b sont sans biais et indépendants. */
    static double produit(double[] x, double[] a, double[] b) {
        return ((x[0] - a[0]) * (x[0] - b[0]) + (x[1] - a[1]) * (x[1] - b[1]) + (x[2] - a[2]) * (x[2] - b[2])) / 3;
    }
}
