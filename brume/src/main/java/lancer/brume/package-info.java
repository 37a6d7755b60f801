/**
 * La brume de distance : une variante, qui ne change que l'air.
 *
 * <p>N'y entre que ce qui sert à la brume ; une variante connaît la base, jamais une autre variante.
 */
package lancer.brume;
