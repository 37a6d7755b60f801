/**
 * {@code make juge} : les mêmes scènes par POV-Ray, et les deux images comparées pixel par pixel.
 *
 * <p>Le seul paquet qui connaisse un autre lanceur de rayons ; rien n'y entre qui dessine par le nôtre autrement
 * que lui.
 */
package lancer.mesures.juge;
