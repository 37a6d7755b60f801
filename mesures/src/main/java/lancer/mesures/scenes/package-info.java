/**
 * Scènes à mesurer, par leur nom : livrées, engendrées ou aléatoires.
 *
 * <p>Ce paquet crée les scènes, sans rien mesurer.
 */
package lancer.mesures.scenes;
