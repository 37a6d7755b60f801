/**
 * Ce qui mesure la base et les variantes : scènes engendrées, erreur d'une image, temps, banc d'essai, fautes mises
 * exprès.
 *
 * <p>Y entre ce dont plusieurs mesures se servent. Rien d'ici n'est dans le programme, et rien du programme n'en
 * dépend.
 */
package lancer.mesures;
