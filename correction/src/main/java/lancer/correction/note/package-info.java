/**
 * Passage des jugements aux points : le barème, la note d'un rendu, la feuille de notes de Moodle.
 *
 * <p>Ce paquet ne juge pas : avec un autre barème, les mêmes jugements donnent d'autres notes.
 */
package lancer.correction.note;
