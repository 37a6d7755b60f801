/**
 * Le corrigé et le projet à compléter, tirés d'un même texte, et l'écriture de ce projet.
 *
 * <p>Le corrigé est un second programme du cours : ses réponses sont comparées à celles de la base, classe par classe. Ce paquet ne dépend
 * d'aucun rendu.
 */
package lancer.correction.modele;
