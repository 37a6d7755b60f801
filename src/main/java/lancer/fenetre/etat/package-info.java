/**
 * Ce que montre la fenêtre, et ce qui le change, sans AWT ni Swing. {@code Etat} est tout ce qui se voit ou se perd.
 * {@code Suite} rend, d'un état et de ce qui arrive, l'état suivant et les ordres à exécuter. {@code Executant} est ce
 * qui les exécute, et répond par d'autres événements.
 */
package lancer.fenetre.etat;
