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

    /** Nombre d'objets, puis produit des pixels, des objets et des rayons par contact, d'une petite image. */
    private static final int QUARANTE = 40;
    private static final long VITE_FAIT = 1 << 20;

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
     * La même scène, avec sa recherche : la sienne s'il y a peu d'objets, ou si l'image est si petite que ses boucles
     * finissent avant la construction d'une autre. L'image est la même.
     *
     * @throws java.util.concurrent.CancellationException si ce fil est interrompu
     */
    public static Scene preparer(Scene scene, Camera camera) {
        long nombre = scene.getObjets().size();
        long questions = (long) camera.getLargeur() * camera.getHauteur() * (1 + scene.getLampes().size());
        boolean peu = nombre <= PEU || nombre <= QUARANTE && questions * nombre <= VITE_FAIT;
        return peu ? scene : structurer(scene, camera);
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
