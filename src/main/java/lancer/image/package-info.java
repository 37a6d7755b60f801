/**
 * Destinations de l'image : en mémoire, dans un fichier PNG ou PFM ; d'où en revient une autre, pour les comparer.
 *
 * <p>N'y entre rien qui sache ce qu'est une scène, ni qui décide d'une couleur.
 */
package lancer.image;
