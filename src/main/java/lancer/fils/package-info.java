/**
 * Le dessin en plusieurs fils : le partage de l'image, l'arrêt, l'avancement, les comptes ; et l'équipe de fils, qui
 * sert aussi à préparer et à essayer.
 *
 * <p>N'y entre rien qui sache comment un rayon trouve son objet, ni où vont les pixels.
 */
package lancer.fils;
