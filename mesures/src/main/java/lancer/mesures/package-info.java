/**
 * Mesure de la base et des variantes : l'erreur d'une image, l'intervalle d'une mesure.
 *
 * <p>Y entre ce dont plusieurs mesures se servent. Rien d'ici n'est dans le programme, et rien du programme n'en
 * dépend.
 */
package lancer.mesures;
