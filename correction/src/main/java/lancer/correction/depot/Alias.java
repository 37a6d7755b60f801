package lancer.correction.depot;

import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import lancer.correction.modele.SourcesDuCours;

/** Noms du cours que des étudiants ont changés, déclarés par l'enseignant dans un {@link Tableau} : {@code id,nom écrit,nom du cours}. */
public final class Alias {

    private static final String TITRES = "id,nom écrit,nom du cours";
    private static final Pattern NOM = Pattern.compile("[\\p{L}_$][\\p{L}\\p{N}_$]{0,99}");

    private final Map<String, Map<String, String>> noms = new HashMap<>();
    /** Les lignes refusées, et pourquoi. */
    public final List<String> fautes;

    /** Lit {@code alias.csv} dans ce dossier, s'il existe. */
    public Alias(Path dossier, Collection<String> ids) {
        fautes = Tableau.lire(dossier.resolve("alias.csv"), TITRES, ids, (id, ligne) -> {
            String sien = ligne.get(1);
            String duCours = ligne.get(2);
            if (!NOM.matcher(sien).matches() || estDuCours(sien)) {
                return "« " + sien + " » ; attendu : un nom que l'étudiant a écrit à la place de celui du cours";
            } else if (!NOM.matcher(duCours).matches() || !estDuCours(duCours)) {
                return "« " + duCours + " » ; attendu : le nom d'une classe ou d'une méthode du cours";
            }
            return noms.computeIfAbsent(id, i -> new TreeMap<>()).putIfAbsent(duCours, sien) == null ? ""
                    : "« " + duCours + " » a déjà un autre nom plus haut ; cette ligne-ci est laissée";
        });
    }

    private static boolean estDuCours(String nom) {
        return SourcesDuCours.classes().contains(nom) || SourcesDuCours.classes().stream()
                .anyMatch(c -> Pattern.compile(" " + Pattern.quote(nom) + "\\(").matcher(SourcesDuCours.squelette(c)).find());
    }

    /** Noms que cet étudiant a changés : celui du cours, puis le sien. */
    public Map<String, String> de(String id) {
        return noms.getOrDefault(id, Map.of());
    }

    /** La ligne d'{@code alias.csv} qui déclare un nom. */
    static String ligne(String id, String sien, String duCours) {
        return (id.matches("[^,;\"\\s]+") ? id : "\"" + id.replace("\"", "\"\"") + "\"") + "," + sien + "," + duCours;
    }
}
