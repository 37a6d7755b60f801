/**
 * Passage d'un fichier INI à une scène, ou à un refus d'une ligne qui situe la faute. Seul ce paquet connaît ini4j. Il
 * lit et observe les fichiers de scènes, et dit les octets où une place a changé ; il ne dessine ni n'écrit.
 */
package lancer.scene;
