package lancer.mesures;

/** Une image qui n'est pas celle du chemin lisible : son temps ne vaut rien. */
public final class ImageFausse extends RuntimeException {

    private static final long serialVersionUID = 1;

    public ImageFausse(String message) {
        super(message);
    }
}
