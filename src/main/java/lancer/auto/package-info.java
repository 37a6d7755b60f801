/**
 * {@code --auto} essaie des réglages sur quelques pixels, en choisit un, puis mesure l'erreur de l'image. Ce paquet ne
 * connaît des variantes que les réglages qu'elles proposent.
 */
package lancer.auto;
