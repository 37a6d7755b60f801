/**
 * Le programme qui s'exécute dans une autre machine virtuelle avec le code d'un étudiant, et ses messages.
 *
 * <p>Un rendu peut voir ce paquet : il ne connaît ni le corrigé, ni les notes, ni un autre paquet de la correction.
 */
package lancer.correction.enfant;
