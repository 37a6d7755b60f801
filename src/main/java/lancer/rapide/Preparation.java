package lancer.rapide;

import java.util.List;
import java.util.function.DoubleConsumer;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/**
 * La recherche choisie pour une scène et une image : des {@link Masques}, ou une {@link Foule}. Elle est construite de
 * nouveau si un objet a bougé quand un fil la demande.
 */
public final class Preparation implements Recherche {

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

    /** Nombre de places et de cases de toutes les cartes, par objet, et nombres toujours permis ; cases d'une carte. */
    private static final int PLACES_PAR_OBJET = 32;
    private static final int PLACES_TOUJOURS = 1 << 22;
    private static final int CASES_PAR_OBJET = 8;
    private static final int CASES_TOUJOURS = 1 << 18;
    private static final int CASES_MAX = 1 << 19;

    /** Parts approchées de la préparation faites après la copie des enveloppes, puis après l'arbre. */
    private static final double PART_ENVELOPPES = 0.1;
    private static final double PART_ARBRE = 0.5;

    private final Scene scene;
    private final Camera camera;
    private final DoubleConsumer suivi;
    private Enveloppes enveloppes;
    private Recherche recherche;

    /** @param suivi reçoit la part faite, de 0 à 1, après chaque étape */
    Preparation(Scene scene, Camera camera, DoubleConsumer suivi) {
        this.scene = scene;
        this.camera = camera;
        this.suivi = suivi;
        construire();
    }

    /**
     * Choisit la recherche de cette scène pour une image.
     *
     * @param simple vrai pour proposer tous les objets
     * @return le regard sur ce que cette recherche pourrait cacher ; voir {@link Regard#cachait}
     * @throws java.util.concurrent.CancellationException si le fil appelant est interrompu
     */
    public static Regard choisir(Scene scene, Camera camera, boolean simple, DoubleConsumer suivi) {
        Preparation preparation = simple || !estUtile(scene, camera) ? null : new Preparation(scene, camera, suivi);
        scene.getModele().setRecherche(preparation);
        return new Regard(scene, camera, () -> preparation == null || preparation.estEnPlace());
    }

    /** Dit si les structures, construction comprise, sont plus rapides pour cette image que de demander tous les objets. */
    static boolean estUtile(Scene scene, Camera camera) {
        int objets = scene.getObjets().size();
        long pixels = (long) camera.getLargeur() * camera.getHauteur();
        return objets > PEU || objets > DEUX && pixels * objets * (1 + scene.getLampes().size()) > VITE_FAIT;
    }

    /** La recherche de cette scène vue de cette caméra. Elle donne la même image que si tous les objets sont proposés. */
    public static Recherche pour(Scene scene, Camera camera, DoubleConsumer suivi) {
        return new Preparation(scene, camera, suivi);
    }

    private void construire() {
        enveloppes = new Enveloppes(scene.getObjets());
        suivi.accept(PART_ENVELOPPES);
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
        List<Lampe> lampes = scene.getLampes();
        Carte[] cartes = new Carte[lampes.size()];
        Arbre arbre = new Arbre(enveloppes);
        long n = enveloppes.bornes.length;
        int places = (int) (Math.max(PLACES_TOUJOURS, n * PLACES_PAR_OBJET) / (1 + cartes.length));
        long permises = Math.max(CASES_TOUJOURS, n * CASES_PAR_OBJET) / (1 + cartes.length);
        int cases = (int) Math.min(Math.min(permises, n * CASES_PAR_OBJET), CASES_MAX);
        boolean utiles = avecCartes && cases > n / 16;
        for (int l = 0; l < cartes.length; l++) {
            suivi.accept(PART_ARBRE + (1 - PART_ARBRE) * l / (1 + cartes.length));
            Point p = lampes.get(l).getPosition();
            if (utiles && Enveloppes.plusGrande(p.x, p.y, p.z) < Enveloppes.LONGUEUR_MAX) {
                cartes[l] = Carte.de(PointDeVue.deLaLampe(p, enveloppes, cases), enveloppes, places);
            }
        }
        PointDeVue oeil = utiles ? PointDeVue.deLOeil(camera, cases) : null;
        return new Foule(enveloppes, arbre, oeil == null ? null : Carte.de(oeil, enveloppes, places),
                lampes.toArray(new Lampe[0]), cartes, new Compteurs());
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

    @Override
    public void commencer(Point P, Vecteur V, Objet3D depart) {
        recherche.commencer(P, V, depart);
    }

    @Override
    public void commencerOmbre(Lampe lampe, Point P, Vecteur V, double distance, Objet3D eclaire) {
        recherche.commencerOmbre(lampe, P, V, distance, eclaire);
    }

    @Override
    public int suivant(double auPlus) {
        return recherche.suivant(auPlus);
    }

    @Override
    public String toString() {
        return recherche.toString();
    }
}
