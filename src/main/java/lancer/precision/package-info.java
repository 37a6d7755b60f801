/**
 * Calculs justes quand la formule ordinaire ne l'est pas : différence de deux carrés voisins, longueur extrême. Chaque
 * méthode d'ici dit sa borne d'erreur, ou pourquoi elle n'en a pas.
 */
package lancer.precision;
