/**
 * La fenêtre Swing. {@code etat} dit ce qui se montre et ce qui suit, {@code moteur} travaille dans d'autres fils,
 * {@code vue} montre, et {@code Fenetre} les relie. Eux seuls connaissent Swing et AWT. {@code --image} ne les charge
 * pas.
 */
package lancer.fenetre;
