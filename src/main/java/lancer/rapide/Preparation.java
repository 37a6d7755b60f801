package lancer.rapide;

import java.util.List;
import java.util.function.DoubleConsumer;
import lancer.Camera;
import lancer.Lampe;
import lancer.Point;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/** Choix et construction de la recherche, selon la scène et l'image. */
public final class Preparation {

    /** Nombre d'objets jusqu'auquel demander chacun est plus rapide que toute structure. */
    private static final int DEUX = 2;

    /**
     * Plus grand produit des pixels, des objets et des rayons par contact d'une petite scène. Les boucles du cours y
     * finissent avant la construction d'une structure.
     */
    private static final long VITE_FAIT = 1 << 20;

    /** Nombre d'objets jusqu'auquel les structures sont des masques. */
    static final int PEU = 40;

    /** Nombre d'objets par pixel au-delà duquel il n'y a pas de carte. */
    private static final int OBJETS_PAR_PIXEL = 8;

    /** Nombre de places et de cases de toutes les cartes, par objet, et nombres toujours permis. */
    private static final int PLACES_PAR_OBJET = 32;
    private static final int PLACES_TOUJOURS = 1 << 22;
    private static final int CASES_PAR_OBJET = 8;
    private static final int CASES_TOUJOURS = 1 << 18;
    private static final int CASES_MAX = 1 << 19;

    /** Parts approchées de la préparation faites après la copie des enveloppes, puis après l'arbre. */
    private static final double PART_ENVELOPPES = 0.1;
    private static final double PART_ARBRE = 0.5;

    final Scene scene;
    final Camera camera;
    final long pixels;
    private final DoubleConsumer suivi;

    Preparation(Scene scene, Camera camera, DoubleConsumer suivi) {
        this.scene = scene;
        this.camera = camera;
        this.suivi = suivi;
        pixels = (long) camera.getLargeur() * camera.getHauteur();
    }

    /**
     * Choisit la recherche de cette scène pour une image.
     *
     * @param simple vrai pour proposer tous les objets
     * @return le regard sur ce que cette recherche pourrait cacher ; voir {@link Regard#cachait}
     */
    public static Regard choisir(Scene scene, Camera camera, boolean simple, DoubleConsumer suivi) {
        scene.getModele().setRecherche(simple || !estUtile(scene, camera) ? null : pour(scene, camera, suivi));
        return new Regard(scene, camera);
    }

    /** Dit si les structures, construction comprise, sont plus rapides pour cette image que de demander tous les objets. */
    static boolean estUtile(Scene scene, Camera camera) {
        int objets = scene.getObjets().size();
        long pixels = (long) camera.getLargeur() * camera.getHauteur();
        return objets > PEU || objets > DEUX && pixels * objets * (1 + scene.getLampes().size()) > VITE_FAIT;
    }

    /**
     * La recherche de cette scène vue de cette caméra.
     *
     * @param suivi reçoit la part faite, de 0 à 1, après chaque étape
     * @return une recherche qui donne la même image et les mêmes nombres de rayons que si tous les objets sont demandés
     * @throws java.util.concurrent.CancellationException si le fil appelant est interrompu
     */
    public static Recherche pour(Scene scene, Camera camera, DoubleConsumer suivi) {
        return new Preparation(scene, camera, suivi).construire();
    }

    private Recherche construire() {
        int objets = scene.getObjets().size();
        return objets <= PEU ? masques() : foule(objets <= OBJETS_PAR_PIXEL * pixels);
    }

    /** La recherche d'une petite scène. */
    Recherche masques() {
        return new Masques(this, new Enveloppes(scene.getObjets()));
    }

    /** La recherche d'une foule. @param avecCartes faux pour l'arbre seul */
    Recherche foule(boolean avecCartes) {
        Enveloppes enveloppes = new Enveloppes(scene.getObjets());
        List<Lampe> lampes = scene.getLampes();
        Carte[] cartes = new Carte[lampes.size()];
        suivi.accept(PART_ENVELOPPES);
        Arbre arbre = new Arbre(enveloppes);
        long n = enveloppes.bornes.length;
        int places = (int) Math.min(Math.max(PLACES_TOUJOURS, n * PLACES_PAR_OBJET) / (1 + cartes.length), Integer.MAX_VALUE / 4);
        int cases = (int) Math.min(Math.min(Math.max(CASES_TOUJOURS, n * CASES_PAR_OBJET) / (1 + cartes.length),
                n * CASES_PAR_OBJET), CASES_MAX);
        boolean utiles = avecCartes && cases > n / 16;
        for (int l = 0; l < cartes.length; l++) {
            suivi.accept(PART_ARBRE + (1 - PART_ARBRE) * l / (1 + cartes.length));
            Point p = lampes.get(l).getPosition();
            if (utiles && Enveloppes.plusGrande(p.x, p.y, p.z) < Enveloppes.LONGUEUR_MAX) {
                cartes[l] = Carte.de(PointDeVue.deLaLampe(p, enveloppes, cases), enveloppes, places);
            }
        }
        PointDeVue oeil = utiles ? PointDeVue.deLOeil(camera, (int) Math.min(cases, pixels)) : null;
        return new Foule(this, enveloppes, arbre, oeil == null ? null : Carte.de(oeil, enveloppes, places), cartes);
    }

    /** La recherche d'un fil pour les mêmes objets, qui ont bougé. */
    Recherche recommencer(Compteurs compteurs) {
        return new Preparation(scene, camera, part -> { }).construire().pourUnFil(compteurs);
    }
}
