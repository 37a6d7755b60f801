/**
 * Explication de la couleur d'un pixel : la suite de ses contacts, que les classes du cours notent en la calculant. Ce
 * paquet ne calcule aucune couleur.
 */
package lancer.inspection;
