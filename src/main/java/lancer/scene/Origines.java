package lancer.scene;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/** Origine de chaque objet et de chaque lampe d'un fichier. */
public final class Origines {

    private final List<Object> choses = new ArrayList<>();
    private final List<Origine> lues = new ArrayList<>();
    /** Les origines, par objet ou lampe : rangées à la première question, qu'une image sans fenêtre ne pose pas. */
    private Map<Object, Origine> rangees;

    static final class Origine {
        final String nom;
        final int ligne;

        Origine(String nom, int ligne) {
            this.nom = nom;
            this.ligne = ligne;
        }
    }

    public Origines() {
    }

    /** Les mêmes origines, où une chose en remplace une autre. */
    Origines(Origines autre, Object ancienne, Object nouvelle) {
        choses.addAll(autre.choses);
        choses.replaceAll(chose -> chose == ancienne ? nouvelle : chose);
        lues.addAll(autre.lues);
    }

    void ajouter(Object chose, Origine origine) {
        choses.add(chose);
        lues.add(origine);
    }

    /** Texte de la forme {@code [Sphere ambre] ligne 52} ; {@code null} si cet objet ne vient pas d'un fichier. */
    public synchronized String de(Object chose) {
        if (rangees == null) {
            rangees = new IdentityHashMap<>(choses.size());
            for (int k = 0; k < choses.size(); k++) {
                rangees.putIfAbsent(choses.get(k), lues.get(k));
            }
        }
        Origine origine = rangees.get(chose);
        return origine == null ? null : "[" + origine.nom + "] ligne " + origine.ligne;
    }
}
