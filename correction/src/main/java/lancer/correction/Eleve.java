package lancer.correction;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.correction.jugement.Resultat;
import lancer.correction.jugement.Verdict;
import lancer.correction.modele.Modele;
import lancer.correction.note.Note;

/** Une ligne de la classe : ce qu'on a trouvé d'un rendu, et sa note. */
public final class Eleve {

    /** Nombre de méthodes pareilles à partir duquel deux rendus sont dits pareils. */
    private static final int PAREILLES = 3;

    public final Resultat resultat;
    public final Note note;
    /** Le nom de sa page. */
    public final String page;
    /** Raisons pour lesquelles l'enseignant doit regarder ce rendu lui-même ; vide si rien ne le demande. */
    public final List<String> aRegarder;

    Eleve(Resultat resultat, Note note, String page) {
        this.resultat = resultat;
        this.note = note;
        this.page = page;
        aRegarder = new ArrayList<>(illisible() ? resultat.refus : resultat.aRegarder);
        double compilation = note.perdus(Verdict.Etat.NE_SE_COMPILE_PAS);
        aRegarder.replaceAll(raison -> raison.startsWith(Verdict.Etat.NE_SE_COMPILE_PAS.texte) ? raison + " ; coûte " + points(compilation) : raison);
        if (note.perdus(Verdict.Etat.NON_EVALUABLE) > 0) {
            aRegarder.add(points(note.perdus(Verdict.Etat.NON_EVALUABLE)) + " perdus par ce qui n'a pu être évalué");
        }
    }

    private static String points(double nombre) {
        return String.format(Locale.FRANCE, "%.2f points", nombre);
    }

    /** Vrai si rien n'a pu être jugé. */
    public boolean illisible() {
        return !resultat.refus.isEmpty();
    }

    /** Ajoute à ce qu'il faut regarder ce qu'on ne voit qu'en comparant : des méthodes pareilles, une classe donnée que l'un a changée. */
    static void comparer(List<Eleve> eleves) {
        Map<String, Integer> nombres = new HashMap<>();
        eleves.forEach(e -> e.resultat.arbres.values().stream().distinct().forEach(a -> nombres.merge(a, 1, Integer::sum)));
        // celle de presque tous vient du cours, et non d'un voisin
        nombres.values().removeIf(n -> n > 2 && 4 * n > 3 * eleves.size());
        for (Eleve e : eleves) {
            for (Eleve autre : eleves) {
                List<String> pareilles = e == autre ? List.of() : e.resultat.arbres.entrySet().stream()
                        .filter(m -> nombres.containsKey(m.getValue()) && autre.resultat.arbres.containsValue(m.getValue()))
                        .map(Map.Entry::getKey).collect(Collectors.toList());
                if (pareilles.size() >= PAREILLES) {
                    e.aRegarder.add("pareil à " + autre.resultat.nom + ", aux noms des variables et à la présentation près : "
                            + String.join(", ", pareilles));
                }
            }
        }
        for (String classe : Modele.DONNEES) {
            Map<String, List<Eleve>> textes = eleves.stream().filter(e -> !classe.equals("Main")
                    && e.resultat.empreintes.containsKey(classe))
                    .collect(Collectors.groupingBy(e -> e.resultat.empreintes.get(classe)));
            // celle que presque tous ont rendue est celle qu'on leur a donnée
            textes.values().stream().filter(t -> t.size() < 3 || 2 * t.size() < eleves.size()).forEach(t -> t.forEach(e ->
                    e.aRegarder.add("la classe donnée " + classe + " a été changée")));
        }
    }
}
