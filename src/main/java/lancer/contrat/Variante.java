package lancer.contrat;

import java.util.Collections;
import java.util.List;

/**
 * Une variante du programme, dans un module à côté de la base. Elle met en œuvre un contrat ({@link Atmosphere},
 * {@link Specularite} ou {@link Echantillonnage}) et se fait connaître par une ligne du fichier
 * {@code META-INF/services/lancer.contrat.Variante} ; {@link java.util.ServiceLoader} la trouve, et la base n'en sait
 * rien de plus.
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

    /**
     * Les réglages entre lesquels {@code --auto} peut choisir là où la scène n'a pas de section de cette variante : des
     * sections pour {@link #installer}, qui ne diffèrent que par la précision et le prix de l'{@link Echantillonnage}
     * qu'elles posent. Les moins chers d'abord, à peu près : dès qu'un réglage convient, ceux qui sont loin derrière
     * lui ne sont plus essayés. Aucun par défaut : il n'y a alors rien à choisir.
     *
     * @see Section#reglage
     */
    default List<Section> getReglages() {
        return Collections.emptyList();
    }
}
