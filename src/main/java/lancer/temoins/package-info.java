/**
 * Les pixels témoins, qui jugent la recherche rapide par les boucles du cours, et le dessin qu'ils surveillent.
 *
 * <p>N'y entre rien qui réponde à la place de ce qui est jugé.
 */
package lancer.temoins;
