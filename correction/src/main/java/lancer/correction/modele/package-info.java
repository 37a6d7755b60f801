/**
 * Le corrigé et le projet à compléter, d'un même texte, et l'écriture de ce projet.
 *
 * <p>Rien n'y entre qui dépende d'un rendu.
 */
package lancer.correction.modele;
