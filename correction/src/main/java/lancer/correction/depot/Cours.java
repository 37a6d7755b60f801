package lancer.correction.depot;

import java.util.Collection;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import lancer.correction.isolement.Arret;
import lancer.correction.modele.SourcesDuCours;

/** Les classes du cours, lues par le JDK : celles du projet à compléter, et celles du corrigé. */
public final class Cours {

    /** Longueur de ce qui, écrit comme le corrigé, en vient. */
    private static final int COPIE = 600;

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

    /** Les méthodes longues que l'étudiant a écrites, par leur nom : les siennes, ou celles qui ont la forme d'une du corrigé. */
    Map<String, Signature> ecrites(Collection<Type> types, boolean duCorrige) {
        Map<String, Signature> ecrites = new TreeMap<>();
        types.forEach(t -> t.methodes.stream().filter(m -> !m.forme.isEmpty() && !a(squelette, m) && a(corrige, m) == duCorrige)
                .forEach(m -> ecrites.put(t.nom + "." + m.nom, m)));
        return ecrites;
    }

    /** Les méthodes écrites comme celles du corrigé ; aucune, si elles sont, toutes ensemble, si courtes que le hasard suffit. */
    Set<String> commeLeCorrige(Collection<Type> types) {
        Map<String, Signature> ecrites = ecrites(types, true);
        return ecrites.values().stream().mapToInt(m -> m.longueur).sum() < COPIE ? Set.of() : ecrites.keySet();
    }

    /** Dit si une méthode de ces classes a cette forme. */
    private static boolean a(Map<String, Type> classes, Signature methode) {
        return classes.values().stream().flatMap(t -> t.methodes.stream()).anyMatch(m -> m.forme.equals(methode.forme));
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
