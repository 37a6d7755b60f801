package lancer.correction;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import lancer.correction.depot.Rendu;
import lancer.correction.jugement.Resultat;
import lancer.correction.note.Note;

/** Une ligne de la classe : un rendu, ce qu'on en a trouvé, et sa note. */
public final class Eleve {

    public final Rendu rendu;
    public final Resultat resultat;
    public final Note note;
    /** Le nom de sa page. */
    public final String page;
    /** Pourquoi l'enseignant doit regarder ce rendu lui-même ; vide si rien ne le demande. */
    public final List<String> aRegarder;

    Eleve(Rendu rendu, Resultat resultat, Note note, String page) {
        this.rendu = rendu;
        this.resultat = resultat;
        this.note = note;
        this.page = page;
        aRegarder = new ArrayList<>(illisible() ? resultat.refus : resultat.aRegarder);
        if (note.perduSansJuger > 0) {
            aRegarder.add(String.format(Locale.FRANCE, "%.2f points perdus par ce qui n'a pu être évalué",
                    note.perduSansJuger));
        }
    }

    /** Vrai si rien n'a pu être jugé. */
    public boolean illisible() {
        return !resultat.refus.isEmpty();
    }
}
