package lancer.contrat;

import java.util.Collections;
import java.util.List;

/**
 * Une variante du programme, dans un module à côté de la base. Elle met en œuvre un contrat ({@link Atmosphere},
 * {@link Specularite} ou {@link Echantillonnage}) et se fait connaître par une ligne du fichier
 * {@code META-INF/services/lancer.contrat.Variante}, où {@link java.util.ServiceLoader} la trouve.
 */
public interface Variante {

    /** Le type de sa section dans les fichiers de scène, par exemple {@code Brume}. */
    String getSection();

    /**
     * Pose ce que fait la variante.
     *
     * @param valeurs sa section, vide si la scène n'en a pas : chaque clé a donc une valeur par défaut. Une clé que
     *     cette méthode ne demande pas est refusée ensuite, comme inconnue.
     * @param modele celui d'une scène qui vient d'être lue
     * @throws lancer.SceneFautive si une valeur ne va pas
     */
    void installer(Section valeurs, Modele modele);

    /** Les clés de sa section que la fenêtre laisse régler ; sans elles, la variante s'y branche et s'y débranche. */
    default List<Parametre> getParametres() {
        return Collections.emptyList();
    }

    /**
     * Les réglages entre lesquels {@code --auto} peut choisir là où la scène n'a pas de section de cette variante, du
     * moins cher au plus juste, faits de {@code sienne} par {@link Section#sansFichier}.
     */
    default List<ReglagePropose> getReglagesProposes(Section sienne) {
        return Collections.emptyList();
    }
}
