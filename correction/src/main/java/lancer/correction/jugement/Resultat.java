package lancer.correction.jugement;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lancer.correction.enfant.Echange;

/** Tout ce qu'on a trouvé d'un rendu ; la note n'en est pas, qui dépend du barème. */
public final class Resultat {

    private static final int REMARQUES_MAX = 60;

    /** Pourquoi rien n'a pu être jugé ; vide sinon. */
    public final List<String> refus = new ArrayList<>();
    public final List<String> remarques = new ArrayList<>();

    /** Vrai si c'est la machine, et non le rendu, qui en est la cause : ce n'est pas une note, et rien n'en est retenu. */
    public boolean nonCorrige;
    public final List<Faute> fautes = new ArrayList<>();

    /** Par {@link Verification#id()}, et pour les variantes par leur nom. */
    public final Map<String, Verdict> verdicts = new LinkedHashMap<>();

    /** L'image par toutes ses classes, {@code null} si elle n'a pu être dessinée ; pourquoi. */
    public Image image;
    public String sansImage = "";

    /** L'écart à la référence, et s'il est pris au centre des pixels plutôt qu'à leurs coordonnées entières. */
    public Ecart ecart;
    public boolean centre;
    public Chemin chemin;

    /** Un autre pixel, où une réponse s'écarte plus tôt ; {@code null} s'il n'y en a pas. */
    public Chemin cheminPlusTot;

    /** Les classes qui, seules parmi celles du corrigé, changent l'image. */
    public final List<String> classesFautives = new ArrayList<>();

    /** Ce qu'on en dit tient en peu de lignes, quoi que le rendu contienne. */
    void abreger() {
        remarques.replaceAll(Echange::protege);
        if (remarques.size() > REMARQUES_MAX) {
            remarques.subList(REMARQUES_MAX, remarques.size()).clear();
        }
    }
}
