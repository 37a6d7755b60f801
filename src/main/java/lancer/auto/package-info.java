/**
 * {@code --auto} : essayer sur quelques milliers de pixels les réglages permis, choisir, et mesurer l'image faite.
 *
 * <p>Y entre ce qui estime une erreur ou un prix. Les variantes n'y sont connues que par les réglages qu'elles
 * proposent.
 */
package lancer.auto;
