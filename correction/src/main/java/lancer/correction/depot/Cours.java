package lancer.correction.depot;

import java.util.Map;
import java.util.Set;
import lancer.correction.isolement.Arret;
import lancer.correction.modele.SourcesDuCours;

/** Les classes du cours, lues par le JDK : celles du projet à compléter, et celles du corrigé. */
public final class Cours {

    /** Ce qu'il faut écrire, en caractères, pour que ce ne soit pas par hasard comme un autre. */
    private static final int LONGUE = 250;

    public final Map<String, Type> squelette;
    private final Map<String, Type> corrige;

    public Cours(Source.Lecture lecture) throws Arret {
        squelette = Source.duCours(lecture, SourcesDuCours::squelette);
        corrige = Source.duCours(lecture, SourcesDuCours::corrige);
    }

    /** D'où vient ce texte : 0, de l'étudiant, ou d'une classe donnée ; 1, du projet à compléter ; 2, du corrigé. */
    int provenance(Type type) {
        if (!SourcesDuCours.A_COMPLETER.contains(type.nom)) {
            return 0;
        } else if (type.empreinte.equals(squelette.get(type.nom).empreinte)) {
            return 1;
        }
        return type.empreinte.equals(corrige.get(type.nom).empreinte) ? 2 : 0;
    }

    /** L'empreinte d'une classe que deux étudiants n'écrivent pas pareil par hasard, sans les noms des variables ; vide sinon. */
    String forme(Type type) {
        boolean longue = type.longueur > squelette.get(type.nom).longueur + LONGUE;
        return longue && !type.forme.equals(corrige.get(type.nom).forme) ? type.forme : "";
    }

    /** Dit si cette classe a la plupart des méthodes de celle du cours qui a son nom, à défaut de ses noms, ou n'a rien d'autre. */
    boolean ressemble(Type type) {
        Type sienne = squelette.getOrDefault(type.nom, Type.rien(type.nom));
        Set<String> attendus = sienne.nommees().isEmpty() ? sienne.noms : sienne.nommees();
        Set<String> siens = sienne.nommees().isEmpty() ? type.noms : type.nommees();
        return type.methodes.isEmpty() && sienne.noms.containsAll(type.noms)
                || 2 * attendus.stream().filter(siens::contains).count() > attendus.size();
    }
}
