/**
 * L'équipe de fils qui dessine et qui prépare : des tâches numérotées, leur partage, leur arrêt, leur échec.
 * N'entre ici que ce qui ne sait rien de ce que font ces tâches.
 */
package lancer.fils;
