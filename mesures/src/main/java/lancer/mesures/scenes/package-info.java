/**
 * Scènes à mesurer, par leur nom : livrées ou engendrées.
 *
 * <p>Ce paquet crée les scènes, sans rien mesurer.
 */
package lancer.mesures.scenes;
