/**
 * Façon de lancer une machine virtuelle sans réseau ni disque, la surveiller du dehors, et l'arrêter.
 *
 * <p>Rien n'y entre qui sache ce qu'on lui demande de calculer.
 */
package lancer.correction.isolement;
