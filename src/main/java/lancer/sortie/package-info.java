/**
 * Où va l'image : en mémoire, dans un fichier PNG ou PFM, dans une fenêtre ; et ce qu'elle a coûté.
 *
 * <p>N'y entre rien qui décide d'une couleur.
 */
package lancer.sortie;
