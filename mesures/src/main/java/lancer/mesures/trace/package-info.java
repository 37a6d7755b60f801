/**
 * Des courbes, des barres et des vignettes, sur une planche, en PNG. Le seul paquet qui connaisse JFreeChart.
 *
 * <p>N'y entre rien qui sache ce que montrent les nombres.
 */
package lancer.mesures.trace;
