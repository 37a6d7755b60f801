/** Lire un nombre, l'écrire comme dans une scène, citer un mot. Ce paquet ne connaît ni les scènes, ni les images. */
package lancer.texte;
