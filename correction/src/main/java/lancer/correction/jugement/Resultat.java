package lancer.correction.jugement;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Tout ce qu'on a trouvé d'un rendu ; la note n'en est pas, qui dépend du barème. */
public final class Resultat implements Serializable {

    private static final long serialVersionUID = 1;

    /** Pourquoi rien n'a pu être jugé ; vide sinon. */
    public final List<String> refus = new ArrayList<>();
    public final List<String> remarques = new ArrayList<>();
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
}
