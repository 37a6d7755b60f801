/**
 * Questions que l'on pose à un rendu et ce qu'on en trouve : les vérifications, classes ensemble puis chacune seule parmi celles du
 * corrigé, l'image, les variantes, et les références à qui l'on compare.
 *
 * <p>Y entre une vérification, ou ce qu'elle a donné ; ni points ni page, de sorte qu'un jugement gardé sert à tout barème.
 */
package lancer.correction.jugement;
