/**
 * Nombres et figures des pages du projet.
 *
 * <p>Ce paquet réécrit une page, ou dessine une figure qui n'est pas une courbe.
 */
package lancer.mesures.pages;
