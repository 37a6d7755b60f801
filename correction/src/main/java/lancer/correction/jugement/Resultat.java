package lancer.correction.jugement;

import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.DoubleAdder;
import lancer.correction.depot.Rendu;
import lancer.correction.enfant.Texte;

/**
 * Résultat du jugement d'un rendu, écrit dans son propre fichier. La note n'y est pas : elle dépend du barème et des points que donne
 * l'enseignant.
 */
public final class Resultat {

    /** Identifiant et nom de l'étudiant, et noms des entrées de la classe qui sont son rendu. */
    public final String id;
    public final String nom;
    public final List<String> entrees;
    /** Ce qui distingue ce travail d'un autre, et quand il a été jugé. */
    public final String empreinte;
    public final String date = LocalDateTime.now().format(DateTimeFormatter.ofPattern("dd/MM/yyyy à HH:mm:ss"));
    /** Ce que ce résultat a remplacé, vide s'il n'a rien remplacé. */
    public transient String remplace = "";
    /** Raison pour laquelle ce rendu s'est exécuté sans confinement ; vide s'il a été confiné. */
    public final String sansConfinement;
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
    /** Méthode de l'étudiant que vise chaque critère raté. */
    public final Map<String, String> methodes = new LinkedHashMap<>();
    /** Les empreintes de ses longues méthodes, sans les noms de leurs variables. */
    public final Map<String, String> formes = new TreeMap<>();
    /** Les images dessinées : par scène, avec toutes les classes du rendu ; par extension, celle de l'extension. */
    public final Map<String, Image> images = new LinkedHashMap<>();
    /** Vrai si les rayons passent au centre des pixels, et non aux coordonnées entières. */
    public boolean centre;
    /** Réponses intermédiaires pour un pixel très faux, {@code null} si l'image est juste. */
    public Chemin chemin;
    /** Les classes qui, seules avec celles du corrigé, changent l'image. */
    public final List<String> classesFautives = new ArrayList<>();

    /** Secondes de calcul et de sommeil de ses machines virtuelles. */
    final transient DoubleAdder depense = new DoubleAdder();

    Resultat(Rendu rendu, String sansConfinement) {
        this.id = rendu.id;
        this.nom = rendu.nom;
        this.entrees = List.copyOf(rendu.entrees.keySet());
        this.empreinte = rendu.empreinte();
        this.sansConfinement = sansConfinement;
    }

    /** Le nom, et l'identifiant s'il est autre, en une ligne. */
    public String qui() {
        String court = Texte.protege(id, Rendu.NOM_MAX);
        return nom + (nom.equals(court) ? "" : " (" + court + ")");
    }

    /** Ajoute une raison d'examiner ce rendu, sans doublon. */
    void regarder(String raison) {
        if (!aRegarder.contains(raison)) {
            aRegarder.add(raison);
        }
    }

    /** Verdict d'un critère ; « non commencé » s'il n'a pas été essayé. */
    public Verdict verdict(Verification critere) {
        return verdicts.getOrDefault(critere.id(), new Verdict(Verdict.Etat.NON_COMMENCE, "", ""));
    }
}
