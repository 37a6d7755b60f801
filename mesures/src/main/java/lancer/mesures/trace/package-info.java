/**
 * Courbes, barres et vignettes, en PNG. Seul ce paquet connaît JFreeChart.
 *
 * <p>Ce paquet ne connaît pas le sens des nombres qu'il montre.
 */
package lancer.mesures.trace;
