package lancer.correction.depot;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import lancer.correction.modele.Modele;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;

/**
 * Les noms du cours que des étudiants ont changés, tels que l'enseignant les déclare dans un fichier que l'on n'écrit jamais : {@code
 * id,nom écrit,nom du cours}. Une ligne qui ne convient pas est nommée, et ne coûte qu'elle.
 */
public final class Alias {

    private static final String TITRES = "id,nom écrit,nom du cours";
    private static final Pattern NOM = Pattern.compile("[\\p{L}_$][\\p{L}\\p{N}_$]{0,99}");

    private final Map<String, Map<String, String>> noms = new HashMap<>();
    /** Les lignes qui ne conviennent pas, et pourquoi. */
    public final List<String> fautes = new ArrayList<>();

    /** Lit ce fichier, s'il existe. */
    public Alias(Path fichier, Collection<String> ids) {
        if (!Files.exists(fichier)) {
            return;
        }
        try {
            String texte = Source.decoder(Files.readAllBytes(fichier));
            try (CSVParser csv = CSVParser.parse(new StringReader(texte), CSVFormat.DEFAULT.builder()
                    .setDelimiter(texte.split("\n", 2)[0].contains(";") ? ';' : ',').setIgnoreSurroundingSpaces(true).get())) {
                for (CSVRecord ligne : csv) {
                    String faute = ligne.getRecordNumber() == 1 && ligne.get(0).equalsIgnoreCase("id") ? "" : lire(ligne, ids);
                    if (!faute.isEmpty()) {
                        fautes.add(fichier.getFileName() + ", ligne " + csv.getCurrentLineNumber() + " : " + faute);
                    }
                }
            }
        } catch (IOException | RuntimeException e) {
            fautes.add(fichier.getFileName() + " : la suite est illisible (" + e.getMessage() + ")");
        }
    }

    /** @return ce qui ne va pas, vide si tout va */
    private String lire(CSVRecord ligne, Collection<String> ids) {
        if (ligne.size() != 3) {
            return "attendu : " + TITRES;
        }
        String id = ids.contains(ligne.get(0)) ? ligne.get(0) : ligne.get(0).replaceFirst("^\\D+", "");
        String sien = ligne.get(1);
        String duCours = ligne.get(2);
        if (!ids.contains(id)) {
            return "l'étudiant « " + ligne.get(0) + " » n'existe pas";
        } else if (!NOM.matcher(sien).matches() || estDuCours(sien)) {
            return "« " + sien + " » ; attendu : un nom que l'étudiant a écrit à la place de celui du cours";
        } else if (!NOM.matcher(duCours).matches() || !estDuCours(duCours)) {
            return "« " + duCours + " » ; attendu : le nom d'une classe ou d'une méthode du cours";
        }
        return noms.computeIfAbsent(id, i -> new TreeMap<>()).putIfAbsent(duCours, sien) == null ? ""
                : "« " + duCours + " » a déjà un autre nom plus haut ; cette ligne-ci est laissée";
    }

    private static boolean estDuCours(String nom) {
        return Modele.classes().contains(nom) || Modele.classes().stream()
                .anyMatch(c -> Pattern.compile(" " + Pattern.quote(nom) + "\\(").matcher(Modele.squelette(c)).find());
    }

    /** Noms que cet étudiant a changés : celui du cours, et le sien. */
    public Map<String, String> de(String id) {
        return noms.getOrDefault(id, Map.of());
    }

    /** La ligne qui déclare un nom, prête à coller. */
    static String ligne(String id, String sien, String duCours) {
        return (id.matches("[^,;\"\\s]+") ? id : "\"" + id.replace("\"", "\"\"") + "\"") + "," + sien + "," + duCours;
    }
}
