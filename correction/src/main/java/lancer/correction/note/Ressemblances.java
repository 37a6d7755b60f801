package lancer.correction.note;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Ce que plusieurs étudiants d'une classe ont rendu de pareil : le rendu d'un groupe, ou des classes écrites de même. */
public final class Ressemblances {

    private Ressemblances() {
    }

    /** @param avis reçoit les groupes ; chaque étudiant, les classes qu'il a écrites comme un autre */
    public static void dire(List<Eleve> eleves, List<String> avis) {
        List<Eleve> juges = eleves.stream().filter(e -> !e.illisible()).collect(Collectors.toList());
        Collection<List<Eleve>> groupes = pareils(juges, e -> e.resultat.empreinte).values();
        groupes.stream().filter(g -> g.size() > 1).forEach(g -> avis.add("un même rendu pour " + g.size() + " identifiants : "
                + g.stream().map(Ressemblances::nom).collect(Collectors.joining(", "))));
        // un groupe n'a écrit chaque classe qu'une fois
        List<Eleve> auteurs = groupes.stream().map(g -> g.get(0)).collect(Collectors.toList());
        Map<Eleve, Map<String, List<String>>> communes = new LinkedHashMap<>();
        auteurs.stream().flatMap(e -> e.resultat.formes.keySet().stream()).distinct().sorted().forEach(classe ->
                pareils(auteurs, e -> e.resultat.formes.get(classe)).values().forEach(memes -> memes.forEach(un ->
                        memes.stream().filter(autre -> autre != un).forEach(autre -> communes.computeIfAbsent(un, e -> new TreeMap<>())
                                .computeIfAbsent(nom(autre), e -> new ArrayList<>()).add(classe)))));
        communes.forEach((un, autres) -> autres.forEach((qui, classes) -> un.aRegarder.add("écrit comme celui de " + qui
                + ", aux noms et aux commentaires près : " + String.join(", ", classes))));
    }

    private static Map<String, List<Eleve>> pareils(List<Eleve> eleves, Function<Eleve, String> empreinte) {
        return eleves.stream().filter(e -> Objects.nonNull(empreinte.apply(e)))
                .collect(Collectors.groupingBy(empreinte, LinkedHashMap::new, Collectors.toList()));
    }

    private static String nom(Eleve eleve) {
        return eleve.resultat.nom + (eleve.resultat.nom.equals(eleve.resultat.id) ? "" : " (" + eleve.resultat.id + ")");
    }
}
