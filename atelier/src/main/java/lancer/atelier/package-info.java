/**
 * Outils dont les mesures et {@code make} se servent, et qui ne mesurent rien : des scènes engendrées, des fichiers CSV, et ce qui écrit
 * les pages et les images du projet.
 *
 * <p>Y entre ce qui fait un fichier, ou une scène trop grande pour être gardée. Rien d'ici n'est dans le programme.
 */
package lancer.atelier;
