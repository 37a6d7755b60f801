/** Les objets qu'un rayon peut rencontrer, d'après leurs enveloppes, dans une scène de plus de quinze objets. */
package lancer.rapide;
