package lancer.scene;

import java.util.ArrayList;
import java.util.List;
import lancer.contrat.Section;

/** Origine de chaque objet et de chaque lampe d'un fichier : le nom de sa section, et sa ligne. */
public final class Origines {

    private final List<Object> choses = new ArrayList<>();
    private final List<String> textes = new ArrayList<>();

    void ajouter(Object chose, Section section) {
        choses.add(chose);
        textes.add("[" + section.nom + "] ligne " + section.ligne);
    }

    /** Texte de la forme {@code [Sphere ambre] ligne 52} ; {@code null} si cet objet ne vient pas d'un fichier. */
    public String de(Object chose) {
        for (int k = 0; k < choses.size(); k++) {
            if (choses.get(k) == chose) {
                return textes.get(k);
            }
        }
        return null;
    }
}
