package lancer.inspection;

import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.function.BiFunction;
import lancer.Camera;
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
import lancer.image.Comparaison;
import lancer.image.ImageMemoire;
import lancer.texte.Nombre;

/** Vues d'une scène en fausses couleurs ({@code --vue}), chacune avec sa légende. Le ciel y est noir. */
public final class FaussesCouleurs {

    /** Racine du nombre de rayons par pixel de la référence. */
    private static final int COTE = 8;

    /** Logarithme en base 2 du nombre de rayons peint en blanc ; un rayon est peint en noir. */
    private static final double DOUBLEMENTS = 12;

    /** Les teintes des nombres de rayons, du noir au blanc, de plus en plus claires. */
    private static final int[] ECHELLE = {0x000000, 0x2C115F, 0x721F81, 0xB73779, 0xF1605D, 0xFEB078, 0xFFFFFF};

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
     * @param nom un de ceux d'{@link lancer.commande.Options#VUES}
     * @param image reçoit les teintes et, si elle en garde, les nombres que montrent ces teintes
     * @param reference image à laquelle {@code difference} compare ; {@code null} pour 64 rayons par pixel
     */
    public void dessiner(String nom, ImageMemoire image, ImageMemoire reference) {
        if (nom.equals("difference")) {
            ImageMemoire attendue = reference;
            if (attendue == null) {
                attendue = new ImageMemoire(image.largeur, image.hauteur, true);
                tracer(FaussesCouleurs::enGrille, attendue);
            }
            ImageMemoire dessinee = new ImageMemoire(image.largeur, image.hauteur, attendue.lineaire != null);
            tracer(lancer.getScene().getModele().getEchantillonnage(), dessinee);
            Comparaison comparaison = new Comparaison(dessinee, attendue, 0, 0);
            // jusqu'ici, les nombres de l'image sont ceux du brouillon
            image.sens = "écart : %.2f niveaux";
            comparaison.peindreLesEcarts(image);
            image.echelle = "écart, au plus " + Nombre.arrondir(comparaison.getPire())
                    + " (blanc : 32 niveaux sur 255), avec "
                    + (reference == null ? "une image de " + COTE * COTE + " rayons par pixel"
                    : "l'image d'avant");
        } else if (nom.equals("rayons")) {
            image.sens = "rayons : %.0f";
            image.echelle = "noir : 1 rayon, violet : 16, rose : 64, orange : 256, blanc : 4096 ou plus";
            tracer(this::compter, (rayons, i, j) -> image.drawPixel(teinte(rayons.r), rayons, i, j));
        } else if (nom.equals("distance")) {
            image.sens = "d = %.5f";
            dessinerLesDistances(image);
        } else if (nom.equals("normales")) {
            image.sens = "N = %.4f %.4f %.4f";
            image.echelle = "(N + 1)/2 : x en rouge, y en vert, z en bleu ; ciel noir";
            tracer(parPixel(FaussesCouleurs::normale), (N, i, j) ->
                    image.drawPixel(N.add(new Couleur(1)).div(2), N, i, j));
        } else {
            image.sens = "lampes : %.0f";
            int nombre = lancer.getScene().getLampes().size();
            image.echelle = "lampes qui éclairent, noir : aucune, blanc : " + nombre + " sur " + nombre
                    + " ; ciel noir";
            tracer(parPixel(FaussesCouleurs::lampes), (n, i, j) ->
                    image.drawPixel(n.div(Math.max(1, nombre)), n, i, j));
        }
        image.echelle = "vue " + nom + " : " + image.echelle;
    }

    private void tracer(Echantillonnage echantillonnage, Toile toile) {
        lancer.TracerPixels(echantillonnage, toile, profondeur, fils);
    }

    /** Donne à chaque pixel les nombres du premier contact vu en son centre, ou {@link #CIEL}. */
    private Echantillonnage parPixel(BiFunction<Scene, PointContact, Couleur> nombres) {
        return (pave, voulus, vue, toile) -> {
            Scene scene = lancer.getScene().avec(lancer.getScene().getModele());
            for (int j = voulus.j0; j < voulus.j1; j++) {
                for (int i = voulus.i0; i < voulus.i1; i++) {
                    try {
                        scene.getCompteurs().primaires++;
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

    /** Peint les distances en gris, selon leur logarithme : blanc le plus proche contact, sombre le plus lointain. */
    private void dessinerLesDistances(ImageMemoire image) {
        double[] distances = new double[image.largeur * image.hauteur];
        tracer(parPixel((scene, contact) -> new Couleur(contact.distance)),
                (distance, i, j) -> distances[j * image.largeur + i] = distance.r);
        DoubleSummaryStatistics contacts = Arrays.stream(distances).filter(d -> d > 0).summaryStatistics();
        double min = contacts.getMin();
        double max = contacts.getMax();
        image.echelle = contacts.getCount() == 0 ? "aucun contact ; ciel noir"
                : "d = " + Nombre.arrondir(min) + " en blanc, " + Nombre.arrondir(max) + " en gris sombre ; ciel noir";
        double etendue = max > min ? Math.log(max) - Math.log(min) : 1;
        for (int k = 0; k < distances.length; k++) {
            double part = (Math.log(distances[k]) - Math.log(min)) / etendue;
            image.drawPixel(distances[k] > 0 ? new Couleur(1 - (1 - GRIS_LOINTAIN) * part) : NOIR,
                    new Couleur(distances[k]), k % image.largeur, k / image.largeur);
        }
    }

    /** Compte les rayons de toutes sortes de chaque pixel d'un pavé, dessiné selon l'échantillonnage de la scène. */
    private int compter(Pave pave, Pave voulus, Vue vue, Toile toile) {
        long[] rayons = new long[(pave.i1 - pave.i0) * (pave.j1 - pave.j0)];
        Vue comptee = (xe, ye) -> {
            long avant = vue.compteurs().rayons();
            Couleur couleur = vue.couleur(xe, ye);
            rayons[((int) ye - pave.j0) * (pave.i1 - pave.i0) + (int) xe - pave.i0] += vue.compteurs().rayons() - avant;
            return couleur;
        };
        Echantillonnage choisi = lancer.getScene().getModele().getEchantillonnage();
        int raffines = choisi == null ? auCentre(voulus, comptee)
                : choisi.pour(lancer.getScene().getObjets(), camera).tracer(pave, voulus, comptee, (c, i, j) -> { });
        for (int k = 0; k < rayons.length; k++) {
            toile.drawPixel(new Couleur(rayons[k]), pave.i0 + k % (pave.i1 - pave.i0),
                    pave.j0 + k / (pave.i1 - pave.i0));
        }
        return raffines;
    }

    private static int auCentre(Pave voulus, Vue vue) {
        for (int j = voulus.j0; j < voulus.j1; j++) {
            for (int i = voulus.i0; i < voulus.i1; i++) {
                vue.couleur(i + 0.5, j + 0.5);
            }
        }
        return 0;
    }

    /** La couleur de ce nombre de rayons, sur une échelle logarithmique. */
    private static Couleur teinte(double rayons) {
        double place = Math.max(0, Math.min(1, Math.log(rayons) / Math.log(2) / DOUBLEMENTS)) * (ECHELLE.length - 1);
        int k = Math.min(ECHELLE.length - 2, (int) place);
        return couleur(ECHELLE[k]).mul(k + 1 - place).add(couleur(ECHELLE[k + 1]).mul(place - k));
    }

    private static Couleur couleur(int code) {
        return new Couleur(code >> 16 & 255, code >> 8 & 255, code & 255).div(255);
    }

    /** La référence : la moyenne d'une grille de rayons dans chaque pixel. */
    private static int enGrille(Pave pave, Pave voulus, Vue vue, Toile toile) {
        for (int j = voulus.j0; j < voulus.j1; j++) {
            for (int i = voulus.i0; i < voulus.i1; i++) {
                Couleur somme = new Couleur();
                for (int k = 0; k < COTE * COTE; k++) {
                    somme = somme.add(vue.couleur(i + (k % COTE + 0.5) / COTE, j + (k / COTE + 0.5) / COTE));
                }
                toile.drawPixel(somme.div(COTE * COTE), i, j);
            }
        }
        return 0;
    }
}
