/** Nombres des pages du projet : ce paquet réécrit une page d'après les mesures. */
package lancer.mesures.pages;
