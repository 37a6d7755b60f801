package lancer.correction.note;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lancer.correction.Eleve;
import lancer.correction.depot.Source;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVPrinter;
import org.apache.commons.csv.CSVRecord;

/**
 * Les points que l'enseignant donne de sa main, dans {@code ajustements.csv}, que l'on n'écrit jamais : {@code
 * id,critère,points,commentaire}, où le critère est une étape du barème, une extension, ou une ligne libre. Sans nombre, une
 * ligne ne donne rien encore. Une ligne qui ne convient pas est nommée, et ne coûte qu'elle.
 */
public final class Ajustements {

    private static final List<String> TITRES = List.of("id", "critère", "points", "commentaire");

    /** Des points donnés pour un critère, et pourquoi. */
    public static final class Ligne {

        public final double points;
        public final String commentaire;
        private final List<String> cases;

        Ligne(List<String> cases) {
            points = Double.parseDouble(cases.get(2).replace(',', '.'));
            commentaire = cases.size() > 3 ? cases.get(3) : "";
            this.cases = cases;
        }
    }

    private final Map<String, Map<String, Ligne>> lignes = new HashMap<>();
    /** Les lignes qui ne conviennent pas, et pourquoi. */
    public final List<String> fautes = new ArrayList<>();

    /** Lit {@code ajustements.csv} dans ce dossier ; s'il n'y est pas, rien n'est donné. */
    public Ajustements(Path dossier, Collection<String> ids, Collection<String> criteres) {
        Path fichier = dossier.resolve("ajustements.csv");
        if (!Files.exists(fichier)) {
            return;
        }
        try {
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
            return "attendu : " + String.join(",", TITRES);
        }
        String id = ids.contains(ligne.get(0)) ? ligne.get(0) : ligne.get(0).replaceFirst("^\\D+", "");
        if (!ids.contains(id)) {
            return "l'étudiant « " + ligne.get(0) + " » n'existe pas";
        } else if (!criteres.contains(ligne.get(1))) {
            return "le critère « " + ligne.get(1) + " » n'existe pas ; attendu : un parmi " + String.join(", ", criteres);
        } else if (ligne.get(2).isEmpty()) {
            return "";
        } else if (!ligne.get(2).matches("[+-]?\\d{1,4}([.,]\\d{1,6})?")) {
            return "« " + ligne.get(2) + " » ; attendu : un nombre de points";
        }
        return lignes.computeIfAbsent(id, i -> new LinkedHashMap<>()).putIfAbsent(ligne.get(1), new Ligne(ligne.toList())) == null ? ""
                : "« " + ligne.get(1) + " » a déjà été donné à « " + id + " » plus haut ; cette ligne-ci est laissée";
    }

    /** Points donnés à cet étudiant, par critère. */
    public Map<String, Ligne> de(String id) {
        return lignes.getOrDefault(id, Map.of());
    }

    /**
     * Écrit {@code ajustements-a-remplir.csv} : les lignes déjà données, telles quelles, et une ligne sans nombre pour chaque
     * extension rendue et chaque ligne libre qui reste à noter. Rempli, il remplace {@code ajustements.csv}.
     */
    public void ecrireARemplir(Path dossier, List<Eleve> eleves) throws IOException {
        try (BufferedWriter texte = Files.newBufferedWriter(dossier.resolve("ajustements-a-remplir.csv"));
                CSVPrinter csv = new CSVPrinter(texte, CSVFormat.DEFAULT)) {
            csv.printRecord(TITRES);
            for (Eleve eleve : eleves) {
                for (Ligne ligne : de(eleve.resultat.id).values()) {
                    csv.printRecord(ligne.cases);
                }
                for (String critere : eleve.illisible() ? List.<String>of() : eleve.note.aNoter()) {
                    csv.printRecord(eleve.resultat.id, critere, "", "");
                }
            }
        }
    }
}
