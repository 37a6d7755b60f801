/**
 * Les classes du cours : objets, éclairage, algorithme, programme. Un étudiant lit et modifie ici les équations. Ce
 * paquet ne contient que les classes que le cours nomme, et celles qu'il faut pour suivre un rayon pas à pas.
 *
 * <p>Le module {@code correction} contient un second programme du cours, écrit d'après l'énoncé. Un test les compare.
 */
package lancer;
