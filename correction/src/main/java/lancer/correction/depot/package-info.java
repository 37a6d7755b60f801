/**
 * Lecture des rendus : les lignes d'une classe, les archives, les classes, leur codage et leur paquet, leur compilation.
 *
 * <p>Ce paquet n'exécute ni ne juge un rendu ; ses sources se lisent et se compilent dans une autre machine virtuelle.
 */
package lancer.correction.depot;
