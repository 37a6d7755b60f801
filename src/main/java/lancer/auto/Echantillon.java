package lancer.auto;

import java.util.Arrays;
import java.util.IntSummaryStatistics;
import java.util.SplittableRandom;
import java.util.function.IntFunction;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import lancer.Couleur;
import lancer.Lancer;
import lancer.commande.Reglages;
import lancer.contrat.Modele;
import lancer.contrat.Pave;
import lancer.contrat.Releve;
import lancer.contrat.Vue;

/**
 * Des pixels d'une image, et deux références de chacun : la moyenne de rayons au hasard, sans limite de réflexions. Les
 * références a et b sont indépendantes : (x − a)(x − b) estime le carré de l'erreur d'une couleur x.
 */
public final class Echantillon {

    /** Part des premiers rayons d'une image que demandent les références, et bornes du nombre de pixels. */
    private static final double PART = 0.1;
    private static final int MOINS = 200;
    private static final int PLUS = 1400;
    /** Seuil d'un rayon sans limite : au-dessous de ce produit des Ks, un reflet est invisible. */
    private static final double SANS_LIMITE = 1e-9;

    private final Lancer prepare;
    private final int fils;
    private final int largeur;
    /** Le rang de chaque pixel tiré, le nombre de pixels qu'il représente, et ses références. */
    private final int[] rangs;
    private final double[] poids;
    private final Couleur[] a;
    private final Couleur[] b;
    /** Nombre de rayons de toutes sortes lancés pour cet échantillon. */
    long rayons;

    /**
     * Tire des pixels : la moitié au hasard, l'autre d'autant plus souvent que leurs voisins diffèrent.
     *
     * @param prepare la scène, prête à être dessinée
     * @param dessinee couleur de chaque pixel d'une image, par son rang, ligne par ligne ; un seul gris pour un essai
     * @param voulue erreur voulue, en niveaux, dont dépend le nombre de rayons d'une référence
     * @param primaires nombre de premiers rayons de l'image, dont dépend le nombre de pixels
     * @param paves nombre de pavés où tirer, régulièrement espacés : dessiner un pixel coûte parfois celui d'un pavé
     */
    public Echantillon(Lancer prepare, int fils, IntFunction<Couleur> dessinee, double voulue, long primaires,
            int paves, SplittableRandom hasard) {
        this.prepare = prepare;
        this.fils = fils;
        largeur = prepare.getCamera().getLargeur();
        int cote = (int) Math.max(2, Math.min(8, Math.rint(5 / Math.cbrt(voulue))));
        double nombre = Math.max(MOINS, Math.min(PLUS, PART * primaires / (2 * cote * cote)));
        float[] contrastes = trouverLesContrastes(dessinee);
        int taille = contrastes.length;
        double somme = IntStream.range(0, taille).mapToDouble(p -> contrastes[p]).sum();
        int pas = Math.max(1, (int) Math.rint((double) taille / (Pave.COTE * Pave.COTE) / paves));
        IntToDoubleFunction chance = p -> Math.min(1.0 / pas, nombre / 2 * (1.0 / taille + contrastes[p] / somme));
        int premier = hasard.nextInt(pas);
        rangs = IntStream.range(0, taille).filter(p -> pave(p) % pas == premier
                && hasard.nextDouble() < pas * chance.applyAsDouble(p)).toArray();
        poids = Arrays.stream(rangs).mapToDouble(p -> 1 / chance.applyAsDouble(p)).toArray();
        a = dessinerAuHasard(cote, hasard.nextLong());
        b = dessinerAuHasard(cote, hasard.nextLong());
    }

    /** Le rang, ligne par ligne, du pavé d'un pixel. */
    private int pave(int p) {
        return p / largeur / Pave.COTE * ((largeur - 1) / Pave.COTE + 1) + p % largeur / Pave.COTE;
    }

    /** L'écart de chaque pixel à ses voisins ; jamais nul : là où rien ne diffère, toutes les chances sont égales. */
    private float[] trouverLesContrastes(IntFunction<Couleur> dessinee) {
        float[] contrastes = new float[largeur * prepare.getCamera().getHauteur()];
        Arrays.fill(contrastes, Float.MIN_NORMAL);
        for (int p = 0; p < contrastes.length - largeur; p++) {
            // les voisins qui précèdent ont déjà été comparés
            for (int q : new int[] {p + 1, p + largeur}) {
                Couleur difference = dessinee.apply(p).sub(dessinee.apply(q));
                float ecart = (float) Math.min(1, Math.max(difference.max(), difference.mul(-1).max()));
                contrastes[p] = Math.max(contrastes[p], ecart);
                contrastes[q] = Math.max(contrastes[q], ecart);
            }
        }
        return contrastes;
    }

    /** La moyenne d'un rayon au hasard dans chaque sous-pixel des pixels tirés. */
    private Couleur[] dessinerAuHasard(int cote, long graine) {
        return dessiner(prepare.getScene().getModele().avec((pave, voulus, vue, toile) -> {
            for (int j = voulus.j0; j < voulus.j1; j++) {
                for (int i = voulus.i0; i < voulus.i1; i++) {
                    if (place(i, j) >= 0) {
                        toile.drawPixel(auHasard(vue, i, j, cote, graine), i, j);
                    }
                }
            }
            return Releve.RIEN;
        }, SANS_LIMITE), Echelle.PROFONDEUR);
    }

    private Couleur auHasard(Vue vue, int i, int j, int cote, long graine) {
        SplittableRandom hasard = new SplittableRandom(graine + j * largeur + i);
        Couleur somme = new Couleur();
        for (int s = 0; s < cote * cote; s++) {
            somme = somme.add(vue.couleur(i + (s % cote + hasard.nextDouble()) / cote,
                    j + (s / cote + hasard.nextDouble()) / cote));
        }
        return somme.div(cote * cote);
    }

    /** Le rang d'un pixel parmi les pixels tirés ; négatif s'il n'en est pas. */
    private int place(int i, int j) {
        return Arrays.binarySearch(rangs, j * largeur + i);
    }

    /** Dessine les pixels tirés, ceux d'un pavé ensemble : ils partagent des rayons. */
    private Couleur[] dessiner(Modele modele, int reflets) {
        Couleur[] couleurs = new Couleur[rangs.length];
        Lancer lancer = prepare.avec(modele);
        lancer.getAtelier().dessiner((pave, voulus, vue, toile) -> {
            int[] siens = Arrays.stream(rangs).filter(p -> estDans(pave, p)).toArray();
            IntSummaryStatistics x = Arrays.stream(siens).map(p -> p % largeur).summaryStatistics();
            return siens.length == 0 ? Releve.RIEN : lancer.getEchantillonnage().tracer(pave, new Pave(x.getMin(),
                    siens[0] / largeur, x.getMax() + 1, siens[siens.length - 1] / largeur + 1), vue,
                    (couleur, i, j) -> {
                        int place = place(i, j);
                        if (place >= 0) {
                            couleurs[place] = couleur;
                        }
                    });
        }, lancer.getVues(reflets), (couleur, xe, ye) -> { }, fils);
        rayons += lancer.getAtelier().getCompteurs().rayons();
        return couleurs;
    }

    private boolean estDans(Pave pave, int p) {
        return p % largeur >= pave.i0 && p % largeur < pave.i1 && p / largeur >= pave.j0 && p / largeur < pave.j1;
    }

    /** Dessine ces seuls pixels avec ces réglages, et mesure leur erreur. */
    Mesure essayer(Reglages reglages) {
        return mesurer(dessiner(reglages.getModele(), reglages.getProfondeur()));
    }

    /** L'erreur d'une image. @param dessinee la couleur de chacun de ses pixels, par son rang */
    public Mesure mesurer(IntFunction<Couleur> dessinee) {
        return mesurer(Arrays.stream(rangs).mapToObj(dessinee).toArray(Couleur[]::new));
    }

    private Mesure mesurer(Couleur... x) {
        return new Mesure(poids, IntStream.range(0, x.length).mapToDouble(k -> (carre(x[k].r, a[k].r, b[k].r)
                + carre(x[k].v, a[k].v, b[k].v) + carre(x[k].b, a[k].b, b[k].b)) / 3).toArray());
    }

    /** Le carré de l'erreur d'une composante, en niveaux², estimé sans biais. */
    private static double carre(double x, double a, double b) {
        // limiter chaque référence, quand les deux ensemble saturent l'écran, serait un biais
        double moins = a + b >= 2 ? 1 : 0;
        return (niveau(x) - niveau(Math.max(moins, a))) * (niveau(x) - niveau(Math.max(moins, b)));
    }

    private static double niveau(double composante) {
        return 255 * Math.max(0, Math.min(1, composante));
    }
}
