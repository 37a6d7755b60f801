/**
 * Régimes où les façons de calculer un contact se trompent, et de combien : chacune contre un calcul exact.
 *
 * <p>Y entre une méthode à juger, ou une famille de cas où la juger.
 */
package lancer.mesures.stabilite;
