/**
 * Le reflet de Blinn : une variante, qui ne change que le reflet des lampes.
 *
 * <p>N'y entre que ce qui sert à ce reflet ; une variante connaît la base, jamais une autre variante.
 */
package lancer.blinn;
