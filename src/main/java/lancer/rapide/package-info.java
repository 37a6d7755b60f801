/**
 * La même image, au bit près, plus vite : ce que la recherche simple trouve par des boucles, trouvé par des cartes,
 * une grille ou un arbre, et les mêmes équations sur des nombres, sans allouer.
 *
 * <p>Rien n'y entre qui change un pixel, ni qui sache d'où vient la scène ou où va l'image.
 */
package lancer.rapide;
