package lancer.scene;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/** Section d'où vient chaque objet et chaque lampe d'un fichier. */
public final class Origines {

    private final List<Object> choses = new ArrayList<>();
    private final List<Origine> lues = new ArrayList<>();
    /** Les origines, par objet ou lampe ; table construite à la première demande. */
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
