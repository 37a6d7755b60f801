/**
 * Ce qui est demandé ({@link lancer.dessin.Demande}), ce qui en est dessiné ({@link lancer.dessin.Dessin}), ce
 * qui en est dit ({@link lancer.dessin.Rapport}), et le programme sans fenêtre.
 */
package lancer.dessin;
