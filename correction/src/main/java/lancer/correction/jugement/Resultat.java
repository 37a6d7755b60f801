package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lancer.correction.enfant.Echange;

/** Tout ce qu'on a trouvé d'un rendu ; la note n'en est pas, qui dépend du barème. */
public final class Resultat {

    private static final int REMARQUES_MAX = 30;

    /** Pourquoi rien n'a pu être jugé ; vide sinon. */
    public final List<String> refus = new ArrayList<>();
    public final List<String> remarques = new ArrayList<>();

    /** Vrai si c'est la machine, et non le rendu, qui en est la cause : ce n'est pas une note, et rien n'en est retenu. */
    public boolean nonCorrige;
    public final List<Faute> fautes = new ArrayList<>();

    /** Par {@link Verification#id()}, et pour les variantes par leur nom. */
    public final Map<String, Verdict> verdicts = new LinkedHashMap<>();

    /** Pourquoi l'enseignant doit le regarder lui-même. */
    public final List<String> aRegarder = new ArrayList<>();

    /** De chaque classe changée du cours, son texte sans ce qui n'est que présentation ni noms choisis, abrégé. */
    public final Map<String, String> empreintes = new LinkedHashMap<>();

    /** Par critère raté, la méthode de l'étudiant qui en répond. */
    public final Map<String, String> methodes = new LinkedHashMap<>();

    /** Les images par toutes ses classes, par scène : celles qui ont pu être dessinées. */
    public final Map<String, Image> images = new LinkedHashMap<>();

    /** Celle que chaque extension fait de la scène du cours. */
    public final Map<String, Image> variantes = new LinkedHashMap<>();

    /** Vrai si ses rayons passent au centre des pixels, plutôt qu'à leurs coordonnées entières. */
    public boolean centre;

    /** Au pixel le plus faux, ce que répondent les méthodes, {@code null} si rien n'est faux. */
    public Chemin chemin;

    /** Un autre pixel, où une réponse s'écarte plus tôt ; {@code null} s'il n'y en a pas. */
    public Chemin cheminPlusTot;

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

    /** Combien de critères sont réussis. */
    double reussis() {
        return verdicts.values().stream().mapToDouble(Verdict::part).sum();
    }
}
