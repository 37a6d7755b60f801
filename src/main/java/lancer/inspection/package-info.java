/** Explication de la couleur d'un pixel, d'après ses contacts. Ce paquet ne calcule aucune couleur. */
package lancer.inspection;
