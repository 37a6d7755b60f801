/**
 * L'image dans une fenêtre Swing : dessin, progression, menus, fichiers ouverts et surveillés. Le seul paquet qui
 * connaisse Swing et AWT. Ce qui se voit est dans {@code Fenetre}, la vie d'un dessin dans {@code Controleur}.
 *
 * <p>N'y entre rien qui calcule une couleur ; jamais chargé avec {@code --image}.
 */
package lancer.fenetre;
