package lancer.rapide;

import java.util.List;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/** La recherche d'une scène et d'une image, construite de nouveau si un objet a bougé quand un fil la demande. */
public final class Preparation {

    /** Nombre d'objets jusqu'auquel demander chacun est plus rapide que toute structure. */
    static final int PEU = 15;

    /** Nombre d'objets au-delà duquel les boucles ne dessinent jamais. */
    private static final int BEAUCOUP = 40;

    /**
     * Nombre de demandes, en plus de celles que recevraient {@link #PEU} objets, à partir duquel les boucles coûtent
     * plus que les structures, temps de compiler celles-ci compris : table {@code mesures/resultats/recherche.csv}, que
     * refait {@code make mesure-recherche}.
     */
    private static final long DEMANDES_EN_PLUS = 40_000_000;

    private final List<Objet3D> objets;
    private final List<Lampe> lampes;
    private final Camera camera;
    private Structures structures;

    private Preparation(Scene scene, Camera camera) {
        objets = scene.getObjets();
        lampes = scene.getLampes();
        this.camera = camera;
        structures = new Structures(objets, lampes, camera);
    }

    /**
     * La même scène, avec ce qui y cherche le mieux : ses boucles seules s'il y a peu d'objets, ou s'il y en a quelques
     * dizaines et peu de rayons à venir ; des structures sinon. L'image est la même.
     *
     * @param rayons nombre de rayons de l'écran à venir, à peu près
     * @throws java.util.concurrent.CancellationException si ce fil est interrompu
     */
    public static Scene preparer(Scene scene, Camera camera, long rayons) {
        int nombre = scene.getObjets().size();
        double enPlus = (double) rayons * (1 + scene.getLampes().size()) * (nombre - PEU);
        boolean boucles = nombre <= PEU || nombre <= BEAUCOUP && enPlus <= DEMANDES_EN_PLUS;
        return boucles ? scene : structurer(scene, camera);
    }

    /** La même scène, dont la recherche a des structures. */
    static Scene structurer(Scene scene, Camera camera) {
        return scene.avec(recherche(scene, camera));
    }

    static Recherche recherche(Scene scene, Camera camera) {
        return new Foule(new Preparation(scene, camera)::getStructures, new Compteurs());
    }

    private synchronized Structures getStructures() {
        if (!structures.enveloppes.sontEnPlace()) {
            structures = new Structures(objets, lampes, camera);
        }
        return structures;
    }
}
