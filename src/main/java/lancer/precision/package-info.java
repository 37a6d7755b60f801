/**
 * Les réponses justes là où la formule ordinaire ne l'est pas : différence de carrés qui s'annule, longueur extrême.
 *
 * <p>N'y entre rien qui ne porte pas sa borne d'erreur, ou la raison d'un écart qui n'en a pas.
 */
package lancer.precision;
