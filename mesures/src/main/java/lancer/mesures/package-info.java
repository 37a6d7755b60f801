/**
 * Mesure de la base et des variantes : erreur d'une image, intervalle de confiance d'une valeur.
 *
 * <p>Ce paquet contient ce que plusieurs mesures utilisent. Le programme ne dépend pas de ce module.
 */
package lancer.mesures;
