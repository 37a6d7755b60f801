/** Ce qui se voit : chaque vue montre un état, et dit ce qu'on lui fait. Seul le cadre en connaît d'autres. */
package lancer.fenetre.vue;
