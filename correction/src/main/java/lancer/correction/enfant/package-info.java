/**
 * Programmes qui tournent dans une machine virtuelle à part, près du code d'un étudiant : le compilateur, l'exécution, et la façon dont
 * l'un et l'autre répondent.
 *
 * <p>N'y entre que ce qu'on peut laisser voir à un rendu : rien qui connaisse le corrigé, les notes, ni un autre paquet d'ici.
 */
package lancer.correction.enfant;
