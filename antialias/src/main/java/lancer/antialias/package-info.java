/** L'anticrénelage : une variante qui ne change que le choix des points d'un pixel, sans autre variante. */
package lancer.antialias;
