package lancer.correction.note;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Ce que quelques étudiants d'une classe ont rendu de pareil : le rendu d'un groupe, ou des méthodes écrites de même. */
public final class Ressemblances {

    private Ressemblances() {
    }

    /** Part de la classe au-delà de laquelle une façon d'écrire une méthode est celle du cours. */
    private static final int PART = 3;

    /** @param avis reçoit les groupes ; chaque étudiant, les méthodes qu'il a écrites comme un autre */
    public static void dire(List<Eleve> eleves, List<String> avis) {
        List<Eleve> juges = eleves.stream().filter(e -> !e.illisible()).collect(Collectors.toList());
        Collection<List<Eleve>> groupes = juges.stream().collect(Collectors.groupingBy(e -> e.resultat.empreinte, LinkedHashMap::new,
                Collectors.toList())).values();
        groupes.stream().filter(g -> g.size() > 1).forEach(g -> avis.add("un même rendu pour " + g.size() + " identifiants : "
                + g.stream().map(e -> e.resultat.qui()).collect(Collectors.joining(", "))));
        // un groupe n'a écrit chaque classe qu'une fois
        List<Eleve> auteurs = groupes.stream().map(g -> g.get(0)).collect(Collectors.toList());
        Map<String, Long> fois = auteurs.stream().flatMap(a -> a.resultat.formes.values().stream())
                .collect(Collectors.groupingBy(f -> f, Collectors.counting()));
        fois.values().removeIf(combien -> combien > Math.max(2, auteurs.size() / PART));
        for (Eleve un : auteurs) {
            Map<String, List<String>> methodes = new TreeMap<>();
            auteurs.stream().filter(autre -> autre != un).forEach(autre -> {
                String communes = un.resultat.formes.entrySet().stream().filter(f -> fois.containsKey(f.getValue())
                        && autre.resultat.formes.containsValue(f.getValue())).map(Map.Entry::getKey).collect(Collectors.joining(", "));
                methodes.computeIfAbsent(communes, c -> new ArrayList<>()).add(autre.resultat.qui());
            });
            methodes.remove("");
            methodes.forEach((communes, autres) -> un.aRegarder.add("écrit comme chez " + String.join(", ", autres)
                    + ", aux noms et aux commentaires près : " + communes));
        }
    }
}
