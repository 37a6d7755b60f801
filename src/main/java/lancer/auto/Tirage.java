package lancer.auto;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Couleur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Vue;

/**
 * Quelques pixels d'un semis, tirés avec une probabilité qui croît avec leur contraste (tirage systématique à
 * probabilités inégales, Madow, 1949). Chaque mesure est divisée par sa probabilité : la somme est sans biais (Horvitz
 * et Thompson, 1952). Les pixels des petits objets sont une strate à part. Deux références indépendantes disent la
 * couleur de chacun. Ils sont dans un ordre au hasard : les premiers, si les rayons manquent, en sont un tirage encore.
 */
final class Tirage {

    /** Nombre à tirer de chaque strate, au plus ; moins que le dernier, ce n'est pas la peine. */
    private static final int TIRES = 260;
    private static final int PETITS = 80;
    private static final int TIRES_MIN = 12;

    /** Erreur que promet tout pixel, rapporté à la moyenne des contrastes ; et, en niveaux, d'une image unie. */
    private static final double PLANCHER = 0.3;

    /** Côté de la grille : chacune des deux références a un point au hasard dans chacune de ses cases. */
    private static final double COTE_POUR_UN_NIVEAU = 4.3;
    private static final int COTE_MIN = 3;
    private static final int COTE_MAX = 6;

    private final Essais essais;
    private final Semis semis;
    private final List<Pixel> pixels = new ArrayList<>();
    private final Map<Integer, Pixel> parRang = new HashMap<>();
    private final double image;

    /** Nombre de ceux qui ont leurs références, des premiers ; et combien d'entre eux sont dessinés. */
    private final int justes;
    private int dessines;

    /** Un pixel tiré, ses deux références et ce qu'un dessin y met, en niveaux, et les rayons qu'il y lance. */
    private static final class Pixel {
        int rang;
        double probabilite;
        double partDeLImage;
        double[] a;
        double[] b;
        double[] dessine;
        long lances;
    }

    /** @param debut de 0 à 1 : un autre tire ailleurs @param erreur à mesurer, en niveaux @param permis rayons */
    Tirage(Essais essais, Semis semis, double debut, double erreur, double permis) {
        this.essais = essais;
        this.semis = semis;
        int cote = (int) Math.max(COTE_MIN, Math.min(COTE_MAX, COTE_POUR_UN_NIVEAU / Math.sqrt(erreur)));
        int[] aPart = semis.petits.stream().toArray();
        image = (double) semis.largeur * essais.prepare.getCamera().getHauteur();
        double part = aPart.length / image;
        double[] promesses = IntStream.range(0, semis.pixels.length)
                .mapToDouble(k -> semis.petits.get(semis.pixels[k]) ? 0 : semis.contraste(k)).toArray();
        double plancher = 0.03 + PLANCHER * Arrays.stream(promesses).average().orElse(0);
        Arrays.setAll(promesses, k -> semis.petits.get(semis.pixels[k]) ? 0 : promesses[k] + plancher);
        tirer(aPart, Arrays.stream(aPart).mapToDouble(p -> 1).toArray(), debut, PETITS, part);
        tirer(semis.pixels, promesses, debut, TIRES + PETITS - pixels.size(), 1 - part);
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

    /** Tire de ces pixels, d'autant plus volontiers qu'ils promettent ; 0 : jamais. */
    private void tirer(int[] parmi, double[] promesses, double debut, int combien, double part) {
        double somme = Arrays.stream(promesses).sum();
        double nombre = Arrays.stream(promesses).filter(promesse -> promesse > 0).count();
        double cumul = debut;
        for (int k = 0; k < parmi.length; k++) {
            double probabilite = combien * promesses[k] / somme;
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
            somme = somme.add(vue.couleur(rang % semis.largeur + (k % cote + hasard.nextDouble()) / cote,
                    rang / semis.largeur + (k / cote + hasard.nextDouble()) / cote));
        }
        return Semis.niveaux(somme.div(cote * cote));
    }

    /** Retient cette couleur si c'est celle d'un des pixels ; un autre fil peut en retenir une autre. */
    void retenir(Couleur couleur, int i, int j) {
        Pixel pixel = parRang.get(j * semis.largeur + i);
        if (pixel != null) {
            pixel.dessine = Semis.niveaux(couleur);
        }
    }

    /** Dessine ces pixels, ou les premiers si ces rayons n'y suffisent pas. */
    void dessiner(Echantillonnage echantillonnage, Limite limite, double permis) {
        Camera camera = essais.prepare.getCamera();
        Echantillonnage prepare = echantillonnage == null ? null
                : echantillonnage.pour(essais.prepare.getScene().getObjets(), camera);
        dessines = essais.passer(justes, limite.reflets, limite.seuil, permis, (k, vue) -> {
            Pixel pixel = pixels.get(k);
            int i = pixel.rang % semis.largeur;
            int j = pixel.rang / semis.largeur;
            Pave pave = Pave.autour(i, j, semis.largeur, camera.getHauteur());
            pixel.lances = 0;
            // ce qui entoure le pixel ne se compte pas
            Vue comptee = (xe, ye) -> {
                long avant = vue.rayons();
                Couleur couleur = vue.couleur(xe, ye);
                pixel.lances += Math.floor(xe) == i && Math.floor(ye) == j ? vue.rayons() - avant : 0;
                return couleur;
            };
            if (prepare == null) {
                pixel.dessine = Semis.niveaux(comptee.couleur(i + 0.5, j + 0.5));
            } else {
                prepare.tracer(pave, new Pave(i, j, i + 1, j + 1), comptee, (couleur, x, y) ->
                        pixel.dessine = x == i && y == j ? Semis.niveaux(couleur) : pixel.dessine);
            }
        });
    }

    /** Faux si trop peu de pixels sont dessinés pour en rien dire. */
    boolean mesure() {
        return dessines >= TIRES_MIN;
    }

    /** Rayons de toutes sortes par pixel de l'image, de ceux qu'a lancés {@link #dessiner}. */
    double prix() {
        return pixels.stream().limit(dessines).mapToDouble(pixel -> pixel.partDeLImage * pixel.lances).sum()
                / pixels.stream().limit(dessines).mapToDouble(pixel -> pixel.partDeLImage).sum();
    }

    Estimation erreur() {
        double fois = (double) pixels.size() / dessines;
        double somme = 0;
        double variance = 0;
        for (Pixel pixel : pixels.subList(0, dessines)) {
            double carre = Semis.produit(pixel.dessine, pixel.a, pixel.b);
            double part = fois * pixel.partDeLImage * carre;
            somme += part;
            variance += (1 - pixel.probabilite / fois) * part * part;
            // les carreaux eux-mêmes ne sont que quelques-uns de l'image
            variance += Math.max(0, part * carre) * Semis.COTE * (1.0 / semis.pixels.length - 1 / image);
        }
        return new Estimation(somme, variance);
    }
}
