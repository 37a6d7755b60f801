package lancer.contrat;

import lancer.Objet3D;

/**
 * Un type d'objet qu'un fichier de scène peut contenir, par exemple
 * {@code class Plan extends Objet3D implements Forme}. Sa classe est nommée dans
 * {@code META-INF/services/lancer.contrat.Forme} de la base ou d'une variante. {@link java.util.ServiceLoader} en crée
 * un premier objet, sans valeurs, qui ne sert qu'à lire les autres.
 */
public interface Forme {

    /** Le type de ses sections dans les fichiers de scène, par exemple {@code Plan}. */
    String getSection();

    /** Les clés que lit {@link #lire} ; toute autre est refusée, sauf celles de la matière. */
    String[] getCles();

    /**
     * Lit un objet.
     *
     * @param valeurs une de ses sections, qui refuse les valeurs hors de leurs limites
     * @return un objet neuf
     * @throws lancer.SceneFautive si une valeur est refusée ; voir {@link Section#fautive}
     */
    Objet3D lire(Section valeurs);
}
