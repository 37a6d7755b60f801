package lancer.correction.depot;

import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lancer.correction.isolement.Arret;
import lancer.correction.modele.SourcesDuCours;

/** Les classes du projet à compléter, lues par le JDK. */
public final class Cours {

    /** Lecture de textes Java. */
    public interface LectureDeSources {

        /** Une valeur par texte, celle de {@link lancer.correction.enfant.Lecteur#lire}. */
        List<?> lire(List<String> textes) throws Arret;
    }

    private final Map<String, Type> squelette;

    public Cours(LectureDeSources lecture) throws Arret {
        List<String> textes = SourcesDuCours.classes().stream().map(SourcesDuCours::squelette).collect(Collectors.toList());
        Iterator<?> lus = lecture.lire(textes).iterator();
        squelette = textes.stream().map(t -> Source.types((List<?>) lus.next(), t).get(0)).collect(Collectors.toMap(t -> t.nom, t -> t));
    }

    /** Une classe du projet à compléter. */
    public Type squelette(String classe) {
        return squelette.get(classe);
    }
}
