package lancer.correction;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import lancer.correction.modele.Modele;

/** Ce que l'on ne voit qu'en comparant les rendus d'une classe : deux pareils, et une classe donnée que l'un a changée. */
final class Ressemblances {

    private Ressemblances() {
    }

    /** L'ajoute à ce qu'il faut regarder de chacun. */
    static void dire(List<Eleve> eleves) {
        Map<Map<String, String>, List<Eleve>> pareils = eleves.stream()
                .filter(e -> e.resultat.empreintes.containsKey("Objet3D"))
                .collect(Collectors.groupingBy(e -> duTravail(e)));
        pareils.values().stream().filter(p -> p.size() > 1).forEach(p -> p.forEach(e -> e.aRegarder.add(
                "pareil, aux noms de variables et à la présentation près, à : " + p.stream().filter(a -> a != e)
                .map(a -> a.rendu.nom).collect(Collectors.joining(", ")))));
        for (String classe : Modele.DONNEES) {
            Map<String, List<Eleve>> textes = eleves.stream().filter(e -> !classe.equals("Main")
                    && e.resultat.empreintes.containsKey(classe))
                    .collect(Collectors.groupingBy(e -> e.resultat.empreintes.get(classe)));
            // celle que presque tous ont rendue est celle qu'on leur a donnée
            textes.values().stream().filter(t -> t.size() < 3 || 2 * t.size() < eleves.size()).forEach(t -> t.forEach(e ->
                    e.aRegarder.add("la classe donnée " + classe + " a été changée")));
        }
    }

    private static Map<String, String> duTravail(Eleve eleve) {
        Map<String, String> siennes = new TreeMap<>(eleve.resultat.empreintes);
        siennes.keySet().retainAll(Modele.A_COMPLETER);
        return siennes;
    }
}
