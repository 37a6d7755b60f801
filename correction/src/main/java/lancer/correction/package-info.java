/**
 * La correction d'une classe : la ligne de commande, et l'enchaînement qui va des rendus aux pages et aux notes.
 *
 * <p>Ce paquet ne contient que cet enchaînement et l'échec commun à tous les paquets.
 */
package lancer.correction;
