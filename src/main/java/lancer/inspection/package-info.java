/**
 * Explication de la couleur d'un pixel : la chaîne de ses contacts, telle que les classes du cours la disent en le
 * calculant, et le récit qu'on en fait.
 *
 * <p>Rien n'y entre qui calcule une couleur : chaque nombre vient de la classe qui l'a trouvé.
 */
package lancer.inspection;
