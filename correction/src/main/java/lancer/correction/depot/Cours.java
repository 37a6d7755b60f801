package lancer.correction.depot;

import java.util.Map;
import lancer.correction.isolement.Arret;
import lancer.correction.modele.SourcesDuCours;

/** Les classes du cours, lues par le JDK : celles du projet à compléter, et celles du corrigé. */
public final class Cours {

    public final Map<String, Type> squelette;
    private final Map<String, Type> corrige;

    public Cours(Source.Lecture lecture) throws Arret {
        squelette = Source.duCours(lecture, SourcesDuCours::squelette);
        corrige = Source.duCours(lecture, SourcesDuCours::corrige);
    }

    /** D'où vient ce texte : 0, de l'étudiant ; 1, du projet à compléter ; 2, du corrigé. */
    int provenance(Type type) {
        Type aCompleter = squelette.get(type.nom);
        if (aCompleter == null || type.empreinte.equals(aCompleter.empreinte)) {
            return aCompleter == null ? 0 : 1;
        }
        return type.empreinte.equals(corrige.get(type.nom).empreinte) ? 2 : 0;
    }
}
