package lancer.auto;

import java.util.Arrays;
import java.util.BitSet;
import java.util.SplittableRandom;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import lancer.Couleur;
import lancer.Lancer;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Des pixels d'une image, tirés au hasard, et deux références de chacun : la moyenne de rayons au hasard, sans limite
 * de réflexions. Les références a et b sont indépendantes et sans biais. La moyenne de (x − a)(x − b) estime donc sans
 * biais le carré de l'erreur des couleurs x. C'est aussi la toile qui retient ces couleurs.
 */
public final class Echantillon implements Toile {

    /** Nombre de pixels d'un essai : une part de l'image, entre ces bornes ; un contrôle en a le double. */
    private static final int PART = 50;
    private static final int MOINS = 600;
    private static final int PLUS = 1200;
    /** Une image plus petite qu'un essai et trois contrôles est mesurée en entier. */
    private static final int PETITE = 7 * MOINS;
    /** Seuil d'un rayon sans limite : au-dessous de ce produit des Ks, un reflet est invisible. */
    private static final double SANS_LIMITE = 1e-9;

    private final Lancer prepare;
    private final int fils;
    private final int largeur;
    /** Le double du rang de chaque pixel, dans l'ordre ; les niveaux de ses références, et de sa couleur dessinée. */
    private final int[] doubles;
    private final double[][] a;
    private final double[][] b;
    private final double[][] x;
    /** Nombre de rayons de toutes sortes lancés pour cet échantillon. */
    long rayons;

    /**
     * Tire de nouveaux pixels. Une petite image les donne tous, plusieurs fois.
     *
     * @param prepare la scène, prête à être dessinée
     * @param essais le nombre voulu de pixels, 1 pour un essai, 2 pour un contrôle
     * @param cote racine du nombre de rayons d'une référence
     * @param tires les pixels déjà tirés, auxquels les nouveaux s'ajoutent
     */
    public Echantillon(Lancer prepare, int fils, int essais, int cote, SplittableRandom hasard, BitSet tires) {
        this.prepare = prepare;
        this.fils = fils;
        largeur = prepare.getCamera().getLargeur();
        int image = largeur * prepare.getCamera().getHauteur();
        int nombre = essais * Math.max(MOINS, Math.min(PLUS, image / PART));
        doubles = (image < PETITE ? IntStream.range(0, (nombre + image - 1) / image * image).map(k -> k % image)
                : IntStream.generate(() -> hasard.nextInt(image)).filter(p -> !tires.get(p)).peek(tires::set)
                .limit(nombre)).map(rang -> 2 * rang).sorted().toArray();
        a = new double[doubles.length][];
        b = new double[doubles.length][];
        x = new double[doubles.length][];
        long graine = hasard.nextLong();
        tracer(Echelon.PROFONDEUR, SANS_LIMITE, (pave, voulus, vue, toile) -> parcourir(pave, k -> {
            SplittableRandom sien = new SplittableRandom(graine + k);
            a[k] = reference(k, cote, sien, vue);
            b[k] = reference(k, cote, sien, vue);
        }));
    }

    private void tracer(int reflets, double seuil, Echantillonnage visite) {
        Lancer lancer = new Echelon(null, visite, reflets, seuil).lancer(prepare);
        lancer.TracerPixels(this, reflets, fils);
        rayons += lancer.getCompteurs().rayons();
    }

    private int parcourir(Pave pave, IntConsumer visite) {
        for (int j = pave.j0; j < pave.j1; j++) {
            IntStream.range(premier(j * largeur + pave.i0), premier(j * largeur + pave.i1)).forEach(visite);
        }
        return 0;
    }

    /** Le premier indice d'un pixel de ce rang ou, à défaut, d'un rang suivant. */
    private int premier(int rang) {
        // un nombre impair n'est pas dans le tableau : la recherche rend sa place
        return -1 - Arrays.binarySearch(doubles, 2 * rang - 1);
    }

    private double[] reference(int indice, int cote, SplittableRandom hasard, Vue vue) {
        int rang = doubles[indice] / 2;
        Couleur somme = new Couleur();
        for (int k = 0; k < cote * cote; k++) {
            somme = somme.add(vue.couleur(rang % largeur + (k % cote + hasard.nextDouble()) / cote,
                    rang / largeur + (k / cote + hasard.nextDouble()) / cote));
        }
        return niveaux(somme.div(cote * cote));
    }

    /** Les trois composantes, limitées et en niveaux. */
    static double[] niveaux(Couleur couleur) {
        return Arrays.stream(new double[] {couleur.r, couleur.v, couleur.b})
                .map(composante -> 255 * Math.max(0, Math.min(1, composante))).toArray();
    }

    /** Retient cette couleur si ce pixel est de l'échantillon. */
    @Override
    public void drawPixel(Couleur couleur, int xe, int ye) {
        int rang = ye * largeur + xe;
        for (int k = premier(rang); k < x.length && doubles[k] == 2 * rang; k++) {
            x[k] = niveaux(couleur);
        }
    }

    /** Dessine ces seuls pixels avec ce réglage, et mesure son erreur. */
    public Mesure essayer(Echelon echelon) {
        Echantillonnage choisi = echelon.echantillonnage != null
                ? echelon.echantillonnage.pour(prepare.getScene().getObjets(), prepare.getCamera())
                : (pave, lui, vue, toile) -> {
                    toile.drawPixel(vue.couleur(lui.i0 + 0.5, lui.j0 + 0.5), lui.i0, lui.j0);
                    return 0;
                };
        tracer(echelon.reflets, echelon.seuil, (pave, voulus, vue, toile) -> parcourir(pave, k -> {
            int i = doubles[k] / 2 % largeur;
            int j = doubles[k] / 2 / largeur;
            if (k == premier(doubles[k] / 2)) {
                choisi.tracer(pave, new Pave(i, j, i + 1, j + 1), vue, toile);
            }
        }));
        return mesurer();
    }

    /** L'erreur des couleurs retenues. */
    public Mesure mesurer() {
        return new Mesure(IntStream.range(0, x.length).mapToDouble(k -> IntStream.range(0, 3)
                .mapToDouble(c -> (x[k][c] - a[k][c]) * (x[k][c] - b[k][c]) / 3).sum()).toArray());
    }
}
