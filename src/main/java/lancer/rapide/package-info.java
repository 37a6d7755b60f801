/**
 * Les objets qu'un rayon peut rencontrer, d'après leurs enveloppes, là où les demander tous serait trop long.
 *
 * <p>{@link Preparation} choisit ; {@link Regard} compare ensuite à tous les objets. {@link Structures} est construit
 * une fois pour tous les fils : {@link Enveloppes}, {@link Cellules}, {@link PointDeVue}, {@link Arbre}. Chaque fil a
 * une {@link Foule}, dont une {@link Question} lit pour chaque rayon les listes que lui donne une {@link Source}.
 */
package lancer.rapide;
