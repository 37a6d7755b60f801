/**
 * {@code make noyaux} : le temps d'une intersection, selon la méthode et le régime, par JMH.
 *
 * <p>Le seul paquet qui connaisse JMH ; y entre ce qui se compte en nanosecondes.
 */
package lancer.mesures.noyaux;
