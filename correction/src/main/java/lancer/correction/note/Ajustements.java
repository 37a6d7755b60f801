package lancer.correction.note;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lancer.correction.depot.Source;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;

/**
 * Les points que l'enseignant donne de sa main, dans un fichier que l'on ne récrit jamais : {@code
 * id,critère,points,commentaire}, où le critère est une étape du barème, ou une de ses lignes libres. Une ligne qui ne
 * convient pas est nommée, et ne coûte qu'elle.
 */
public final class Ajustements {

    private static final String TITRES = "id,critère,points,commentaire";

    /** Des points donnés pour un critère, et pourquoi. */
    public static final class Ligne {

        public final double points;
        public final String commentaire;

        Ligne(double points, String commentaire) {
            this.points = points;
            this.commentaire = commentaire;
        }
    }

    private final Map<String, Map<String, Ligne>> lignes = new HashMap<>();
    /** Les lignes qui ne conviennent pas, et pourquoi. */
    public final List<String> fautes = new ArrayList<>();

    /** Lit ce fichier ; s'il n'existe pas, y écrit les titres des colonnes. */
    public Ajustements(Path fichier, Collection<String> ids, Collection<String> criteres) {
        try {
            if (!Files.exists(fichier)) {
                Files.writeString(fichier, TITRES + "\n");
            }
            String texte = Source.decoder(Files.readAllBytes(fichier));
            boolean pointVirgule = texte.split("\n", 2)[0].contains(";");
            try (CSVParser csv = CSVParser.parse(new StringReader(texte), CSVFormat.DEFAULT.builder()
                    .setDelimiter(pointVirgule ? ';' : ',').setIgnoreSurroundingSpaces(true).get())) {
                for (CSVRecord ligne : csv) {
                    String faute = ligne.getRecordNumber() == 1 && ligne.get(0).equalsIgnoreCase("id") ? ""
                            : lire(ligne, ids, criteres);
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
    private String lire(CSVRecord ligne, Collection<String> ids, Collection<String> criteres) {
        if (ligne.size() < 3 || ligne.size() > 4) {
            return "attendu : " + TITRES;
        }
        String id = ids.contains(ligne.get(0)) ? ligne.get(0) : ligne.get(0).replaceFirst("^\\D+", "");
        String points = ligne.get(2).replace(',', '.');
        if (!ids.contains(id)) {
            return "l'étudiant « " + ligne.get(0) + " » n'existe pas";
        } else if (!criteres.contains(ligne.get(1))) {
            return "le critère « " + ligne.get(1) + " » n'existe pas ; attendu : un parmi " + String.join(", ", criteres);
        } else if (!points.matches("[+-]?\\d{1,4}(\\.\\d{1,6})?")) {
            return "« " + ligne.get(2) + " » ; attendu : un nombre de points";
        }
        Ligne donnee = new Ligne(Double.parseDouble(points), ligne.size() > 3 ? ligne.get(3) : "");
        return lignes.computeIfAbsent(id, i -> new HashMap<>()).putIfAbsent(ligne.get(1), donnee) == null ? ""
                : "« " + ligne.get(1) + " » a déjà été donné à « " + id + " » plus haut ; cette ligne-ci est laissée";
    }

    /** Points donnés à cet étudiant, par critère. */
    public Map<String, Ligne> de(String id) {
        return lignes.getOrDefault(id, Map.of());
    }
}
