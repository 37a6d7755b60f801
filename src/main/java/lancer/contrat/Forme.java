package lancer.contrat;

import lancer.Objet3D;

/**
 * Une sorte d'objets qu'un fichier de scène peut nommer, par exemple {@code class Plan extends Objet3D implements
 * Forme}, inscrite dans {@code META-INF/services/lancer.contrat.Forme} de la base ou d'une variante ;
 * {@link java.util.ServiceLoader} en fait un premier objet, sans valeurs, qui ne sert qu'à lire les autres.
 */
public interface Forme {

    /** Le type de ses sections dans les fichiers de scène, par exemple {@code Plan}. */
    String getSection();

    /** Les clés que demande {@link #lire}, les seules permises avec celles de la matière. */
    String[] getCles();

    /**
     * Lit un objet.
     *
     * @param valeurs une de ses sections, qui refuse les valeurs hors de leurs limites
     * @return un objet neuf
     * @throws lancer.SceneFautive si une valeur ne va pas ; voir {@link Section#fautive}
     */
    Objet3D lire(Section valeurs);
}
