package lancer.rapide;

import java.util.List;
import lancer.Camera;
import lancer.Lampe;
import lancer.Point;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.contrat.TousLesObjets;

/**
 * La recherche choisie pour une scène et une image : des {@link Masques}, ou une {@link Foule}. Elle est construite de
 * nouveau si un objet a bougé quand un fil la demande. À qui n'est pas un fil, elle propose tous les objets.
 */
public final class Preparation extends TousLesObjets {

    /** Nombre d'objets jusqu'auquel demander chacun est plus rapide que toute structure. */
    private static final int DEUX = 2;

    /**
     * Plus grand produit des pixels, des objets et des rayons par contact d'une petite scène. Les boucles du cours y
     * finissent avant la construction d'une structure.
     */
    private static final long VITE_FAIT = 1 << 20;

    /** Nombre d'objets jusqu'auquel les structures sont des masques. */
    private static final int PEU = 40;

    /** Nombre d'objets par pixel au-delà duquel il n'y a pas de carte. */
    private static final int OBJETS_PAR_PIXEL = 8;

    /** Nombre de cases d'une carte par objet, nombre de cases de toutes les cartes, et de places par case. */
    private static final int CASES_PAR_OBJET = 2;
    private static final int CASES_TOUJOURS = 1 << 18;
    private static final int PLACES_PAR_CASE = 8;

    private final Scene scene;
    private final Camera camera;
    private Enveloppes enveloppes;
    private Recherche recherche;

    /** La recherche de cette scène vue de cette caméra. L'image est la même que si tous les objets sont proposés. */
    public Preparation(Scene scene, Camera camera) {
        super(scene.getObjets().size());
        this.scene = scene;
        this.camera = camera;
        construire();
    }

    /**
     * Choisit la recherche de cette scène pour une image.
     *
     * @param simple vrai pour proposer tous les objets
     * @throws java.util.concurrent.CancellationException si le fil appelant est interrompu
     */
    public static void choisir(Scene scene, Camera camera, boolean simple) {
        scene.getModele().setRecherche(simple || !estUtile(scene, camera) ? null : new Preparation(scene, camera));
    }

    /** Dit si les structures, construction comprise, sont plus rapides que de demander tous les objets. */
    static boolean estUtile(Scene scene, Camera camera) {
        int objets = scene.getObjets().size();
        long pixels = (long) camera.getLargeur() * camera.getHauteur();
        return objets > PEU || objets > DEUX && pixels * objets * (1 + scene.getLampes().size()) > VITE_FAIT;
    }

    private void construire() {
        enveloppes = new Enveloppes(scene.getObjets());
        int objets = enveloppes.objets.length;
        long pixels = (long) camera.getLargeur() * camera.getHauteur();
        recherche = objets <= PEU ? masques() : foule(objets <= OBJETS_PAR_PIXEL * pixels);
    }

    /** La recherche d'une petite scène. */
    Recherche masques() {
        return new Masques(enveloppes, scene.getLampes(), camera);
    }

    /** La recherche d'une foule. @param avecCartes faux pour l'arbre seul */
    Recherche foule(boolean avecCartes) {
        Arbre arbre = new Arbre(enveloppes);
        List<Lampe> lampes = scene.getLampes();
        Carte[] cartes = new Carte[lampes.size()];
        long n = enveloppes.bornes.length;
        long permises = Math.max(CASES_TOUJOURS, n * CASES_PAR_OBJET) / (1 + cartes.length);
        int cases = (int) Math.min(permises, n * CASES_PAR_OBJET);
        int places = PLACES_PAR_CASE * cases;
        boolean utiles = avecCartes && cases > n / 16;
        for (int l = 0; l < cartes.length && utiles; l++) {
            Point place = lampes.get(l).getPosition();
            cartes[l] = Carte.de(new PointDeVue(place, place, enveloppes, cases), enveloppes, places);
        }
        Carte oeil = !utiles ? null : Carte.de(new PointDeVue(camera.getOeil(), camera.getEcran(0, 0), enveloppes,
                cases), enveloppes, places);
        return new Foule(enveloppes, arbre, oeil, lampes.toArray(new Lampe[0]), cartes, new Compteurs());
    }

    /** Dit si tous les objets sont là où ils étaient à la dernière construction. */
    boolean estEnPlace() {
        return enveloppes.sontEnPlace();
    }

    @Override
    public synchronized Recherche pourUnFil(Compteurs compteurs) {
        if (!estEnPlace()) {
            construire();
        }
        return recherche.pourUnFil(compteurs);
    }
}
