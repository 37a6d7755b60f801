package lancer.rapide;

import java.util.Arrays;
import java.util.List;
import lancer.Lampe;

/** Structures qui répondent à chaque sorte de rayon d'une scène. Partagées par tous les fils : sans état. */
final class Structures {

    final Spheres spheres;
    /** Arbre, qui répond à tout au début, puis là où les autres ne savent pas, ou n'en ont pas les moyens. */
    final Arbre arbre;
    final Lampe[] lampes;

    /** Structures des rayons qui ne quittent aucun objet, et pour les autres. */
    Intersections premiers;
    Intersections suivants;

    /** Structures des rayons d'ombre de chaque lampe. */
    final Occultations[] ombres;

    Structures(Spheres spheres, List<Lampe> lampes) {
        this.spheres = spheres;
        this.lampes = lampes.toArray(new Lampe[0]);
        arbre = new Arbre(spheres);
        premiers = arbre;
        suivants = arbre;
        ombres = new Occultations[this.lampes.length];
        Arrays.fill(ombres, arbre);
    }
}
