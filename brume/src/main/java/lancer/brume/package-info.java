/** La brume de distance : une variante qui ne change que l'air. Elle n'utilise aucune autre variante. */
package lancer.brume;
