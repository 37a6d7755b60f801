/**
 * Travaux rendus par les étudiants, retrouvés et lus : les noms et les archives de Moodle, les classes où qu'ils les aient mises, le
 * codage, le paquet et les paramètres remis comme on les attend.
 *
 * <p>Rien n'y entre qui exécute un rendu, ni qui le juge.
 */
package lancer.correction.depot;
