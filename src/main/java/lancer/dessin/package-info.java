/**
 * Ce qui est demandé ({@link lancer.dessin.Demande}), ce qui en est dessiné ({@link lancer.dessin.Dessin}), et le
 * programme sans fenêtre.
 */
package lancer.dessin;
