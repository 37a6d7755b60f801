package lancer.correction;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.correction.depot.Rendu;
import lancer.correction.jugement.Resultat;
import lancer.correction.modele.Modele;
import lancer.correction.note.Note;

/** Une ligne de la classe : un rendu, ce qu'on en a trouvé, et sa note. */
public final class Eleve {

    /** Nombre de longues méthodes égales qui font deux rendus pareils. */
    private static final int PAREILLES = 3;

    public final Rendu rendu;
    public final Resultat resultat;
    public final Note note;
    /** Le nom de sa page. */
    public final String page;
    /** Raisons pour lesquelles l'enseignant doit regarder ce rendu lui-même ; vide si rien ne le demande. */
    public final List<String> aRegarder;

    Eleve(Rendu rendu, Resultat resultat, Note note, String page) {
        this.rendu = rendu;
        this.resultat = resultat;
        this.note = note;
        this.page = page;
        aRegarder = new ArrayList<>(illisible() ? resultat.refus : resultat.aRegarder);
        if (note.perduSansJuger > 0) {
            aRegarder.add(String.format(Locale.FRANCE, "points perdus par ce qui n'a pu être évalué : %.2f",
                    note.perduSansJuger));
        }
    }

    /** Vrai si rien n'a pu être jugé. */
    public boolean illisible() {
        return !resultat.refus.isEmpty();
    }

    /** Ajoute à ce qu'il faut regarder ce qu'on ne voit qu'en comparant : deux rendus pareils, une classe donnée que l'un a changée. */
    static void comparer(List<Eleve> eleves) {
        for (Eleve e : eleves) {
            String pareils = eleves.stream().filter(a -> a != e && e.resultat.arbres.entrySet().stream()
                    .filter(a.resultat.arbres.entrySet()::contains).count() >= PAREILLES).map(a -> a.rendu.nom)
                    .collect(Collectors.joining(", "));
            if (!pareils.isEmpty()) {
                e.aRegarder.add("pareil, aux noms de variables et à la présentation près, à : " + pareils);
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
