package lancer.rapide;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.Lampe;

/** Structures de recherche d'une scène, par sorte de rayon. Tous les fils les partagent. */
final class Structures {

    final Spheres spheres;
    /** Arbre : il répond à la place d'une structure qui manque, ou qui n'accepte pas le rayon. */
    final Arbre arbre;
    final Lampe[] lampes;

    /** Structures des rayons de l'écran, puis des rayons réfléchis. */
    Intersections premiers;
    Intersections suivants;

    /** Structures des rayons d'ombre de chaque lampe. */
    final Occultations[] ombres;

    /** Première réponse qui diffère de celle des boucles du cours, {@code null} tant qu'il n'y en a pas. */
    volatile String ecart;
    boolean sondees;

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
