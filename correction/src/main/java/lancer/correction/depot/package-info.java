/**
 * Lecture des rendus : noms et archives de Moodle, recherche des classes, codage, paquet, adaptation des paramètres.
 *
 * <p>Ce paquet n'exécute ni ne juge un rendu.
 */
package lancer.correction.depot;
