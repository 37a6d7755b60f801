/**
 * Figures que la fenêtre peint de nombres : les rayons d'un pixel, leur vue de côté, le front.
 *
 * <p>N'y entre rien qui connaisse la fenêtre, ni qui dessine une scène.
 */
package lancer.fenetre.figures;
