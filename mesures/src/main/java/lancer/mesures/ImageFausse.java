package lancer.mesures;

/** Une image qui n'est pas celle du chemin lisible : son temps ne vaut rien. */
final class ImageFausse extends RuntimeException {

    private static final long serialVersionUID = 1;

    ImageFausse(String message) {
        super(message);
    }
}
