/**
 * Le dessin en plusieurs fils : partage de l'image, arrêt, avancement, échecs. La préparation et les essais l'utilisent
 * aussi. Ce paquet ne connaît ni la recherche d'un contact, ni la destination des pixels.
 */
package lancer.fils;
