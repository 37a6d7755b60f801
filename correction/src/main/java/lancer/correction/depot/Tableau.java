package lancer.correction.depot;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.function.BiFunction;
import lancer.correction.enfant.Echange;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;

/**
 * Un petit tableau écrit par l'enseignant, jamais par le programme : un étudiant par ligne, des virgules ou des points-virgules, avec ou
 * sans titres. Une ligne fautive est signalée et ignorée.
 */
public final class Tableau {

    private Tableau() {
    }

    /**
     * Lit un tableau, s'il existe.
     *
     * @param titres les colonnes, séparées par des virgules, l'identifiant d'abord ; la dernière peut manquer
     * @param prendre reçoit l'identifiant et la ligne ; rend la faute, vide s'il n'y en a pas
     * @return les lignes refusées, et pourquoi
     */
    public static List<String> lire(Path fichier, String titres, Collection<String> ids, BiFunction<String, CSVRecord, String> prendre) {
        List<String> fautes = new ArrayList<>();
        if (!Files.exists(fichier)) {
            return fautes;
        }
        int colonnes = titres.split(",").length;
        try {
            String texte = Source.decoder(Files.readAllBytes(fichier));
            try (CSVParser csv = CSVParser.parse(new StringReader(texte), CSVFormat.DEFAULT.builder()
                    .setDelimiter(texte.split("\n", 2)[0].contains(";") ? ';' : ',').setIgnoreSurroundingSpaces(true).get())) {
                for (CSVRecord ligne : csv) {
                    String lu = ligne.get(0);
                    String id = ids.stream().filter(i -> lu.equals(i) || lu.equals(Echange.sansFormule(i))).findFirst()
                            .orElse(lu.replaceFirst("^\\D+", ""));
                    String faute = ligne.getRecordNumber() == 1 && lu.equalsIgnoreCase("id") ? ""
                            : ligne.size() < Math.min(3, colonnes) || ligne.size() > colonnes ? "attendu : " + titres
                            : !ids.contains(id) ? "l'étudiant « " + lu + " » n'existe pas" : prendre.apply(id, ligne);
                    if (!faute.isEmpty()) {
                        fautes.add(fichier.getFileName() + ", ligne " + csv.getCurrentLineNumber() + " : " + faute);
                    }
                }
            }
        } catch (IOException | RuntimeException e) {
            fautes.add(fichier.getFileName() + " : la suite est illisible (" + e.getMessage() + ")");
        }
        return fautes;
    }
}
