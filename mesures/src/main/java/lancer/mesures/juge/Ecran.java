package lancer.mesures.juge;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import lancer.Camera;
import lancer.Constantes;
import lancer.Objet3D;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;

/**
 * Nos premiers rayons partent de l'écran, ceux de POV-Ray de l'œil : ce qui est entre les deux, nous ne le voyons que dans les
 * reflets. POV-Ray en fait autant d'un objet marqué {@code no_image}, pourvu que personne ne le voie directement.
 */
final class Ecran {

    private Ecran() {
    }

    /**
     * Les objets qu'un rayon de l'œil au centre d'un pixel rencontre avant l'écran.
     *
     * @param scene préparée pour cette caméra
     * @throws Intraduisible si un premier rayon voit l'un d'eux
     */
    static Set<Objet3D> traverses(Scene scene, Camera camera) throws Intraduisible {
        List<Sphere> proches = new ArrayList<>();
        for (Objet3D objet : scene.getObjets()) {
            if (objet instanceof Sphere && ((Sphere) objet).getCentre().z - ((Sphere) objet).getRayon() < 0) {
                proches.add((Sphere) objet);
            }
        }
        Set<Objet3D> traverses = new HashSet<>();
        if (!proches.isEmpty()) {
            pourChaqueRayon(camera, rayon -> traverses(proches, rayon, traverses));
        }
        if (!traverses.isEmpty()) {
            Set<Objet3D> vus = new HashSet<>();
            pourChaqueRayon(camera, rayon -> {
                scene.getClosestIntersection(rayon);
                vus.add(rayon.getObjet());
            });
            vus.retainAll(traverses);
            if (!vus.isEmpty()) {
                throw new Intraduisible(vus.iterator().next() + " traverse l'écran, et se voit derrière lui");
            }
        }
        return traverses;
    }

    private static void pourChaqueRayon(Camera camera, Consumer<Rayon> quoi) {
        for (int j = 0; j < camera.getHauteur(); j++) {
            for (int i = 0; i < camera.getLargeur(); i++) {
                quoi.accept(camera.getRayon(i + 0.5, j + 0.5));
            }
        }
    }

    private static void traverses(List<Sphere> proches, Rayon rayon, Set<Objet3D> traverses) {
        Vecteur jusqua = new Vecteur(Camera.OEIL, rayon.getP());
        for (Sphere sphere : proches) {
            if (!traverses.contains(sphere)) {
                double d = sphere.getIntersectionDistance(new Rayon(Camera.OEIL, jusqua));
                if (d < Constantes.INFINI && d <= jusqua.norme()) {
                    traverses.add(sphere);
                }
            }
        }
    }
}
