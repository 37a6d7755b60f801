/**
 * Figures de la fenêtre : les rayons d'un pixel sur l'image, leur vue de côté, le graphique des réglages. Ce paquet ne
 * connaît pas la fenêtre et ne dessine pas de scène.
 */
package lancer.fenetre.vue.figures;
