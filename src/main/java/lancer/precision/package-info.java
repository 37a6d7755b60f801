/**
 * Calculs justes quand la formule ordinaire ne l'est pas : différence de deux carrés voisins, longueur extrême. Chaque
 * méthode donne sa borne d'erreur, ou dit pourquoi elle n'en a pas.
 */
package lancer.precision;
