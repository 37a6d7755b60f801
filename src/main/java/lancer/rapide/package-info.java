/**
 * Les objets qu'un rayon peut rencontrer, d'après leurs enveloppes. Des masques pour une petite scène ; pour une foule,
 * des cartes de directions et un arbre. Les boucles de {@link lancer.Scene} demandent sa distance à chaque objet proposé.
 */
package lancer.rapide;
