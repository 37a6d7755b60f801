/** Exactitude de plusieurs méthodes de calcul d'un contact, par régime, comparées à un calcul exact. */
package lancer.mesures.stabilite;
