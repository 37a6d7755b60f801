package lancer.inspection;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import lancer.Couleur;

/** Une ligne de l'explication d'un pixel, et les lignes qui l'expliquent à leur tour. Immuable. */
public final class Noeud {

    public final String texte;

    /** La couleur qu'elle montre, ou {@code null}. */
    public final Couleur couleur;

    public final List<Noeud> enfants;

    /** Dit si les enfants ne sont montrés qu'à la demande. */
    public final boolean replie;

    private Noeud(String texte, Couleur couleur, List<Noeud> enfants, boolean replie) {
        this.texte = texte;
        this.couleur = couleur;
        this.enfants = Collections.unmodifiableList(enfants);
        this.replie = replie;
    }

    Noeud(String texte, Couleur couleur) {
        this(texte, couleur, Collections.emptyList(), false);
    }

    /** La même ligne, expliquée par celles-ci. */
    Noeud avec(List<Noeud> lignes, boolean replies) {
        return new Noeud(texte, couleur, lignes, replies);
    }

    /** Les lignes, chacune suivie de celles qui l'expliquent, en retrait ; la racine n'ajoute pas de retrait. */
    public List<String> lignes() {
        List<String> lignes = new ArrayList<>();
        lignes.add(texte);
        enfants.forEach(enfant -> enfant.ecrire("", lignes));
        return lignes;
    }

    private void ecrire(String retrait, List<String> lignes) {
        lignes.add(retrait + texte);
        enfants.forEach(enfant -> enfant.ecrire(retrait + "  ", lignes));
    }
}
