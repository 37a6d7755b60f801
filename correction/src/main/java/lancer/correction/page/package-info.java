/**
 * Pages HTML et tableau de la classe, pour l'enseignant et les étudiants.
 *
 * <p>Ce paquet ne juge ni ne note. Les gabarits échappent tout texte d'un étudiant.
 */
package lancer.correction.page;
