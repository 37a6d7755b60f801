/**
 * Passage d'un fichier INI à une scène, ou au refus d'une ligne qui dit où est la faute. Le seul paquet qui connaisse
 * ini4j.
 *
 * <p>Y entre ce qui juge un texte : lignes, sections, nombres, et ce qui dit qu'il a changé ; rien de ce qu'on
 * fait de la scène ensuite.
 */
package lancer.scene;
