package lancer.correction.note;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.correction.Panne;
import lancer.correction.depot.Source;
import lancer.correction.enfant.Texte;
import lancer.correction.jugement.GrilleDeNotation;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;

/**
 * Les points que l'enseignant donne dans {@code ajustements.csv} : {@code id,critère,points,commentaire}, avec des virgules ou des
 * points-virgules, avec ou sans titres. Le critère est une ligne du barème. Une ligne sans nombre ne donne pas de points.
 */
public final class Ajustements {

    private static final String TITRES = "id,critère,points,commentaire";

    /** Des points donnés pour un critère, avec un commentaire. */
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

    /**
     * Lit {@code ajustements.csv} dans ce dossier, s'il existe.
     *
     * @throws Panne si des lignes sont fautives : elle les nomme toutes
     */
    public Ajustements(Path dossier, Collection<String> ids, GrilleDeNotation grille, Bareme bareme) {
        Path fichier = dossier.resolve("ajustements.csv");
        if (!Files.exists(fichier)) {
            return;
        }
        List<String> fautes = new ArrayList<>();
        try {
            String texte = Source.decoder(Files.readAllBytes(fichier));
            for (CSVRecord ligne : CSVParser.parse(texte, CSVFormat.DEFAULT.builder().setIgnoreSurroundingSpaces(true)
                    .setDelimiter(texte.split("\n", 2)[0].contains(";") ? ';' : ',').get())) {
                String faute = ligne.getRecordNumber() == 1 && ligne.get(0).equalsIgnoreCase("id") ? ""
                        : prendre(ligne, ids, grille, bareme);
                if (!faute.isEmpty()) {
                    fautes.add("ligne " + ligne.getParser().getCurrentLineNumber() + ", " + faute);
                }
            }
        } catch (IOException | RuntimeException e) {
            fautes.add("la suite est illisible (" + e.getMessage() + ")");
        }
        if (!fautes.isEmpty()) {
            throw new Panne(2, "ajustements.csv : " + String.join(" ; ", fautes) + " ; rien n'est noté");
        }
    }

    /** @return la faute de cette ligne, vide s'il n'y en a pas */
    private String prendre(CSVRecord ligne, Collection<String> ids, GrilleDeNotation grille, Bareme bareme) {
        String lu = ligne.get(0);
        String id = ids.stream().filter(i -> lu.equals(i) || lu.equals(Texte.sansFormule(i))).findFirst()
                .orElse(lu.replaceFirst("^\\D+", ""));
        if (ligne.size() < 3 || ligne.size() > 4) {
            return "attendu : " + TITRES;
        }
        String critere = ligne.get(1);
        String points = ligne.get(2);
        GrilleDeNotation.Etape etape = grille.etapes.stream().filter(e -> e.nom.equals(critere)).findFirst().orElse(null);
        if (!ids.contains(id)) {
            return "l'étudiant « " + lu + " » n'existe pas";
        } else if (etape == null) {
            return "le critère « " + critere + " » n'existe pas ; attendu : un parmi "
                    + grille.etapes.stream().map(e -> e.nom).collect(Collectors.joining(", "))
                    + ", ou une ligne de plus dans bareme.ini : bonus=+1, retard=-2";
        } else if (points.isEmpty()) {
            return "";
        } else if (!points.matches("[+-]?\\d{1,4}([.,]\\d{1,6})?")) {
            return "« " + points + " » ; attendu : un nombre de points";
        }
        double nombre = Double.parseDouble(points.replace(',', '.'));
        double borne = bareme.ecrits(critere);
        // l'enseignant donne ce qu'il veut aux consignes
        if (!critere.equals(GrilleDeNotation.CONSIGNES) && (nombre < Math.min(0, borne) || nombre > Math.max(0, borne))) {
            return "« " + points + " » ; attendu : de " + (borne < 0 ? borne + " à 0" : "0 à " + borne) + " pour « " + critere + " »";
        }
        return lignes.computeIfAbsent(id, i -> new LinkedHashMap<>()).putIfAbsent(critere, new Ligne(ligne.toList())) == null ? ""
                : "« " + critere + " » a déjà été donné à « " + id + " » plus haut";
    }

    /** Points donnés à cet étudiant, par critère. */
    public Map<String, Ligne> de(String id) {
        return lignes.getOrDefault(id, Map.of());
    }

    /**
     * Écrit {@code ajustements-a-remplir.csv} : les lignes déjà données, puis une ligne sans nombre par extension rendue ou ligne libre à
     * noter. Une fois rempli, ce fichier remplace {@code ajustements.csv}.
     */
    public void ecrireARemplir(Path dossier, List<Eleve> eleves, Sorties sorties) throws IOException {
        List<List<?>> tableau = new ArrayList<>(List.of(List.of(TITRES.split(","))));
        for (Eleve eleve : eleves) {
            de(eleve.resultat.id).values().forEach(ligne -> tableau.add(ligne.cases));
            (eleve.illisible() ? List.<String>of() : eleve.aNoter()).forEach(critere ->
                    tableau.add(List.of(Texte.sansFormule(eleve.resultat.id), critere, "", "")));
        }
        ecrire(dossier.resolve("ajustements-a-remplir.csv"), tableau, sorties);
    }

    /** Écrit un tableau dans ce fichier ; un demi-caractère, que l'UTF-8 n'a pas, devient « ? ». */
    public static void ecrire(Path fichier, List<List<?>> lignes, Sorties sorties) throws IOException {
        StringWriter ecrit = new StringWriter();
        CSVFormat.DEFAULT.print(ecrit).printRecords(lignes);
        sorties.ecrire(fichier, ecrit.toString().getBytes(StandardCharsets.UTF_8));
    }
}
