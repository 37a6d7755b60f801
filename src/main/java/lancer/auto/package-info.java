/**
 * {@code --auto} essaie sur quelques pixels les réglages permis, en choisit un, puis mesure l'erreur de l'image.
 *
 * <p>Ce paquetage estime des erreurs et des prix. Il connaît les variantes par les réglages qu'elles proposent.
 */
package lancer.auto;
