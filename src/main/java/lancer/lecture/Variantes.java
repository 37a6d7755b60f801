package lancer.lecture;

import java.util.ArrayList;
import java.util.List;
import lancer.Scene;
import lancer.contrat.Section;
import lancer.contrat.Variante;

/** Les variantes présentes dans le chemin des classes. */
public final class Variantes {

    private Variantes() {
    }

    /**
     * Installe dans la scène toutes les variantes présentes, chacune avec sa section du fichier lu.
     *
     * @return les variantes que le fichier laisse libres : il n'a pas de section pour elles
     * @throws lancer.SceneFautive si une section est fautive, ou si deux variantes veulent le même contrat
     */
    public static List<Variante> installer(LecteurScene lu, Scene scene) {
        List<Variante> libres = new ArrayList<>();
        for (Variante variante : lu.getServices().variantes()) {
            Section section = lu.section(variante.getSection());
            variante.installer(section, scene);
            section.verifierCles();
            if (!section.estDonnee()) {
                libres.add(variante);
            }
        }
        return libres;
    }

    /** Les noms des variantes au travail, pour le titre d'une fenêtre. */
    public static List<String> noms() {
        List<String> noms = new ArrayList<>();
        for (Variante variante : new Services().variantes()) {
            noms.add(variante.getSection());
        }
        return noms;
    }
}
