package lancer.correction.depot;

import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.isolement.Arret;
import lancer.correction.modele.SourcesDuCours;

/**
 * Les classes du cours, lues par le JDK, sous les noms que l'étudiant leur donne et que l'enseignant a déclarés. Les classes de la
 * correction qui appellent le rendu et le corrigé prennent ces noms. Le texte de l'étudiant n'est jamais modifié.
 */
public final class Cours {

    /** Lecture de textes Java. */
    public interface LectureDeSources {

        /** Une valeur par texte, celle de {@link lancer.correction.enfant.Lecteur#lire}. */
        List<?> lire(List<String> textes) throws Arret;
    }

    private final Map<String, String> noms;
    private final Map<String, Type> squelette;
    private final Map<String, Type> corrige;

    /** @param noms ceux de l'étudiant, par nom du cours */
    public Cours(LectureDeSources lecture, Map<String, String> noms) throws Arret {
        this.noms = noms;
        squelette = lire(lecture, SourcesDuCours::squelette);
        corrige = lire(lecture, SourcesDuCours::corrige);
    }

    private Map<String, Type> lire(LectureDeSources lecture, Function<String, String> source) throws Arret {
        List<String> textes = SourcesDuCours.classes().stream().map(c -> dans(source.apply(c))).collect(Collectors.toList());
        Iterator<?> lus = lecture.lire(textes).iterator();
        return textes.stream().map(t -> Source.types((List<?>) lus.next(), t).get(0)).collect(Collectors.toMap(t -> t.nom, t -> t));
    }

    /** Dit si l'enseignant a déclaré un nom changé. */
    public boolean renomme() {
        return !noms.isEmpty();
    }

    /** Le nom que l'étudiant donne à une classe du cours. */
    public String classe(String duCours) {
        return noms.getOrDefault(duCours, duCours);
    }

    /** Un texte de la correction, où chaque nom du cours est remplacé par celui de l'étudiant. */
    public String dans(String texte) {
        return noms.isEmpty() ? texte : Pattern.compile("(?<!\")\\b(?:" + String.join("|", noms.keySet()) + ")\\b")
                .matcher(texte).replaceAll(m -> Matcher.quoteReplacement(noms.get(m.group())));
    }

    /** Des classes de la correction, par nom complet, avec les mêmes remplacements. */
    public Map<String, String> dans(Map<String, String> classes) {
        Map<String, String> autres = new HashMap<>();
        classes.forEach((nom, texte) -> autres.put("lancer/" + classe(nom.replace("lancer/", "")), dans(texte)));
        return autres;
    }

    /** Une classe du projet à compléter, par son nom du cours. */
    public Type squelette(String classe) {
        return squelette.get(classe(classe));
    }

    /** Empreintes des méthodes de cette classe dans le projet à compléter et le corrigé, qui ne sont pas le travail d'un étudiant. */
    public Set<String> arbres(String classe) {
        return Stream.of(squelette, corrige).flatMap(types -> types.get(classe(classe)).methodes.stream()).map(m -> m.arbre)
                .collect(Collectors.toSet());
    }
}
