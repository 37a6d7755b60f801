/**
 * Chemin du fichier de scène à l'image : lire, régler, préparer, dessiner, pour la fenêtre et la ligne de commande.
 *
 * <p>N'y entre rien qui sache ce qu'est un octet d'image, ni une fenêtre.
 */
package lancer.dessin;
