/** Ce qui peut échouer dans le système : un fichier, écrit en entier ou pas du tout ; un échec, dit en une ligne. */
package lancer.systeme;
