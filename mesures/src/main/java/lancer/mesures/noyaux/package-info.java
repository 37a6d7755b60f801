/**
 * {@code make noyaux} : le temps d'une intersection, d'une recherche, d'un éclairement, par JMH.
 *
 * <p>Le seul paquet qui connaisse JMH ; y entre ce qui se compte en nanosecondes.
 */
package lancer.mesures.noyaux;
