/**
 * Le corrigé et le projet à compléter, d'un même texte, et l'écriture de ce projet.
 *
 * <p>Le corrigé est un programme du cours de plus : ses réponses sont comparées à celles de la base, classe par classe.
 * Rien n'y entre qui dépende d'un rendu.
 */
package lancer.correction.modele;
