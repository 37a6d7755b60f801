/** {@code make mesures} : temps et erreur des réglages du programme, vérifiés, en tableaux et en courbes. */
package lancer.mesures.vitesse;
