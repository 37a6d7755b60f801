/**
 * Les étapes communes à la fenêtre et à la ligne de commande : lire une scène, la régler, la préparer, la dessiner. Ce
 * paquet ne connaît ni les formats de fichiers d'images, ni la fenêtre.
 */
package lancer.dessin;
