/** La ligne de commande : options, aide, messages, statuts de sortie. Ce paquet ne lit pas de scène, ne dessine pas. */
package lancer.commande;
