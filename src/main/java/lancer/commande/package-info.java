/** La ligne de commande : options, réglages, messages, statuts. Ce paquet ne lit pas de scène, ne dessine pas. */
package lancer.commande;
