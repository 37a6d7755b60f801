package lancer.rapide;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
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

    /** Noms des structures : celle des premiers rayons, celle des réfléchis, celle de chaque lampe. */
    @Override
    public String toString() {
        return Stream.concat(Stream.of(premiers, suivants), Arrays.stream(ombres))
                .map(structure -> structure.getClass().getSimpleName()).collect(Collectors.joining(" "));
    }
}
