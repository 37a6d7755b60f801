/**
 * La correction d'une classe : la ligne de commande, et ce qui mène des rendus aux pages et aux notes.
 *
 * <p>N'entre ici que ce qui enchaîne les autres paquets, ou que tous emploient : un étudiant de la classe, une panne.
 */
package lancer.correction;
