package lancer.scene;

import java.util.ArrayList;
import java.util.List;
import lancer.contrat.Section;

/** Origine de chaque objet et de chaque lampe d'un fichier : le nom de sa section, et sa ligne. */
public final class Origines {

    private final List<Object> choses = new ArrayList<>();
    private final List<String> noms = new ArrayList<>();
    private final List<Integer> lignes = new ArrayList<>();

    void ajouter(Object chose, Section section) {
        choses.add(chose);
        noms.add(section.nom);
        lignes.add(section.ligne);
    }

    /** Texte de la forme {@code [Sphere ambre] ligne 52} ; {@code null} si cet objet ne vient pas d'un fichier. */
    public String de(Object chose) {
        for (int k = 0; k < choses.size(); k++) {
            if (choses.get(k) == chose) {
                return "[" + noms.get(k) + "] ligne " + lignes.get(k);
            }
        }
        return null;
    }
}
