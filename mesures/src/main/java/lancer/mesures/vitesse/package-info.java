/**
 * {@code make mesures} : ce que coûte une image meilleure, mesuré, vérifié, mis en tables et en courbes.
 *
 * <p>Y entre ce qui mesure un dessin entier, ou dit ce qu'on en conclut.
 */
package lancer.mesures.vitesse;
