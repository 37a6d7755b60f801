/**
 * Ce qui peut changer sans toucher aux classes du cours : l'air, le reflet des lampes, où regarder dans un pixel,
 * la recherche du contact, et par quoi une variante les remplace.
 *
 * <p>N'y entrent que des promesses, la plus simple façon de tenir chacune, et de quoi nommer qui ne les tient pas. Un
 * contrat parle des classes du cours ; il ne connaît ni fenêtre, ni fichier, ni recherche rapide.
 */
package lancer.contrat;
