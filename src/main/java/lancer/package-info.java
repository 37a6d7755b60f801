/**
 * Le cours : ses classes, l'algorithme, le programme. C'est ici qu'un étudiant lit et modifie les équations.
 *
 * <p>N'y entre que ce que le cours nomme, ou ce qu'il faut rencontrer pour le suivre pas à pas ; tout autre souci a
 * son paquet.
 *
 * <p>Le module {@code correction} a un second programme du cours, écrit d'après le seul énoncé : un essai les compare.
 */
package lancer;
