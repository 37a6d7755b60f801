/**
 * Lancement, surveillance et arrêt d'une machine virtuelle sans réseau ni disque.
 *
 * <p>Ce paquet ne connaît pas le contenu des demandes.
 */
package lancer.correction.isolement;
