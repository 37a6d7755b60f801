/**
 * Les promesses qui se remplacent sans toucher aux classes du cours : l'air, le reflet des lampes, où regarder dans un
 * pixel, la recherche du contact ; et par quoi une variante ou une forme se fait connaître.
 *
 * <p>N'y entrent que des promesses, et la plus simple façon de tenir chacune. Un contrat parle des
 * classes du cours ; il ne connaît ni fenêtre, ni fichier, ni recherche rapide.
 */
package lancer.contrat;
