/**
 * Des jugements aux points : le barème de l'enseignant, la note d'un rendu, la feuille de notes de Moodle.
 *
 * <p>Rien n'y entre qui juge : d'un autre barème, les mêmes jugements font une autre note.
 */
package lancer.correction.note;
