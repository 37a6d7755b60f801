package lancer.auto;

import java.util.Arrays;
import java.util.BitSet;
import java.util.SplittableRandom;
import java.util.function.IntConsumer;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lancer;
import lancer.commande.Reglages;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Des pixels d'une image, et deux références de chacun : la moyenne de rayons au hasard, sans limite de réflexions. Les
 * références a et b sont indépendantes : la moyenne de (x − a)(x − b) estime le carré de l'erreur des couleurs x. C'est
 * aussi la toile qui retient ces couleurs.
 */
public final class Echantillon implements Toile {

    /** Part de l'image que mesure un essai, et bornes de son nombre de pixels ; un contrôle en a le double. */
    private static final int PART = 100;
    private static final int MOINS = 200;
    private static final int PLUS = 700;
    /** Seuil d'un rayon sans limite : au-dessous de ce produit des Ks, un reflet est invisible. */
    private static final double SANS_LIMITE = 1e-9;
    /** En niveaux : écart de voisins semblables, de références sûres, d'une couleur juste. */
    private static final double SEMBLABLES = 2;
    private static final double SURES = 6;
    private static final double JUSTE = 0.5;

    /** Un pixel tiré : les niveaux de ses références, et de la couleur à mesurer. */
    private static final class Pixel {
        double[] a;
        double[] b;
        double[] x = new double[3];

        /** Le carré de l'erreur, estimé sans biais. */
        double carre() {
            return IntStream.range(0, 3).mapToDouble(c -> (x[c] - a[c]) * (x[c] - b[c]) / 3).sum();
        }

        boolean estJuste() {
            return ecart(x, a) <= JUSTE && ecart(x, b) <= JUSTE;
        }
    }

    private final Lancer prepare;
    private final int fils;
    private final int largeur;
    /** Les pixels tirés, par leur rang dans l'image ; {@code null} pour les autres. */
    private final Pixel[] pixels;
    /** Nombre de pixels dont les voisins se ressemblent, puis des autres, les bords ; rangs de ceux qui sont tirés. */
    private final int[] tailles;
    private final int[][] strates;
    /** Nombre de rayons de toutes sortes lancés pour cet échantillon. */
    long rayons;

    /**
     * Tire des pixels.
     *
     * @param prepare la scène, prête à être dessinée
     * @param dessinee couleur de chaque pixel d'une image, par son rang : l'échantillon la retient, et la moitié de ses
     *        pixels sont des bords de cette image ; {@code null} pour un essai
     * @param voulue erreur voulue, en niveaux, dont dépend le nombre de rayons d'une référence
     * @param permis nombre de premiers rayons à ne pas dépasser, si toutes les références en avaient neuf fois plus
     */
    public Echantillon(Lancer prepare, int fils, IntFunction<Couleur> dessinee, double voulue, long permis,
            SplittableRandom hasard) {
        this.prepare = prepare;
        this.fils = fils;
        Camera camera = prepare.getCamera();
        largeur = camera.getLargeur();
        pixels = new Pixel[largeur * camera.getHauteur()];
        BitSet contrastes = dessinee == null ? new BitSet() : trouverLesBords(dessinee);
        int[] bords = contrastes.stream().toArray();
        int[] reste = IntStream.range(0, pixels.length).filter(p -> !contrastes.get(p)).toArray();
        tailles = new int[] {reste.length, bords.length};
        int cote = (int) Math.max(2, Math.min(12, Math.rint(3 / Math.cbrt(voulue))));
        int nombre = pixels.length;
        if (nombre >= 8 * MOINS) {
            nombre = (dessinee == null ? 1 : 2) * Math.max(MOINS, Math.min(PLUS, nombre / PART));
            nombre = (int) Math.max(MOINS, Math.min(nombre, permis / (2 * 9 * cote * cote)));
        }
        int auxBords = Math.min(bords.length, Math.max(nombre / 2, nombre - reste.length));
        strates = new int[][] {tirer(reste, nombre - auxBords, hasard), tirer(bords, auxBords, hasard)};
        getRangs().forEach(p -> {
            pixels[p] = new Pixel();
            if (dessinee != null) {
                pixels[p].x = vue(dessinee.apply(p));
            }
        });
        long graine = hasard.nextLong();
        tracer(Echelle.PROFONDEUR, prepare.getScene().getModele().avec(null, SANS_LIMITE),
                (pave, voulus, vue, toile) -> parcourir(pave,
                        p -> juger(p, contrastes.get(p), cote, new SplittableRandom(graine + p), vue)));
    }

    /** Les pixels dont un des huit voisins ne leur ressemble pas. */
    private BitSet trouverLesBords(IntFunction<Couleur> dessinee) {
        BitSet trouves = new BitSet();
        for (int p = 0; p < pixels.length; p++) {
            // les voisins qui précèdent ont déjà été comparés ; ceux d'une ligne à l'autre ne changent qu'une strate
            for (int q : new int[] {p + 1, p + largeur - 1, p + largeur, p + largeur + 1}) {
                if (q < pixels.length && ecart(vue(dessinee.apply(p)), vue(dessinee.apply(q))) > SEMBLABLES) {
                    trouves.set(p);
                    trouves.set(q);
                }
            }
        }
        return trouves;
    }

    /** Tire tant de pixels différents d'une strate. */
    private static int[] tirer(int[] strate, int combien, SplittableRandom hasard) {
        return hasard.ints(0, Math.max(1, strate.length)).distinct().limit(combien).map(k -> strate[k]).toArray();
    }

    /** Les rangs des pixels tirés. */
    IntStream getRangs() {
        return Arrays.stream(strates).flatMapToInt(Arrays::stream);
    }

    private void tracer(int reflets, Modele modele, Echantillonnage visite) {
        Lancer lancer = prepare.avec(modele);
        lancer.TracerPixels(visite, this, reflets, fils);
        rayons += lancer.getCompteurs().rayons();
    }

    /** Visite les pixels tirés d'un pavé. */
    private int parcourir(Pave pave, IntConsumer visite) {
        for (int j = pave.j0; j < pave.j1; j++) {
            IntStream.range(j * largeur + pave.i0, j * largeur + pave.i1)
                    .filter(p -> pixels[p] != null).forEach(visite);
        }
        return 0;
    }

    /** Trouve les deux références d'un pixel ; elles ont neuf fois plus de rayons là où peu ne suffisent pas. */
    private void juger(int p, boolean bord, int cote, SplittableRandom hasard, Vue vue) {
        // deux moyennes ne servent qu'à le savoir : garder celles qui se ressemblent serait un biais
        boolean peu = !bord && ecart(limites(moyenne(p, cote, hasard, vue)), limites(moyenne(p, cote, hasard, vue)))
                <= SURES;
        double[] a = moyenne(p, peu ? cote : 3 * cote, hasard, vue);
        double[] b = moyenne(p, peu ? cote : 3 * cote, hasard, vue);
        for (int c = 0; c < 3; c++) {
            if (a[c] + b[c] >= 2 * 255) {
                // limiter chacune, quand les deux ensemble saturent l'écran, serait un biais aussi
                a[c] = 255;
                b[c] = 255;
            }
        }
        pixels[p].a = limites(a);
        pixels[p].b = limites(b);
    }

    /** La moyenne d'un rayon au hasard par sous-pixel, en niveaux, non limitée. */
    private double[] moyenne(int p, int cote, SplittableRandom hasard, Vue vue) {
        Couleur somme = new Couleur();
        for (int s = 0; s < cote * cote; s++) {
            somme = somme.add(vue.couleur(p % largeur + (s % cote + hasard.nextDouble()) / cote,
                    p / largeur + (s / cote + hasard.nextDouble()) / cote));
        }
        return niveaux(somme.div(cote * cote));
    }

    private static double[] niveaux(Couleur couleur) {
        return new double[] {255 * couleur.r, 255 * couleur.v, 255 * couleur.b};
    }

    private static double[] limites(double[] n) {
        return new double[] {limite(n[0]), limite(n[1]), limite(n[2])};
    }

    private static double limite(double niveau) {
        return Math.max(0, Math.min(255, niveau));
    }

    /** Les niveaux que montre l'écran. */
    private static double[] vue(Couleur couleur) {
        return limites(niveaux(couleur));
    }

    private static double ecart(double[] u, double[] v) {
        return Math.max(Math.abs(u[0] - v[0]), Math.max(Math.abs(u[1] - v[1]), Math.abs(u[2] - v[2])));
    }

    /** Retient cette couleur si ce pixel est de l'échantillon. */
    @Override
    public void drawPixel(Couleur couleur, int xe, int ye) {
        Pixel pixel = pixels[ye * largeur + xe];
        if (pixel != null) {
            pixel.x = vue(couleur);
        }
    }

    /** Dessine ces seuls pixels avec ces réglages, et mesure leur erreur. */
    public Mesure essayer(Reglages reglages) {
        Modele modele = reglages.getModele();
        Echantillonnage sien = modele.getEchantillonnage();
        Echantillonnage choisi = sien != null ? sien.pour(prepare.getScene().getObjets(), prepare.getCamera())
                : (pave, lui, vue, toile) -> {
                    toile.drawPixel(vue.couleur(lui.i0 + 0.5, lui.j0 + 0.5), lui.i0, lui.j0);
                    return 0;
                };
        tracer(reglages.getProfondeur(), modele, (pave, voulus, vue, toile) -> parcourir(pave, p -> {
            int i = p % largeur;
            int j = p / largeur;
            choisi.tracer(pave, new Pave(i, j, i + 1, j + 1), vue, toile);
        }));
        return mesurer();
    }

    /** L'erreur des couleurs retenues. */
    public Mesure mesurer() {
        double[][] carres = Arrays.stream(strates)
                .map(strate -> Arrays.stream(strate).mapToDouble(p -> pixels[p].carre()).toArray())
                .toArray(double[][]::new);
        return new Mesure(tailles, carres, getRangs().allMatch(p -> pixels[p].estJuste()));
    }
}
