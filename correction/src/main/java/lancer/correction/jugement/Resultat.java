package lancer.correction.jugement;

import java.io.IOException;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVPrinter;
import org.apache.commons.csv.CSVRecord;

/**
 * Résultat du jugement d'un rendu, écrit dans son propre fichier. La note n'y est pas : elle dépend du barème et des points que donne
 * l'enseignant.
 */
public final class Resultat {

    /** Identifiant et nom de l'étudiant. */
    public final String id;
    public final String nom;
    /** Raisons pour lesquelles rien n'a pu être jugé ; vide sinon. */
    public final List<String> refus = new ArrayList<>();
    public final List<String> remarques = new ArrayList<>();
    /** Vrai si la machine, et non le rendu, a empêché de juger : le rendu n'a alors pas de note. */
    public boolean nonCorrige;
    public final List<String> fautes = new ArrayList<>();
    /** Verdicts par {@link Verification#id()}, et par nom pour les variantes. */
    public final Map<String, Verdict> verdicts = new LinkedHashMap<>();
    /** Raisons pour lesquelles l'enseignant doit examiner ce rendu. */
    public final List<String> aRegarder = new ArrayList<>();
    /** Empreinte de chaque classe donnée que l'étudiant a modifiée. */
    public final Map<String, String> empreintes = new LinkedHashMap<>();
    /** Méthode de l'étudiant que vise chaque critère raté. */
    public final Map<String, String> methodes = new LinkedHashMap<>();
    /** Les images dessinées : par scène, avec toutes les classes du rendu ; par extension, celle de l'extension. */
    public final Map<String, Image> images = new LinkedHashMap<>();
    /** Vrai si les rayons passent au centre des pixels, et non aux coordonnées entières. */
    public boolean centre;
    /** Réponses intermédiaires pour un pixel très faux, {@code null} si l'image est juste. */
    public Chemin chemin;
    /** Les classes qui, seules avec celles du corrigé, changent l'image. */
    public final List<String> classesFautives = new ArrayList<>();

    Resultat(String id, String nom) {
        this.id = id;
        this.nom = nom;
    }

    /** Ajoute une raison d'examiner ce rendu, sans doublon. */
    void regarder(String raison) {
        if (!aRegarder.contains(raison)) {
            aRegarder.add(raison);
        }
    }

    /** Verdict d'un critère ; « non commencé » s'il n'a pas été essayé. */
    public Verdict verdict(Verification critere) {
        return verdicts.getOrDefault(critere.id(), new Verdict(Verdict.Etat.NON_COMMENCE, ""));
    }

    long reussis() {
        return verdicts.values().stream().filter(Verdict::compte).count();
    }

    private Map<String, List<String>> listes() {
        return Map.of("refus", refus, "remarque", remarques, "faute", fautes, "regarder", aRegarder, "fautive", classesFautives);
    }

    private Map<String, Map<String, String>> textes() {
        return Map.of("empreinte", empreintes, "methode", methodes);
    }

    /** Écrit le résultat dans un fichier, une donnée par ligne : sa sorte, puis ses valeurs. */
    void ecrire(Path fichier) throws IOException {
        List<List<?>> lignes = new ArrayList<>();
        lignes.add(List.of("étudiant", id, nom, nonCorrige, centre));
        listes().forEach((sorte, liste) -> liste.forEach(texte -> lignes.add(List.of(sorte, texte))));
        textes().forEach((sorte, textes) -> textes.forEach((nom, texte) -> lignes.add(List.of(sorte, nom, texte))));
        verdicts.forEach((id, v) -> lignes.add(List.of("verdict", id, v.etat, v.message)));
        images.forEach((nom, image) -> lignes.add(image.ligne(nom)));
        if (chemin != null) {
            lignes.add(List.of("chemin", chemin.x, chemin.y, chemin.reference, chemin.etudiant));
        }
        ecrire(fichier, lignes);
    }

    public static void ecrire(Path fichier, List<List<?>> lignes) throws IOException {
        // ce flux remplace une moitié de caractère, que d'autres refusent
        try (CSVPrinter csv = new CSVPrinter(new OutputStreamWriter(Files.newOutputStream(fichier), StandardCharsets.UTF_8),
                CSVFormat.DEFAULT)) {
            csv.printRecords(lignes);
        }
    }

    static List<CSVRecord> lignes(Path fichier) throws IOException {
        try (CSVParser csv = CSVParser.parse(fichier, StandardCharsets.UTF_8, CSVFormat.DEFAULT)) {
            return csv.getRecords();
        }
    }

    /** @throws RuntimeException si ce fichier n'est pas celui d'un résultat */
    static Resultat lire(Path fichier) throws IOException {
        List<CSVRecord> lignes = lignes(fichier);
        Resultat resultat = new Resultat(lignes.get(0).get(1), lignes.get(0).get(2));
        resultat.nonCorrige = Boolean.parseBoolean(lignes.get(0).get(3));
        resultat.centre = Boolean.parseBoolean(lignes.get(0).get(4));
        for (CSVRecord ligne : lignes.subList(1, lignes.size())) {
            String sorte = ligne.get(0);
            if (resultat.listes().containsKey(sorte)) {
                resultat.listes().get(sorte).add(ligne.get(1));
            } else if (resultat.textes().containsKey(sorte)) {
                resultat.textes().get(sorte).put(ligne.get(1), ligne.get(2));
            } else if (sorte.equals("verdict")) {
                resultat.verdicts.put(ligne.get(1), new Verdict(Verdict.Etat.valueOf(ligne.get(2)), ligne.get(3)));
            } else if (sorte.equals("image")) {
                resultat.images.put(ligne.get(1), new Image(ligne));
            } else {
                resultat.chemin = new Chemin(Integer.parseInt(ligne.get(1)), Integer.parseInt(ligne.get(2)), ligne.get(3),
                        ligne.get(4));
            }
        }
        return resultat;
    }
}
