package lancer.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Origine de chaque objet et de chaque lampe d'un fichier : le nom de sa section, et sa ligne. */
public final class Origines {

    private final List<Object> choses = new ArrayList<>();
    private final List<String> noms = new ArrayList<>();
    private int[] lignes = new int[16];

    /** @param ligne celle des crochets */
    void ajouter(Object chose, String nom, int ligne) {
        if (choses.size() == lignes.length) {
            lignes = Arrays.copyOf(lignes, 2 * lignes.length);
        }
        lignes[choses.size()] = ligne;
        choses.add(chose);
        noms.add(nom);
    }

    /** Texte de la forme {@code [Sphere ambre] ligne 52} ; {@code null} si cet objet ne vient pas d'un fichier. */
    public String de(Object chose) {
        for (int k = 0; k < choses.size(); k++) {
            if (choses.get(k) == chose) {
                return "[" + noms.get(k) + "] ligne " + lignes[k];
            }
        }
        return null;
    }
}
