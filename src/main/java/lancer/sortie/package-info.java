/**
 * Où va l'image : en mémoire, dans un fichier PNG ou PFM ;
 * d'où en revient une autre, pour les comparer ; et ce qu'elle a coûté.
 *
 * <p>N'y entre rien qui décide d'une couleur.
 */
package lancer.sortie;
