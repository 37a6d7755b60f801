package lancer.correction.depot;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * Noms du cours que l'étudiant a changés, et que l'enseignant a déclarés : ce que nous écrivons nous-mêmes, ce qui appelle le rendu et
 * le corrigé, prend les siens. Son texte n'est jamais changé.
 */
public final class Noms {

    private final Map<String, String> noms;

    /** @param noms celui de l'étudiant, par celui du cours */
    Noms(Map<String, String> noms) {
        this.noms = noms;
    }

    /** Le nom qu'il donne à une classe du cours : le même, le plus souvent. */
    public String classe(String duCours) {
        return noms.getOrDefault(duCours, duCours);
    }

    /** Un texte à nous, où chaque nom du cours est celui qu'il lui donne. */
    public String dans(String texte) {
        return noms.isEmpty() ? texte : Pattern.compile("(?<!\")\\b(?:" + String.join("|", noms.keySet()) + ")\\b")
                .matcher(texte).replaceAll(m -> noms.get(m.group()).replace("$", "\\$"));
    }

    /** Des classes à nous, par nom complet, où de même. */
    public Map<String, String> dans(Map<String, String> classes) {
        Map<String, String> autres = new LinkedHashMap<>();
        classes.forEach((nom, texte) -> autres.put("lancer/" + classe(nom.replace("lancer/", "")), dans(texte)));
        return autres;
    }
}
