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

    final Scene scene;
    final Camera camera;
    final long pixels;

    private Preparation(Scene scene, Camera camera) {
        this.scene = scene;
        this.camera = camera;
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
        return new Preparation(scene, camera).construire(suivi);
    }

    private Recherche construire(DoubleConsumer suivi) {
        Enveloppes enveloppes = new Enveloppes(scene.getObjets());
        if (enveloppes.objets.length <= PEU) {
            return new Masques(this, enveloppes);
        }
        List<Lampe> lampes = scene.getLampes();
        Carte[] cartes = new Carte[lampes.size()];
        Arbre arbre = new Arbre(enveloppes);
        int n = enveloppes.bornes.length;
        long places = Math.max(PLACES_TOUJOURS, (long) n * PLACES_PAR_OBJET) / (1 + cartes.length);
        long cases = Math.min(Math.max(CASES_TOUJOURS, (long) n * CASES_PAR_OBJET) / (1 + cartes.length),
                (long) n * CASES_PAR_OBJET);
        boolean utiles = n <= OBJETS_PAR_PIXEL * pixels && cases >= n / 16;
        for (int l = 0; utiles && l < cartes.length; l++) {
            Point p = lampes.get(l).getPosition();
            if (Enveloppes.plusGrande(p.x, p.y, p.z) < Enveloppes.LONGUEUR_MAX) {
                cartes[l] = Carte.de(PointDeVue.deLaLampe(p, enveloppes, (int) cases), enveloppes, (int) places);
            }
        }
        PointDeVue oeil = utiles ? PointDeVue.deLOeil(camera, (int) Math.min(cases, pixels)) : null;
        return new Foule(this, enveloppes, arbre, oeil == null ? null : Carte.de(oeil, enveloppes, (int) places), cartes);
    }

    /** La recherche d'un fil pour les mêmes objets, qui ont bougé. */
    Recherche recommencer(Compteurs compteurs) {
        return construire(part -> { }).pourUnFil(compteurs);
    }
}
