/**
 * La fenêtre Swing : image, avancement, menus, fichiers ouverts et surveillés. Seul ce paquet connaît Swing et AWT.
 * {@code Fenetre} contient l'affichage, et {@code Controleur} la suite des dessins. {@code --image} ne le charge pas.
 */
package lancer.fenetre;
