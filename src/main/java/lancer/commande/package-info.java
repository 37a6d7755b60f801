/**
 * La ligne de commande : ce qui est demandé, l'aide, et ce que dit le programme quand il ne peut pas.
 *
 * <p>Rien n'y entre qui lise une scène ou dessine.
 */
package lancer.commande;
