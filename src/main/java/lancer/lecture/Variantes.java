package lancer.lecture;

import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;
import lancer.Scene;
import lancer.contrat.Variante;

/** Les variantes présentes dans le chemin des classes. */
public final class Variantes {

    private final List<Variante> presentes = new ArrayList<>();

    Variantes() {
        for (Variante variante : ServiceLoader.load(Variante.class, Variantes.class.getClassLoader())) {
            presentes.add(variante);
        }
    }

    boolean lisent(String type) {
        for (Variante variante : presentes) {
            if (Texte.memeMot(variante.getSection(), type)) {
                return true;
            }
        }
        return false;
    }

    List<String> getSections() {
        List<String> sections = new ArrayList<>();
        for (Variante variante : presentes) {
            sections.add(variante.getSection());
        }
        return sections;
    }

    /**
     * Installe dans la scène toutes les variantes présentes, chacune avec sa section du fichier lu.
     *
     * @return les variantes que le fichier laisse libres : il n'a pas de section pour elles
     * @throws lancer.SceneFautive si une section est fautive, ou si deux variantes veulent le même contrat
     */
    public static List<Variante> installer(LecteurScene lu, Scene scene) {
        List<Variante> libres = new ArrayList<>();
        for (Variante variante : lu.getVariantes().presentes) {
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
        return new Variantes().getSections();
    }
}
