package lancer.scene;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.contrat.Modele;
import lancer.contrat.Section;
import lancer.contrat.Variante;

/** Ce qu'un fichier de scène dit, une fois lu en entier. */
public final class SceneLue {

    public final List<Objet3D> objets = new ArrayList<>();
    public final List<Lampe> lampes = new ArrayList<>();
    public final Origines origines = new Origines();

    /** Les variantes présentes, chacune avec sa section, de ligne 0 si le fichier ne l'a pas. */
    public final Map<Variante, Section> variantes = new LinkedHashMap<>();

    /** Avertissements : une ligne pour chaque section que la lecture a laissée de côté. */
    public final List<String> avertissements = new ArrayList<>();

    /** Modèle où chaque variante est installée. @throws lancer.SceneFautive si l'une, ou deux ensemble, ne vont pas */
    public Modele getModele() {
        Modele modele = new Modele();
        variantes.forEach((variante, section) -> {
            variante.installer(section, modele);
            section.verifierCles();
        });
        return modele;
    }
}
