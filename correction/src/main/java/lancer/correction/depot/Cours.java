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
 * Les classes du cours, telles que le JDK les lit, sous les noms qu'un étudiant leur donne, et que l'enseignant a déclarés : ce que nous
 * écrivons nous-mêmes, ce qui appelle le rendu et le corrigé, prend les siens. Son texte n'est jamais changé.
 */
public final class Cours {

    /** Qui lit du Java. */
    public interface LectureDeSources {

        /** Une valeur par texte, celle que dit {@link lancer.correction.enfant.Lecteur#lire}. */
        List<?> lire(List<String> textes) throws Arret;
    }

    private final Map<String, String> noms;
    private final Map<String, Type> squelette;
    private final Map<String, Type> corrige;

    /** @param noms celui de l'étudiant, par celui du cours */
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

    /** Vrai s'il en a changé un nom, que l'enseignant a déclaré. */
    public boolean renomme() {
        return !noms.isEmpty();
    }

    /** Le nom qu'il donne à une classe du cours : le même, le plus souvent. */
    public String classe(String duCours) {
        return noms.getOrDefault(duCours, duCours);
    }

    /** Un texte à nous, où chaque nom du cours est celui qu'il lui donne. */
    public String dans(String texte) {
        return noms.isEmpty() ? texte : Pattern.compile("(?<!\")\\b(?:" + String.join("|", noms.keySet()) + ")\\b")
                .matcher(texte).replaceAll(m -> Matcher.quoteReplacement(noms.get(m.group())));
    }

    /** Des classes à nous, par nom complet, où de même. */
    public Map<String, String> dans(Map<String, String> classes) {
        Map<String, String> autres = new HashMap<>();
        classes.forEach((nom, texte) -> autres.put("lancer/" + classe(nom.replace("lancer/", "")), dans(texte)));
        return autres;
    }

    /** Une classe du projet à compléter, par son nom du cours. */
    public Type squelette(String classe) {
        return squelette.get(classe(classe));
    }

    /** Empreintes des méthodes de cette classe qui ne sont le travail de personne : celles du projet à compléter et du corrigé. */
    public Set<String> arbres(String classe) {
        return Stream.of(squelette, corrige).flatMap(types -> types.get(classe(classe)).methodes.stream()).map(m -> m.arbre)
                .collect(Collectors.toSet());
    }
}
