/**
 * {@code make juge} : les mêmes scènes dessinées par POV-Ray, et les deux images comparées pixel par pixel.
 *
 * <p>Seul ce paquet connaît un autre lanceur de rayons.
 */
package lancer.mesures.juge;
