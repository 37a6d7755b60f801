package lancer.correction.jugement;

import java.io.IOException;
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
 * Tout ce qu'on a trouvé d'un rendu, écrit dans un fichier à lui. La note n'en est pas : elle dépend du barème, et de ce que
 * l'enseignant donne.
 */
public final class Resultat {

    /** Identifiant et nom de l'étudiant. */
    public final String id;
    public final String nom;
    /** Raisons pour lesquelles rien n'a pu être jugé ; vide sinon. */
    public final List<String> refus = new ArrayList<>();
    public final List<String> remarques = new ArrayList<>();
    /** Vrai si c'est la machine, et non le rendu, qui en est la cause : ce n'est pas une note, et rien n'en est retenu. */
    public boolean nonCorrige;
    /** Les fautes de compilation. */
    public final List<String> fautes = new ArrayList<>();
    /** Verdicts par {@link Verification#id()}, et pour les variantes par leur nom. */
    public final Map<String, Verdict> verdicts = new LinkedHashMap<>();
    /** Raisons pour lesquelles l'enseignant doit le regarder lui-même. */
    public final List<String> aRegarder = new ArrayList<>();
    /** Arbre de chaque longue méthode, {@code Classe.methode(types)}, qui n'est ni celle du projet à compléter, ni celle du corrigé. */
    public final Map<String, String> arbres = new LinkedHashMap<>();
    /** Empreinte de chaque classe donnée qui a été changée. */
    public final Map<String, String> empreintes = new LinkedHashMap<>();
    /** Méthode de l'étudiant, par critère raté, qui en répond. */
    public final Map<String, String> methodes = new LinkedHashMap<>();
    /** Les images qui ont pu être dessinées : par scène, celles de toutes ses classes, et par extension, celle qu'elle fait. */
    public final Map<String, Image> images = new LinkedHashMap<>();
    /** Vrai si ses rayons passent au centre des pixels, plutôt qu'à leurs coordonnées entières. */
    public boolean centre;
    /** Réponses des méthodes à un pixel très faux, {@code null} si rien n'est faux. */
    public Chemin chemin;
    /** Les classes qui, seules parmi celles du corrigé, changent l'image. */
    public final List<String> classesFautives = new ArrayList<>();

    Resultat(String id, String nom) {
        this.id = id;
        this.nom = nom;
    }

    /** Ajoute une raison de regarder ce rendu, une fois. */
    void regarder(String raison) {
        if (!aRegarder.contains(raison)) {
            aRegarder.add(raison);
        }
    }

    /** Verdict d'un critère ; « non commencé » s'il n'a pas été essayé. */
    public Verdict verdict(Verification critere) {
        return verdicts.getOrDefault(critere.id(), new Verdict(Verdict.Etat.NON_COMMENCE, ""));
    }

    /** Nombre de critères réussis. */
    long reussis() {
        return verdicts.values().stream().filter(Verdict::compte).count();
    }

    private Map<String, List<String>> listes() {
        return Map.of("refus", refus, "remarque", remarques, "faute", fautes, "regarder", aRegarder, "fautive", classesFautives);
    }

    private Map<String, Map<String, String>> textes() {
        return Map.of("empreinte", empreintes, "arbre", arbres, "methode", methodes);
    }

    /** Écrit le résultat dans un fichier : une chose par ligne, sa sorte, puis ses valeurs. */
    public void ecrire(Path fichier) throws IOException {
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

    /** Écrit un tableau. */
    public static void ecrire(Path fichier, List<List<?>> lignes) throws IOException {
        try (CSVPrinter csv = new CSVPrinter(Files.newBufferedWriter(fichier), CSVFormat.DEFAULT)) {
            csv.printRecords(lignes);
        }
    }

    static List<CSVRecord> lignes(Path fichier) throws IOException {
        try (CSVParser csv = CSVParser.parse(fichier, StandardCharsets.UTF_8, CSVFormat.DEFAULT)) {
            return csv.getRecords();
        }
    }

    /** @throws RuntimeException si ce fichier n'est pas celui d'un résultat */
    public static Resultat lire(Path fichier) throws IOException {
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
