/**
 * {@code make juge} : les mêmes scènes par POV-Ray, et la cause de chaque pixel qui diffère.
 *
 * <p>Le seul paquet qui connaisse un autre lanceur de rayons ; rien n'y entre qui dessine par le nôtre autrement
 * que lui.
 */
package lancer.mesures.juge;
