package lancer.contrat;

import java.util.List;

/** Une variante qui change l'{@link Echantillonnage}, et dont {@code --auto} peut choisir les réglages. */
public interface Reglable extends Variante {

    /**
     * Les réglages entre lesquels choisir là où la scène n'a pas de section de cette variante : des sections pour
     * {@link #installer}, qui ne diffèrent que par la précision et le prix. Les moins chers d'abord, à peu près : dès
     * qu'un réglage convient, ceux qui sont loin derrière lui ne sont plus essayés.
     *
     * @see Section#reglage
     */
    List<Section> getReglages();
}
