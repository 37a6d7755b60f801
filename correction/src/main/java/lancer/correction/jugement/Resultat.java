package lancer.correction.jugement;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lancer.correction.enfant.Echange;

/** Tout ce qu'on a trouvé d'un rendu ; la note n'en est pas, qui dépend du barème. */
public final class Resultat {

    private static final int REMARQUES_MAX = 30;
    private static final char FIN_DE_LIGNE = '\u2028';

    /** Pourquoi rien n'a pu être jugé ; vide sinon. */
    public final List<String> refus = new ArrayList<>();
    public final List<String> remarques = new ArrayList<>();

    /** Vrai si c'est la machine, et non le rendu, qui en est la cause : ce n'est pas une note, et rien n'en est retenu. */
    public boolean nonCorrige;

    /** Les fautes de compilation. */
    public final List<String> fautes = new ArrayList<>();

    /** Par {@link Verification#id()}, et pour les variantes par leur nom. */
    public final Map<String, Verdict> verdicts = new LinkedHashMap<>();

    /** Pourquoi l'enseignant doit le regarder lui-même. */
    public final List<String> aRegarder = new ArrayList<>();

    /** De chaque classe changée du cours, son texte sans ce qui n'est que présentation ni noms choisis, abrégé. */
    public final Map<String, String> empreintes = new LinkedHashMap<>();

    /** Par critère raté, la méthode de l'étudiant qui en répond. */
    public final Map<String, String> methodes = new LinkedHashMap<>();

    /** Les images qui ont pu être dessinées : par scène, celles de toutes ses classes, et par extension, celle qu'elle fait. */
    public final Map<String, Image> images = new LinkedHashMap<>();

    /** Vrai si ses rayons passent au centre des pixels, plutôt qu'à leurs coordonnées entières. */
    public boolean centre;

    /** À un pixel très faux, ce que répondent les méthodes, {@code null} si rien n'est faux. */
    public Chemin chemin;

    /** Les classes qui, seules parmi celles du corrigé, changent l'image. */
    public final List<String> classesFautives = new ArrayList<>();

    /** Ce qu'on en dit tient en peu de lignes, quoi que le rendu contienne. */
    void abreger() {
        for (List<String> liste : List.of(remarques, aRegarder)) {
            liste.replaceAll(Echange::protege);
            if (liste.size() > REMARQUES_MAX) {
                liste.subList(REMARQUES_MAX, liste.size()).clear();
            }
        }
    }

    /** Ajoute une raison de regarder ce rendu, une fois. */
    void regarder(String raison) {
        if (!aRegarder.contains(raison)) {
            aRegarder.add(raison);
        }
    }

    /** Ce qu'a donné un critère ; « non commencé » s'il n'a pas été essayé. */
    public Verdict verdict(Grille.Critere critere) {
        return verdicts.getOrDefault(critere.id, new Verdict(Verdict.Etat.NON_COMMENCE, ""));
    }

    /** Combien de critères sont réussis. */
    double reussis() {
        return verdicts.values().stream().mapToDouble(v -> v.part).sum();
    }

    private Map<String, List<String>> listes() {
        return Map.of("remarque", remarques, "faute", fautes, "regarder", aRegarder, "fautive", classesFautives);
    }

    /** Le garde dans un fichier : une chose par ligne, sa sorte, son nom et sa valeur. */
    void ecrire(Path fichier) throws IOException {
        List<String> lignes = new ArrayList<>();
        listes().forEach((sorte, liste) -> liste.forEach(texte -> ligne(lignes, sorte, "", texte)));
        verdicts.forEach((id, v) -> ligne(lignes, "verdict", id, v.etat + " " + v.part + " " + v.message));
        empreintes.forEach((classe, texte) -> ligne(lignes, "empreinte", classe, texte));
        methodes.forEach((id, texte) -> ligne(lignes, "methode", id, texte));
        images.forEach((scene, image) -> ligne(lignes, "image", scene, image.texte()));
        ligne(lignes, "centre", "", "" + centre);
        if (chemin != null) {
            ligne(lignes, "chemin", chemin.x + " " + chemin.y, chemin.reference + FIN_DE_LIGNE + chemin.etudiant);
        }
        // deux rendus identiques peuvent s'écrire en même temps
        Path neuf = Files.createTempFile(fichier.getParent(), "neuf", null);
        Files.write(neuf, String.join("\n", lignes).getBytes(StandardCharsets.UTF_8));
        Files.move(neuf, fichier, StandardCopyOption.REPLACE_EXISTING);
    }

    private static void ligne(List<String> lignes, String sorte, String nom, String valeur) {
        lignes.add(sorte + "\t" + nom + "\t" + valeur.replace('\n', FIN_DE_LIGNE).replace('\r', ' '));
    }

    static Resultat lire(Path fichier) throws IOException {
        Resultat resultat = new Resultat();
        for (String ligne : Files.readAllLines(fichier)) {
            String[] mots = ligne.split("\t", 3);
            String valeur = mots[2].replace(FIN_DE_LIGNE, '\n');
            if (resultat.listes().containsKey(mots[0])) {
                resultat.listes().get(mots[0]).add(valeur);
            } else if (mots[0].equals("verdict")) {
                String[] trois = valeur.split(" ", 3);
                resultat.verdicts.put(mots[1], new Verdict(Verdict.Etat.valueOf(trois[0]), trois[2], Double.parseDouble(trois[1])));
            } else if (mots[0].equals("image")) {
                resultat.images.put(mots[1], Image.relire(valeur));
            } else if (mots[0].equals("centre")) {
                resultat.centre = Boolean.parseBoolean(valeur);
            } else if (mots[0].equals("chemin")) {
                String[] point = mots[1].split(" ");
                String[] deux = valeur.split("\n", 2);
                resultat.chemin = new Chemin(Integer.parseInt(point[0]), Integer.parseInt(point[1]), deux[0], deux[1]);
            } else {
                (mots[0].equals("methode") ? resultat.methodes : resultat.empreintes).put(mots[1], valeur);
            }
        }
        return resultat;
    }
}
