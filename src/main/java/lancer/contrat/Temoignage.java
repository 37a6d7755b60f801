package lancer.contrat;

/** Ce que des pixels témoins disent d'une recherche. Immuable. */
public final class Temoignage {

    /** Celui des boucles du cours sur elles-mêmes. */
    public static final Temoignage SANS_OBJET = new Temoignage(0, null);

    /** Nombre de pixels témoins, tirés au hasard, un dans chacune d'autant de parts égales de l'image. */
    public final int pixels;

    /** Le premier écart, en une phrase qui nomme le pixel ; {@code null} s'il n'y en a pas. */
    public final String ecart;

    public Temoignage(int pixels, String ecart) {
        this.pixels = pixels;
        this.ecart = ecart;
    }
}
