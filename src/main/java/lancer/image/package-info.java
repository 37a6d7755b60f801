/**
 * Images en mémoire, écriture en PNG et en PFM, lecture et comparaison. Ce paquet ne connaît ni les scènes, ni le
 * calcul des couleurs.
 */
package lancer.image;
