/**
 * Les interfaces que d'autres classes peuvent réaliser sans changer celles du cours : l'air, le reflet des lampes,
 * l'échantillonnage, la recherche du contact. S'y ajoutent celles qui déclarent une variante ou une forme. Ce paquet
 * n'en contient que la réalisation la plus simple, et ce qui situe leurs échecs. Il ne connaît ni fenêtre, ni fichier.
 */
package lancer.contrat;
