package lancer.contrat;

/** La boucle sur l'image : chaque pavé de pixels, une fois, quel que soit le fil qui s'en charge. */
public interface Boucle {

    /**
     * Dessine toute l'image.
     *
     * @param echantillonnage où regarder dans chaque pixel
     * @param profondeur nombre de réflexions permises
     */
    void parcourir(Echantillonnage echantillonnage, int profondeur);
}
