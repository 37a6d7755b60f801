/**
 * Jugement d'un rendu : vérifications, avec toutes les classes puis chaque classe seule avec celles du corrigé ; image ; variantes ;
 * références.
 *
 * <p>Ce paquet ne connaît ni les points, ni les pages : un jugement gardé sert à tout barème.
 */
package lancer.correction.jugement;
