package lancer;

/** Ce sur quoi {@link Lancer#TracerImage} dessine : la fenêtre de {@link Main}. */
public interface Toile {

    void drawPixel(Couleur coul, int xe, int ye);

    /** @param part part faite de l'image, de 0 à 1 */
    void avancer(double part);
}
