/**
 * Ce qui mesure la base et les variantes : scènes, erreur d'une image, promesses de {@code --auto}.
 *
 * <p>Y entre ce dont plusieurs mesures se servent. Rien d'ici n'est dans le programme, et rien du programme n'en
 * dépend.
 */
package lancer.mesures;
