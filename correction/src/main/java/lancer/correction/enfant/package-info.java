/**
 * Programmes qui s'exécutent dans une autre machine virtuelle, avec le code d'un étudiant : le compilateur, l'exécution, et leurs messages.
 *
 * <p>Un rendu peut voir ce paquet : il ne connaît ni le corrigé, ni les notes, ni un autre paquet de la correction.
 */
package lancer.correction.enfant;
