package lancer.mesures.juge;

import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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
        Set<Objet3D> traverses = scene.getObjets().stream().filter(Sphere.class::isInstance).map(Sphere.class::cast)
                .filter(s -> s.getCentre().z - s.getRayon() < 0 && rayons(camera).anyMatch(rayon -> estAvant(s, rayon)))
                .collect(Collectors.toSet());
        Optional<Objet3D> vu = traverses.isEmpty() ? Optional.empty() : rayons(camera).map(rayon -> {
            scene.getClosestIntersection(rayon);
            return rayon.getObjet();
        }).filter(traverses::contains).findFirst();
        if (vu.isPresent()) {
            throw new Intraduisible(vu.get() + " traverse l'écran, et se voit derrière lui");
        }
        return traverses;
    }

    private static Stream<Rayon> rayons(Camera camera) {
        int largeur = camera.getLargeur();
        return IntStream.range(0, largeur * camera.getHauteur()).mapToObj(k -> camera.getRayon(k % largeur + 0.5, k / largeur + 0.5));
    }

    /** Vrai si un rayon de l'œil rencontre cette sphère avant l'écran, d'où part celui-ci. */
    private static boolean estAvant(Sphere sphere, Rayon rayon) {
        Vecteur jusqua = new Vecteur(Camera.OEIL, rayon.getP());
        double d = sphere.getIntersectionDistance(new Rayon(Camera.OEIL, jusqua));
        return d < Constantes.INFINI && d <= jusqua.norme();
    }
}
