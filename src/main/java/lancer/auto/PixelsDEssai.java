package lancer.auto;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.SplittableRandom;
import lancer.Camera;
import lancer.Couleur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/**
 * Pixels des essais. Leur probabilité d'être tirés croît avec leur contraste (tirage systématique à probabilités
 * inégales, Madow, 1949). Chaque mesure est divisée par cette probabilité : la somme est sans biais (Horvitz et
 * Thompson, 1952). Les pixels des petits objets forment une strate à part. Deux références indépendantes donnent la
 * couleur de chaque pixel. L'ordre des pixels est au hasard : si les rayons manquent, les premiers suffisent.
 */
final class PixelsDEssai {

    /** Nombre de pixels à tirer : {@code TIRES}, ou {@code PAR_RACINE} fois la racine quatrième du nombre total. */
    private static final int TIRES = 170;
    private static final double PAR_RACINE = 13;
    /** Part maximale des petits objets parmi ces pixels ; nombre minimal de pixels dessinés pour une estimation. */
    private static final double PETITS = 0.25;
    private static final int TIRES_MIN = 12;

    private final Essais essais;
    private final EchantillonPilote pilote;
    private final List<Pixel> pixels = new ArrayList<>();
    private final Map<Integer, Pixel> parRang = new HashMap<>();
    private final double image;
    /** Nombre des premiers pixels qui ont leurs références, et nombre de ceux qui sont aussi dessinés. */
    private final int justes;
    private int dessines;

    /** Un pixel tiré : ses deux références et sa couleur dessinée, en niveaux, et les rayons de son dessin. */
    private static final class Pixel {
        int rang;
        double probabilite;
        double partDeLImage;
        double[] a;
        double[] b;
        double[] dessine;
        long lances;
    }

    /** @param debut de 0 à 1, décale les pixels tirés @param erreur à mesurer, en niveaux @param permis rayons */
    PixelsDEssai(Essais essais, EchantillonPilote pilote, double debut, double erreur, double permis) {
        this.essais = essais;
        this.pilote = pilote;
        // une référence a un point au hasard dans chaque case d'une grille de ce côté
        int cote = (int) Math.max(3, Math.min(6, 4.3 / Math.sqrt(erreur)));
        int[] petits = pilote.petits.stream().toArray();
        image = (double) pilote.largeur * essais.prepare.getCamera().getHauteur();
        double part = petits.length / image;
        double[] poids = Arrays.stream(pilote.pixels).mapToDouble(p -> pilote.petits.get(p) ? 0 : 1).toArray();
        // tout pixel peut être tiré : au contraste s'ajoutent 0,03 niveau et une part du contraste moyen
        Arrays.setAll(poids, k -> poids[k] * (0.03 + pilote.contraste(k)));
        double commun = 0.3 * Arrays.stream(poids).average().orElse(0);
        Arrays.setAll(poids, k -> poids[k] > 0 ? poids[k] + commun : 0);
        int nombre = (int) Math.max(TIRES, PAR_RACINE * Math.sqrt(Math.sqrt(image)));
        tirer(petits, Arrays.stream(petits).mapToDouble(p -> 1).toArray(), debut, (int) (PETITS * nombre), part);
        tirer(pilote.pixels, poids, debut, nombre - pixels.size(), 1 - part);
        Collections.shuffle(pixels, new Random(1));
        justes = essais.passer(pixels.size(), Essais.PROFONDEUR, Essais.SANS_LIMITE, permis, (k, vue) -> {
            Pixel pixel = pixels.get(k);
            SplittableRandom hasard = new SplittableRandom(pixel.rang);
            pixel.a = reference(pixel.rang, cote, hasard, vue);
            pixel.b = reference(pixel.rang, cote, hasard, vue);
        });
        dessines = justes;
        pixels.subList(0, justes).forEach(pixel -> parRang.put(pixel.rang, pixel));
    }

    /** Tire environ {@code combien} de ces pixels, avec des probabilités proportionnelles aux poids. */
    private void tirer(int[] parmi, double[] poids, double debut, int combien, double part) {
        double somme = Arrays.stream(poids).sum();
        double nombre = Arrays.stream(poids).filter(p -> p > 0).count();
        double cumul = debut;
        for (int k = 0; k < parmi.length; k++) {
            double probabilite = combien * poids[k] / somme;
            if (Math.floor(cumul + probabilite) > Math.floor(cumul)) {
                Pixel pixel = new Pixel();
                pixel.rang = parmi[k];
                pixel.probabilite = Math.min(1, probabilite);
                pixel.partDeLImage = part / nombre / pixel.probabilite;
                pixels.add(pixel);
            }
            cumul += probabilite;
        }
    }

    private double[] reference(int rang, int cote, SplittableRandom hasard, Vue vue) {
        Couleur somme = new Couleur();
        for (int k = 0; k < cote * cote; k++) {
            somme = somme.add(vue.couleur(rang % pilote.largeur + (k % cote + hasard.nextDouble()) / cote,
                    rang / pilote.largeur + (k / cote + hasard.nextDouble()) / cote));
        }
        return EchantillonPilote.niveaux(somme.div(cote * cote));
    }

    /** Retient cette couleur si ce pixel est tiré. Plusieurs fils peuvent appeler cette méthode à la fois. */
    void retenir(Couleur couleur, int i, int j) {
        Pixel pixel = parRang.get(j * pilote.largeur + i);
        if (pixel != null) {
            pixel.dessine = EchantillonPilote.niveaux(couleur);
        }
    }

    /** Dessine ces pixels, ou seulement les premiers si les rayons permis ne suffisent pas. */
    void dessiner(Echantillonnage echantillonnage, Limite limite, double permis) {
        Camera camera = essais.prepare.getCamera();
        Echantillonnage prepare = echantillonnage == null ? null
                : echantillonnage.pour(essais.prepare.getScene().getObjets(), camera);
        dessines = essais.passer(justes, limite.reflets, limite.seuil, permis, (k, vue) -> {
            Pixel pixel = pixels.get(k);
            int i = pixel.rang % pilote.largeur;
            int j = pixel.rang / pilote.largeur;
            Pave pave = Pave.autour(i, j, pilote.largeur, camera.getHauteur());
            pixel.lances = 0;
            // les rayons des pixels voisins n'entrent pas dans le prix de ce pixel
            Vue comptee = (xe, ye) -> {
                long avant = vue.rayons();
                Couleur couleur = vue.couleur(xe, ye);
                pixel.lances += Math.floor(xe) == i && Math.floor(ye) == j ? vue.rayons() - avant : 0;
                return couleur;
            };
            if (prepare == null) {
                pixel.dessine = pilote.centre(pixel.rang, comptee);
            } else {
                prepare.tracer(pave, new Pave(i, j, i + 1, j + 1), comptee, (couleur, x, y) ->
                        pixel.dessine = x == i && y == j ? EchantillonPilote.niveaux(couleur) : pixel.dessine);
            }
        });
    }

    /** Dit s'il y a assez de pixels dessinés pour estimer une erreur. */
    boolean mesure() {
        return dessines >= TIRES_MIN;
    }

    /** Nombre de rayons de toutes sortes par pixel de l'image, estimé d'après {@link #dessiner}. */
    double prix() {
        return pixels.stream().limit(dessines).mapToDouble(pixel -> pixel.partDeLImage * pixel.lances).sum()
                / pixels.stream().limit(dessines).mapToDouble(pixel -> pixel.partDeLImage).sum();
    }

    /** Carré de l'erreur de l'image, estimé sur les pixels dessinés. */
    Estimation erreur() {
        if (!mesure()) {
            return Estimation.INCONNUE;
        }
        double fois = (double) pixels.size() / dessines;
        double somme = 0;
        double variance = 0;
        for (Pixel pixel : pixels.subList(0, dessines)) {
            double carre = EchantillonPilote.produit(pixel.dessine, pixel.a, pixel.b);
            double part = fois * pixel.partDeLImage * carre;
            somme += part;
            variance += (1 - pixel.probabilite / fois) * part * part;
            // l'échantillon pilote n'est lui-même qu'une partie de l'image
            variance += Math.max(0, part * carre) * EchantillonPilote.COTE * (1.0 / pilote.pixels.length - 1 / image);
        }
        return new Estimation(somme, variance);
    }
}
