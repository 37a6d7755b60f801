/**
 * Pages HTML et tableau de la classe, pour l'enseignant et les étudiants.
 *
 * <p>Ce paquet ne juge ni ne note. Tout texte d'un étudiant passe par {@code Html}.
 */
package lancer.correction.page;
