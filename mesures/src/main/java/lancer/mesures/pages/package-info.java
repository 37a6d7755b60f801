/**
 * Nombres et figures que montrent les pages du projet.
 *
 * <p>Y entre ce qui réécrit une page, ou une figure qui n'est pas une courbe.
 */
package lancer.mesures.pages;
