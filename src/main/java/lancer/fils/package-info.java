/**
 * Les fils : partage d'un travail, arrêt, avancement, échecs. Ce paquet ne sait ni chercher un contact, ni peindre.
 */
package lancer.fils;
