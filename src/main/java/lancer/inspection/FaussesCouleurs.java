package lancer.inspection;

import java.util.Arrays;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Pave;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.contrat.Vue;
import lancer.fils.Fil;
import lancer.image.Comparaison;
import lancer.image.ImageMemoire;

/** Vues d'une scène en fausses couleurs ({@code --vue}). Le ciel y est noir. */
public final class FaussesCouleurs {

    /** Racine du nombre de rayons par pixel de la référence. */
    private static final int COTE = 8;

    /** Logarithme en base 2 du nombre de rayons peint en blanc ; un rayon est peint en noir. */
    private static final double DOUBLEMENTS = 12;

    /** Les teintes des nombres de rayons, du noir au blanc, de plus en plus claires. */
    private static final int[] ECHELLE = {0x000000, 0x2C115F, 0x721F81, 0xB73779, 0xF1605D, 0xFEB078, 0xFFFFFF};

    private static final Couleur NOIR = new Couleur();

    private final Lancer lancer;
    private final Camera camera;
    private final int profondeur;
    private final int fils;
    private final Consumer<Lancer> siCommence;
    private Lancer dernier;

    /**
     * @param lancer celui de la scène préparée
     * @param profondeur nombre de réflexions permises
     * @param siCommence reçoit chaque lancer au début de son dessin
     */
    public FaussesCouleurs(Lancer lancer, int profondeur, int fils, Consumer<Lancer> siCommence) {
        this.lancer = lancer;
        this.siCommence = siCommence;
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
     * @return le lancer qui a dessiné, avec ses compteurs
     */
    public Lancer dessiner(String nom, ImageMemoire image, ImageMemoire reference) {
        if (nom.equals("difference")) {
            image.sens = "écart : %.2f niveaux";
            ImageMemoire attendue = reference;
            if (attendue == null) {
                attendue = new ImageMemoire(image.largeur, image.hauteur, true);
                tracer(FaussesCouleurs::enGrille, attendue);
            }
            ImageMemoire dessinee = new ImageMemoire(image.largeur, image.hauteur, attendue.lineaire != null);
            tracer(lancer.getScene().getModele().getEchantillonnage(), dessinee);
            new Comparaison(dessinee, attendue, 0, 0).peindreLesEcarts(image);
        } else if (nom.equals("rayons")) {
            image.sens = "rayons : %.0f";
            tracer(this::compter, (rayons, i, j) -> image.drawPixel(teinte(rayons.r), rayons, i, j));
        } else if (nom.equals("distance")) {
            image.sens = "d = %.5f";
            dessinerLesDistances(image);
        } else if (nom.equals("normales")) {
            image.sens = "N = %.4f %.4f %.4f";
            tracer(parPixel(FaussesCouleurs::normale), (N, i, j) -> image.drawPixel(N.equals(NOIR) ? N
                    : N.add(new Couleur(1)).div(2), N, i, j));
        } else {
            image.sens = "lampes : %.0f";
            int nombre = Math.max(1, lancer.getScene().getLampes().size());
            tracer(parPixel(FaussesCouleurs::lampes), (n, i, j) -> image.drawPixel(n.div(nombre), n, i, j));
        }
        return dernier;
    }

    private void tracer(Echantillonnage echantillonnage, Toile toile) {
        Modele modele = lancer.getScene().getModele();
        dernier = new Lancer(lancer.getScene().avec(modele.avec(echantillonnage, modele.getSeuil())), camera);
        siCommence.accept(dernier);
        dernier.TracerPixels(toile, profondeur, fils);
    }

    /** Donne à chaque pixel les nombres du premier contact vu en son centre, ou trois zéros. */
    private Echantillonnage parPixel(BiFunction<Scene, PointContact, Couleur> nombres) {
        return (pave, voulus, vue, toile) -> {
            Scene scene = lancer.getScene().avec(lancer.getScene().getModele());
            for (int j = voulus.j0; j < voulus.j1; j++) {
                for (int i = voulus.i0; i < voulus.i1; i++) {
                    try {
                        Fil.commencer(i, j);
                        scene.getCompteurs().primaires++;
                        Rayon rayon = camera.getRayon(i + 0.5, j + 0.5);
                        PointContact contact = scene.getClosestIntersection(rayon);
                        toile.drawPixel(contact == null ? NOIR : nombres.apply(scene, contact), i, j);
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

    /** Peint 1 − d/d_max, où d_max est la plus grande distance d'un contact de l'image. */
    private void dessinerLesDistances(ImageMemoire image) {
        double[] distances = new double[image.largeur * image.hauteur];
        tracer(parPixel((scene, contact) -> new Couleur(contact.distance)),
                (distance, i, j) -> distances[j * image.largeur + i] = distance.r);
        double max = Arrays.stream(distances).max().orElse(0);
        for (int k = 0; k < distances.length; k++) {
            image.drawPixel(new Couleur(distances[k] == 0 ? 0 : 1 - distances[k] / max), new Couleur(distances[k]),
                    k % image.largeur, k / image.largeur);
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
