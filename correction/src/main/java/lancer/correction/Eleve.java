package lancer.correction;

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

    Eleve(Rendu rendu, Resultat resultat, Note note, String page) {
        this.rendu = rendu;
        this.resultat = resultat;
        this.note = note;
        this.page = page;
    }

    /** Vrai si rien n'a pu être jugé. */
    public boolean illisible() {
        return !resultat.refus.isEmpty();
    }
}
