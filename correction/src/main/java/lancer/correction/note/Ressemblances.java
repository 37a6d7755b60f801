package lancer.correction.note;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Ce que plusieurs étudiants d'une classe ont rendu de pareil : le rendu d'un groupe, ou des classes écrites de même. */
public final class Ressemblances {

    private Ressemblances() {
    }

    /** @param avis reçoit les groupes ; chaque étudiant, les classes qu'il a écrites comme un autre */
    public static void dire(List<Eleve> eleves, List<String> avis) {
        List<Eleve> juges = eleves.stream().filter(e -> !e.illisible()).collect(Collectors.toList());
        Collection<List<Eleve>> groupes = juges.stream().collect(Collectors.groupingBy(e -> e.resultat.empreinte, LinkedHashMap::new,
                Collectors.toList())).values();
        groupes.stream().filter(g -> g.size() > 1).forEach(g -> avis.add("un même rendu pour " + g.size() + " identifiants : "
                + g.stream().map(e -> e.resultat.qui()).collect(Collectors.joining(", "))));
        // un groupe n'a écrit chaque classe qu'une fois
        List<Eleve> auteurs = groupes.stream().map(g -> g.get(0)).collect(Collectors.toList());
        for (Eleve un : auteurs) {
            Map<String, List<String>> classes = new TreeMap<>();
            auteurs.stream().filter(autre -> autre != un).forEach(autre -> {
                String communes = un.resultat.formes.entrySet().stream().filter(f -> f.getValue().equals(autre.resultat.formes
                        .get(f.getKey()))).map(Map.Entry::getKey).collect(Collectors.joining(", "));
                classes.computeIfAbsent(communes, c -> new ArrayList<>()).add(autre.resultat.qui());
            });
            classes.remove("");
            classes.forEach((communes, autres) -> un.aRegarder.add("écrit comme chez " + String.join(", ", autres)
                    + ", aux noms et aux commentaires près : " + communes));
        }
    }
}
