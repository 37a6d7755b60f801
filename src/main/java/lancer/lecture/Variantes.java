package lancer.lecture;

import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;
import lancer.Scene;
import lancer.contrat.Variante;

/**
 * Les variantes présentes dans le chemin des classes. Elles sont cherchées dans un fil à part : Java fouille aussi ses
 * propres modules, ce qui prend 8 ms, pendant lesquelles la scène se lit.
 */
public final class Variantes implements Runnable {

    private List<Variante> presentes;

    Variantes() {
        Thread avance = new Thread(this, "lancer-variantes");
        avance.setDaemon(true);
        avance.start();
    }

    @Override
    public void run() {
        try {
            presentes();
        } catch (RuntimeException | Error e) {
            // celui qui les demandera cherchera à son tour, et le dira
        }
    }

    private synchronized List<Variante> presentes() {
        if (presentes == null) {
            List<Variante> trouvees = new ArrayList<>();
            for (Variante variante : ServiceLoader.load(Variante.class, Variantes.class.getClassLoader())) {
                trouvees.add(variante);
            }
            presentes = trouvees;
        }
        return presentes;
    }

    boolean lisent(String type) {
        for (Variante variante : presentes()) {
            if (Texte.memeMot(variante.getSection(), type)) {
                return true;
            }
        }
        return false;
    }

    List<String> getSections() {
        List<String> sections = new ArrayList<>();
        for (Variante variante : presentes()) {
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
        for (Variante variante : lu.getVariantes().presentes()) {
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
