package lancer.auto;

import java.util.Arrays;
import java.util.BitSet;
import java.util.SplittableRandom;
import java.util.function.IntConsumer;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
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

    private final Lancer prepare;
    private final int fils;
    private final int largeur;
    /** Nombre de pixels dont les voisins se ressemblent, et des autres, les bords. */
    private final int[] tailles;
    /** Rang de chaque pixel tiré, dans l'ordre ; s'il est d'un bord ; niveaux de ses références, et de sa couleur. */
    private final int[] rangs;
    private final boolean[] bords;
    private final double[][] a;
    private final double[][] b;
    private final double[][] x;
    /** Nombre de rayons de toutes sortes lancés pour cet échantillon. */
    long rayons;

    /**
     * Tire de nouveaux pixels.
     *
     * @param prepare la scène, prête à être dessinée
     * @param dessinee couleur de chaque pixel d'une image, par son rang : l'échantillon la retient, et la moitié de ses
     *        pixels sont des bords de cette image ; {@code null} pour un essai
     * @param voulue erreur voulue, en niveaux, dont dépend le nombre de rayons d'une référence
     * @param permis nombre de premiers rayons à ne pas dépasser, si toutes les références en avaient neuf fois plus
     * @param tires les pixels déjà tirés, auxquels les nouveaux s'ajoutent ; une très petite image donne chaque fois
     *        tous les siens
     */
    public Echantillon(Lancer prepare, int fils, IntFunction<Couleur> dessinee, double voulue, long permis,
            SplittableRandom hasard, BitSet tires) {
        this.prepare = prepare;
        this.fils = fils;
        largeur = prepare.getCamera().getLargeur();
        int image = largeur * prepare.getCamera().getHauteur();
        BitSet tousLesBords = dessinee == null ? new BitSet() : trouverLesBords(dessinee, image);
        BitSet reste = new BitSet();
        reste.set(0, image);
        reste.andNot(tousLesBords);
        tailles = new int[] {reste.cardinality(), tousLesBords.cardinality()};
        boolean petite = image < 8 * MOINS;
        int cote = (int) Math.max(2, Math.min(12, Math.rint(3 / Math.cbrt(voulue))));
        int nombre = (dessinee == null ? 1 : 2) * Math.max(MOINS, Math.min(PLUS, image / PART));
        nombre = petite ? image : (int) Math.max(MOINS, Math.min(nombre, permis / (2 * 9 * cote * cote)));
        BitSet deja = petite ? new BitSet() : tires;
        BitSet choisis = new BitSet();
        choisir(tousLesBords, Math.max(nombre / 2, nombre - tailles[0]), hasard, deja, choisis);
        choisir(reste, nombre - choisis.cardinality(), hasard, deja, choisis);
        tires.or(choisis);
        rangs = choisis.stream().toArray();
        bords = new boolean[rangs.length];
        a = new double[rangs.length][3];
        b = new double[rangs.length][3];
        x = new double[rangs.length][3];
        for (int k = 0; dessinee != null && k < rangs.length; k++) {
            bords[k] = tousLesBords.get(rangs[k]);
            x[k] = vue(dessinee.apply(rangs[k]));
        }
        long graine = hasard.nextLong();
        tracer(Echelle.PROFONDEUR, prepare.getScene().getModele().avec(null, SANS_LIMITE),
                (pave, voulus, vue, toile) -> parcourir(pave,
                        k -> juger(k, cote, new SplittableRandom(graine + k), vue)));
    }

    /** Les pixels dont un des huit voisins ne leur ressemble pas. */
    private BitSet trouverLesBords(IntFunction<Couleur> dessinee, int image) {
        BitSet trouves = new BitSet();
        for (int p = 0; p < image; p++) {
            // les voisins qui précèdent ont déjà été comparés ; ceux d'une ligne à l'autre ne changent qu'une strate
            for (int q : new int[] {p + 1, p + largeur - 1, p + largeur, p + largeur + 1}) {
                if (q < image && ecart(vue(dessinee.apply(p)), vue(dessinee.apply(q))) > SEMBLABLES) {
                    trouves.set(p);
                    trouves.set(q);
                }
            }
        }
        return trouves;
    }

    /** Choisit tant de pixels d'une strate : tous les choix ont la même probabilité (Knuth, algorithme S). */
    private static void choisir(BitSet strate, int combien, SplittableRandom hasard, BitSet deja, BitSet choisis) {
        BitSet libres = (BitSet) strate.clone();
        libres.andNot(deja);
        int restent = libres.cardinality();
        int manquent = combien;
        for (int p = libres.nextSetBit(0); p >= 0; p = libres.nextSetBit(p + 1)) {
            if (hasard.nextInt(restent--) < manquent) {
                choisis.set(p);
                manquent--;
            }
        }
    }

    private void tracer(int reflets, Modele modele, Echantillonnage visite) {
        Lancer lancer = prepare.avec(modele);
        lancer.TracerPixels(visite, this, reflets, fils);
        rayons += lancer.getCompteurs().rayons();
    }

    /** Visite les pixels tirés d'un pavé. */
    private int parcourir(Pave pave, IntConsumer visite) {
        for (int j = pave.j0; j < pave.j1; j++) {
            int k = Arrays.binarySearch(rangs, j * largeur + pave.i0);
            for (k = k < 0 ? -1 - k : k; k < rangs.length && rangs[k] < j * largeur + pave.i1; k++) {
                visite.accept(k);
            }
        }
        return 0;
    }

    /** Trouve les deux références d'un pixel ; elles ont neuf fois plus de rayons là où peu ne suffisent pas. */
    private void juger(int k, int cote, SplittableRandom hasard, Vue vue) {
        // deux moyennes ne servent qu'à le savoir : garder celles qui se ressemblent serait un biais
        boolean peu = !bords[k] && ecart(limites(moyenne(k, cote, hasard, vue)), limites(moyenne(k, cote, hasard, vue)))
                <= SURES;
        double[] une = moyenne(k, peu ? cote : 3 * cote, hasard, vue);
        double[] autre = moyenne(k, peu ? cote : 3 * cote, hasard, vue);
        for (int c = 0; c < 3; c++) {
            if (une[c] + autre[c] >= 2 * 255) {
                // limiter chacune, quand les deux ensemble saturent l'écran, serait un biais aussi
                une[c] = 255;
                autre[c] = 255;
            }
        }
        a[k] = limites(une);
        b[k] = limites(autre);
    }

    /** La moyenne d'un rayon au hasard par sous-pixel, en niveaux, non limitée. */
    private double[] moyenne(int k, int cote, SplittableRandom hasard, Vue vue) {
        Couleur somme = new Couleur();
        for (int s = 0; s < cote * cote; s++) {
            somme = somme.add(vue.couleur(rangs[k] % largeur + (s % cote + hasard.nextDouble()) / cote,
                    rangs[k] / largeur + (s / cote + hasard.nextDouble()) / cote));
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
        int k = Arrays.binarySearch(rangs, ye * largeur + xe);
        if (k >= 0) {
            x[k] = vue(couleur);
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
        tracer(reglages.getProfondeur(), modele, (pave, voulus, vue, toile) -> parcourir(pave, k -> {
            int i = rangs[k] % largeur;
            int j = rangs[k] / largeur;
            choisi.tracer(pave, new Pave(i, j, i + 1, j + 1), vue, toile);
        }));
        return mesurer();
    }

    /** L'erreur des couleurs retenues. */
    public Mesure mesurer() {
        double[] carres = IntStream.range(0, rangs.length).mapToDouble(k -> IntStream.range(0, 3)
                .mapToDouble(c -> (x[k][c] - a[k][c]) * (x[k][c] - b[k][c]) / 3).sum()).toArray();
        boolean rienVu = IntStream.range(0, rangs.length)
                .allMatch(k -> ecart(x[k], a[k]) <= JUSTE && ecart(x[k], b[k]) <= JUSTE);
        return new Mesure(tailles, bords, carres, rienVu);
    }
}
