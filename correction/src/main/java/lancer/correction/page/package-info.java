/**
 * Pages que lisent l'enseignant et l'étudiant : les pages HTML, et le tableau de la classe.
 *
 * <p>Rien n'y entre qui juge ou qui note ; tout texte venu d'un étudiant y passe par {@code Html}.
 */
package lancer.correction.page;
