/** Ce que la fenêtre fait faire dans d'autres fils : lire, dessiner, écrire, mesurer, observer le fichier. */
package lancer.fenetre.moteur;
