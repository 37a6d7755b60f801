/** Le reflet de Blinn : une variante qui ne change que le reflet des lampes. Elle n'utilise aucune autre variante. */
package lancer.blinn;
