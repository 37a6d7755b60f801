package lancer.inspection;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import java.util.function.DoubleFunction;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.contrat.Vue;
import lancer.image.ImageMemoire;
import lancer.texte.Nombre;

/** Vues d'une scène en fausses couleurs ({@code --vue}), chacune avec sa légende. Le ciel y est noir. */
public final class FaussesCouleurs {

    /** Les teintes des nombres de rayons, du noir au blanc, de plus en plus claires. */
    private static final int[] ECHELLE = {0x000000, 0x2C115F, 0x721F81, 0xB73779, 0xF1605D, 0xFEB078, 0xFFFFFF};

    /** Déplacements d'un rayon, relatifs, du plus grand au plus petit : 10 puissance moins ces nombres. */
    private static final int PREMIER = 6;
    private static final int DERNIER = 16;

    /** Nombre de rayons déplacés au hasard, pour chaque déplacement. */
    private static final int TIRAGES = 3;

    /** Places, de 0 à 1, des cinq teintes de la marge : plus de 10 décimales, puis 8, 5 et 2 au moins, et moins. */
    private static final double[] MARGES = {0, 2 / 6.0, 4 / 6.0, 5 / 6.0, 1};

    private static final Couleur NOIR = new Couleur();

    /** Le gris du contact le plus lointain, pour le distinguer du ciel. */
    private static final double GRIS_LOINTAIN = 0.1;

    /** Les trois nombres d'un pixel où rien n'est vu. */
    private static final Couleur CIEL = new Couleur(ImageMemoire.CIEL);

    private final Lancer lancer;
    private final Camera camera;
    private final int profondeur;
    private final int fils;

    /**
     * @param lancer celui de la scène préparée
     * @param profondeur nombre de réflexions permises
     */
    public FaussesCouleurs(Lancer lancer, int profondeur, int fils) {
        this.lancer = lancer;
        this.profondeur = profondeur;
        this.fils = fils;
        camera = lancer.getCamera();
    }

    /**
     * Dessine une vue.
     *
     * @param nom une de celles d'{@link lancer.commande.Option#VUE}
     * @param image reçoit les teintes et, si elle en garde, les nombres que montrent ces teintes
     */
    public void dessiner(String nom, ImageMemoire image) {
        String debut = "vue " + nom + " : ";
        if (nom.equals("rayons")) {
            image.sens = "rayons : %.0f";
            image.echelle = debut + compter(image);
        } else if (nom.equals("distance")) {
            image.sens = "d = %.5f";
            image.echelle = debut + mesurer(image);
        } else if (nom.equals("marge")) {
            image.sens = "marge : %.0f décimales (" + (DERNIER - PREMIER + 1) + " : rien ne change)";
            image.echelle = debut + "décimales que peut perdre le rayon avant que la couleur change d'un niveau, "
                    + "d'après " + TIRAGES + " rayons au hasard pour chacune ; noir : rien ne change, "
                    + "violet : 8 à 10, rouge : 5 à 7, orange : 2 à 4, blanc : l'arrondi suffit";
            peindre(image, nombrer(this::marger, image), m -> teinte(MARGES[4 - ((int) m + 1) / 3]));
        } else if (nom.equals("normales")) {
            image.sens = "N = %.4f %.4f %.4f";
            image.echelle = debut + "(N + 1)/2 : x en rouge, y en vert, z en bleu ; ciel noir";
            tracer(parPixel(FaussesCouleurs::normale), (N, i, j) ->
                    image.drawPixel(N.add(new Couleur(1)).div(2), N, i, j));
        } else {
            image.sens = "lampes : %.0f";
            int nombre = lancer.getScene().getLampes().size();
            image.echelle = debut + "lampes qui éclairent, noir : aucune, blanc : " + nombre + " sur " + nombre
                    + " ; ciel noir";
            tracer(parPixel(FaussesCouleurs::lampes), (n, i, j) ->
                    image.drawPixel(n.div(Math.max(1, nombre)), n, i, j));
        }
    }

    private void tracer(Echantillonnage echantillonnage, Toile toile) {
        lancer.Tracer(echantillonnage, toile, profondeur, fils);
    }

    /** Donne à chaque pixel les nombres du premier contact vu en son centre, ou {@link #CIEL}. */
    private Echantillonnage parPixel(BiFunction<Scene, PointContact, Couleur> nombres) {
        return (pave, voulus, vue, toile) -> {
            Scene scene = lancer.getScene().avec(lancer.getScene().getModele());
            for (int j = voulus.j0; j < voulus.j1; j++) {
                for (int i = voulus.i0; i < voulus.i1; i++) {
                    try {
                        Rayon rayon = camera.getRayon(i + 0.5, j + 0.5);
                        PointContact contact = scene.getClosestIntersection(rayon);
                        toile.drawPixel(contact == null ? CIEL : nombres.apply(scene, contact), i, j);
                    } catch (RuntimeException e) {
                        throw e instanceof PixelFautif ? e : new PixelFautif(i + 0.5, j + 0.5, e);
                    }
                }
            }
            vue.compteurs().ajouter(scene.getCompteurs());
            return 0;
        };
    }

    private static Couleur normale(Scene scene, PointContact contact) {
        Vecteur N = contact.objet.getNormale(contact);
        return new Couleur(N.x, N.y, N.z);
    }

    private static Couleur lampes(Scene scene, PointContact contact) {
        Vecteur N = contact.objet.getNormale(contact);
        int eclairent = 0;
        for (Lampe lampe : scene.getLampes()) {
            Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
            eclairent += N.dot(versLampe) > 0 && !scene.estCachee(lampe, contact, versLampe.normalized(),
                    versLampe.norme(), contact.objet) ? 1 : 0;
        }
        return new Couleur(eclairent);
    }

    /** Les nombres, un par pixel, que cet échantillonnage donne comme couleurs. */
    private double[] nombrer(Echantillonnage echantillonnage, ImageMemoire image) {
        double[] nombres = new double[image.largeur * image.hauteur];
        tracer(echantillonnage, (nombre, i, j) -> nombres[j * image.largeur + i] = nombre.r);
        return nombres;
    }

    private static void peindre(ImageMemoire image, double[] nombres, DoubleFunction<Couleur> teinte) {
        for (int k = 0; k < nombres.length; k++) {
            image.drawPixel(teinte.apply(nombres[k]), new Couleur(nombres[k]), k % image.largeur, k / image.largeur);
        }
    }

    /** Peint les distances du blanc au gris sombre, selon leur rang : un horizon n'éclaircit pas le reste. */
    private String mesurer(ImageMemoire image) {
        double[] distances = nombrer(parPixel((scene, contact) -> new Couleur(contact.distance)), image);
        double[] contacts = Arrays.stream(distances).filter(d -> d > 0).distinct().sorted().toArray();
        double dernier = Math.max(1, contacts.length - 1);
        peindre(image, distances, d -> d > 0
                ? new Couleur(1 - (1 - GRIS_LOINTAIN) * Arrays.binarySearch(contacts, d) / dernier) : NOIR);
        return contacts.length == 0 ? "aucun contact ; ciel noir" : "d = " + Nombre.arrondir(contacts[0])
                + " en blanc, " + Nombre.arrondir(contacts[contacts.length / 2]) + " au milieu, "
                + Nombre.arrondir(contacts[contacts.length - 1]) + " en gris sombre ; ciel noir";
    }

    /** Peint les nombres de rayons selon leur logarithme, de 1 au plus grand de cette image. */
    private String compter(ImageMemoire image) {
        double[] rayons = nombrer(this::compter, image);
        double max = Arrays.stream(rayons).max().getAsDouble();
        peindre(image, rayons, n -> max > 1 ? teinte(Math.log(n) / Math.log(max)) : NOIR);
        return String.format("noir : 1 rayon, rose : %.0f, blanc : %.0f", Math.sqrt(max), max);
    }

    /** Compte les rayons de toutes sortes de chaque pixel d'un pavé, dessiné selon l'échantillonnage de la scène. */
    private int compter(Pave pave, Pave voulus, Vue vue, Toile toile) {
        int large = pave.i1 - pave.i0;
        long[] rayons = new long[large * (pave.j1 - pave.j0)];
        Vue comptee = (xe, ye) -> {
            long avant = vue.compteurs().rayons();
            Couleur couleur = vue.couleur(xe, ye);
            rayons[((int) ye - pave.j0) * large + (int) xe - pave.i0] += vue.compteurs().rayons() - avant;
            return couleur;
        };
        Echantillonnage choisi = lancer.getScene().getModele().getEchantillonnage();
        int raffines = choisi.tracer(pave, voulus, comptee, (c, i, j) -> { });
        for (int k = 0; k < rayons.length; k++) {
            toile.drawPixel(new Couleur(rayons[k]), pave.i0 + k % large, pave.j0 + k / large);
        }
        return raffines;
    }

    /** Donne à chaque pixel d'un pavé sa {@link #marge}. */
    private int marger(Pave pave, Pave voulus, Vue vue, Toile toile) {
        for (int j = voulus.j0; j < voulus.j1; j++) {
            for (int i = voulus.i0; i < voulus.i1; i++) {
                toile.drawPixel(new Couleur(marge(i, j, vue)), i, j);
            }
        }
        return 0;
    }

    /** Le nombre de décimales que peut perdre la direction du rayon du centre de ce pixel, de 0 à 11. */
    private int marge(int i, int j, Vue vue) {
        SplittableRandom hasard = new SplittableRandom((long) j * camera.getLargeur() + i);
        Couleur dessinee = vue.couleur(i + 0.5, j + 0.5);
        // le rayon passe par l'œil : le tourner, c'est déplacer son point de l'écran
        double tour = new Vecteur(camera.getOeil(), camera.getEcran(i + 0.5, j + 0.5)).norme()
                * camera.getLargeur() / Constantes.ECHELLE;
        int dernier = PREMIER - 1;
        // deux décimales de suite : le hasard redonne parfois la même couleur
        for (int k = PREMIER; k <= Math.min(DERNIER, dernier + 2); k++) {
            dernier = change(dessinee, i + 0.5, j + 0.5, tour * Math.pow(10, -k), hasard, vue) ? k : dernier;
        }
        return DERNIER - dernier;
    }

    /** Dit si la couleur change de plus d'un niveau en l'un de quelques points à {@code pixels} de (xe, ye). */
    private static boolean change(Couleur dessinee, double xe, double ye, double pixels, SplittableRandom hasard,
            Vue vue) {
        boolean change = false;
        for (int k = 0; k < TIRAGES && !change; k++) {
            double angle = 2 * Math.PI * hasard.nextDouble();
            Couleur couleur = vue.couleur(xe + pixels * Math.cos(angle), ye + pixels * Math.sin(angle));
            change = ecart(dessinee.r, couleur.r) > 1 || ecart(dessinee.v, couleur.v) > 1
                    || ecart(dessinee.b, couleur.b) > 1;
        }
        return change;
    }

    /** L'écart de deux composantes limitées à [0, 1], en niveaux. */
    private static double ecart(double a, double b) {
        return 255 * Math.abs(Math.max(0, Math.min(1, a)) - Math.max(0, Math.min(1, b)));
    }

    /** La teinte de cette part de l'échelle, de 0 à 1. */
    private static Couleur teinte(double part) {
        double place = part * (ECHELLE.length - 1);
        int k = Math.min(ECHELLE.length - 2, (int) place);
        return couleur(ECHELLE[k]).mul(k + 1 - place).add(couleur(ECHELLE[k + 1]).mul(place - k));
    }

    private static Couleur couleur(int code) {
        return new Couleur(code >> 16 & 255, code >> 8 & 255, code & 255).div(255);
    }
}
