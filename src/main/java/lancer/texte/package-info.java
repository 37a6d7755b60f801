/**
 * Nombres et messages : lire un nombre, l'écrire comme une scène l'écrit, citer un mot.
 *
 * <p>N'y entre rien qui sache ce qu'est une scène ou une image.
 */
package lancer.texte;
