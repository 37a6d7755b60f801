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

/** Le contenu d'un fichier de scène. */
public final class SceneLue {

    public final List<Objet3D> objets = new ArrayList<>();
    public final List<Lampe> lampes = new ArrayList<>();
    public final Origines origines;

    /** Les variantes présentes, chacune avec sa section ; la ligne est 0 si le fichier n'a pas cette section. */
    public final Map<Variante, Section> variantes = new LinkedHashMap<>();

    /** Avertissements : une ligne pour chaque section que la lecture a ignorée. */
    public final List<String> avertissements = new ArrayList<>();

    SceneLue() {
        origines = new Origines();
    }

    /** La même scène, où {@code nouveau} remplace un objet ou une lampe. */
    public SceneLue(SceneLue autre, Object ancien, Object nouveau) {
        objets.addAll(autre.objets);
        lampes.addAll(autre.lampes);
        objets.replaceAll(objet -> objet == ancien ? (Objet3D) nouveau : objet);
        lampes.replaceAll(lampe -> lampe == ancien ? (Lampe) nouveau : lampe);
        variantes.putAll(autre.variantes);
        avertissements.addAll(autre.avertissements);
        origines = new Origines(autre.origines, ancien, nouveau);
    }

    /** Modèle où chaque variante est installée. @throws lancer.SceneFautive si une section est refusée */
    public Modele getModele() {
        Modele modele = new Modele();
        variantes.forEach((variante, section) -> {
            variante.installer(section, modele);
            section.verifierCles();
        });
        return modele;
    }
}
