/**
 * L'anticrénelage : une variante, qui ne change que les endroits d'un pixel où l'on regarde.
 *
 * <p>N'y entrent que les façons de prendre plusieurs rayons par pixel ; une variante connaît la base, jamais une
 * autre variante.
 */
package lancer.antialias;
