/**
 * Scènes que l'on mesure, par leur nom : livrées, engendrées ou tirées au sort.
 *
 * <p>Y entre ce qui fait une scène, sans rien en mesurer.
 */
package lancer.mesures.scenes;
