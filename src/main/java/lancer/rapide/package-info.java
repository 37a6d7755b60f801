/**
 * Recherches rapides du premier contact d'un rayon et des objets qui cachent une lampe : masques, cartes, grille,
 * arbre. Leurs réponses sont celles des boucles du cours, au bit près. Pour leur compilation, voir docs/etendre.md.
 */
package lancer.rapide;
