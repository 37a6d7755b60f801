package lancer.contrat;

import lancer.Couleur;

/** Surface qui reçoit les pixels. Plusieurs fils y dessinent à la fois, mais jamais le même pixel. */
public interface Toile {

    /** @param coul non limitée @param xe colonne, de 0 à largeur − 1 @param ye ligne, de 0 (en haut) à hauteur − 1 */
    void drawPixel(Couleur coul, int xe, int ye);

    /** Dit si l'image est d'abord montrée en brouillon. */
    default boolean montreUnBrouillon() {
        return false;
    }

    /** Méthode appelée à la fin du brouillon, quand chaque pixel a une couleur. */
    default void finirBrouillon() {
    }
}
