/**
 * Ce que {@code make} lance et qui ne mesure rien : des scènes engendrées, et ce qui écrit les pages et les images du projet.
 *
 * <p>Y entre ce qui fait un fichier du projet, ou une scène trop grande pour y être. Rien d'ici n'est dans le programme.
 */
package lancer.atelier;
