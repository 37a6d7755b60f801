package lancer.rapide;

import java.util.Arrays;
import java.util.List;
import lancer.Camera;
import lancer.Lampe;

/** Ce qui répond à chaque sorte de rayon d'une scène. Partagé par tous les fils : sans état. */
final class Structures {

    final Spheres spheres;
    /** Celui qui répond là où les autres ne savent pas, ou n'en ont pas les moyens. */
    final Arbre arbre;
    final Lampe[] lampes;
    final Camera camera;

    /** Pour les rayons qui ne quittent aucun objet, et pour les autres. */
    Intersections premiers;
    Intersections suivants;

    /** Pour les rayons d'ombre de chaque lampe, et d'une lampe qui n'est pas de la scène. */
    final Occultations[] ombres;
    Occultations ombresDAilleurs;

    Structures(Spheres spheres, List<Lampe> lampes, Camera camera) {
        this.spheres = spheres;
        this.camera = camera;
        this.lampes = lampes.toArray(new Lampe[0]);
        arbre = new Arbre(spheres);
        ombres = new Occultations[this.lampes.length];
    }

    /** Répond à toutes les questions par cela. */
    <T extends Intersections & Occultations> void repondrePar(T toutes) {
        premiers = toutes;
        suivants = toutes;
        ombresDAilleurs = toutes;
        Arrays.fill(ombres, toutes);
    }

    /** Leurs noms : celle des premiers rayons, celle des réfléchis, celle de chaque lampe. */
    @Override
    public String toString() {
        StringBuilder noms = new StringBuilder(premiers.getClass().getSimpleName() + " "
                + suivants.getClass().getSimpleName());
        for (Occultations ombre : ombres) {
            noms.append(' ').append(ombre.getClass().getSimpleName());
        }
        return noms.toString();
    }
}
