package lancer.contrat;

import java.util.Collections;
import java.util.List;
import java.util.Map;

/**
 * Une variante du programme, dans un module à côté de la base. Elle réalise un contrat ({@link Atmosphere},
 * {@link Specularite} ou {@link Echantillonnage}). Sa classe est nommée dans le fichier
 * {@code META-INF/services/lancer.contrat.Variante}, que lit {@link java.util.ServiceLoader}.
 */
public interface Variante {

    /** Le type de sa section dans les fichiers de scène, par exemple {@code Brume}. */
    String getSection();

    /**
     * Choisit ce que la variante change dans le modèle.
     *
     * @param valeurs sa section, vide si la scène n'en a pas : chaque clé a donc une valeur par défaut. Une clé que
     *     cette méthode ne lit pas est refusée comme inconnue.
     * @param modele les choix dont sera fait celui d'une scène qui vient d'être lue
     * @throws lancer.SceneFautive si une valeur est refusée
     */
    void installer(Section valeurs, Modele.Construction modele);

    /** Les clés que la fenêtre peut régler. Même sans clé, la fenêtre peut brancher et débrancher la variante. */
    default List<Parametre> getParametres() {
        return Collections.emptyList();
    }

    /**
     * Les sections que {@code --auto} essaie si la scène n'en a pas de cette variante, du moins cher au plus juste.
     * Chacune va avec un seuil des reflets, qui ajoute peu à l'erreur de cette section. Elles sont créées à partir de
     * {@code section} par {@link Section#sansFichier}.
     */
    default Map<Section, Double> getSectionsProposees(Section section) {
        return Collections.emptyMap();
    }

    /** Le nom court d'une section proposée, différent de celui des autres, par exemple {@code partage 16/0.03}. */
    default String getNomCourt(Section proposee) {
        return proposee.toString();
    }
}
