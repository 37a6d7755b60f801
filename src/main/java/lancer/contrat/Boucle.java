package lancer.contrat;

/** La boucle sur l'image : chaque pavé de pixels, une fois, quel que soit le fil qui s'en charge. */
public interface Boucle {

    /** Dessine toute l'image en carrés de 4 × 4 pixels, chacun de la couleur de son centre. */
    void TracerBrouillon(Toile toile, int profondeur, int fils);

    /** Dessine tous les pixels. */
    void TracerPixels(Toile toile, int profondeur, int fils);
}
