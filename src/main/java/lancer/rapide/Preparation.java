package lancer.rapide;

import java.util.Arrays;
import java.util.List;
import lancer.Camera;
import lancer.Lampe;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;

/**
 * Le choix des structures : ce que la scène demande, et rien de plus. Une préparation vaut pour un dessin : la place des
 * objets, leurs matières et les lampes sont celles du moment où elle est faite.
 */
public final class Preparation {

    private final Spheres spheres;
    private final List<Lampe> lampes;
    private final Voisins suivants;
    private final Obstacles[] obstacles;

    private Preparation(Scene scene, Camera camera) {
        spheres = new Spheres(scene.getObjets());
        lampes = scene.getLampes();
        Boucle boucle = new Boucle(spheres);
        suivants = boucle;
        obstacles = new Obstacles[lampes.size()];
        Arrays.fill(obstacles, boucle);
    }

    /**
     * La recherche la plus rapide pour dessiner cette scène vue de cette caméra.
     *
     * @return une recherche de même image et mêmes comptes de rayons que {@link lancer.contrat.RechercheSimple}
     */
    public static Recherche pour(Scene scene, Camera camera) {
        return new RechercheRapide(new Preparation(scene, camera), new Compteurs());
    }

    Spheres getSpheres() {
        return spheres;
    }

    Voisins premiers(Camera camera) {
        return suivants;
    }

    Voisins suivants() {
        return suivants;
    }

    Obstacles[] obstacles() {
        return obstacles;
    }

    /** Les obstacles de cette lampe ; la recherche sans mémoire si elle n'est pas de la scène. */
    Obstacles obstaclesDe(Lampe lampe) {
        int l = lampes.indexOf(lampe);
        return l < 0 ? (Obstacles) suivants : obstacles[l];
    }
}
