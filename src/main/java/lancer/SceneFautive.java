package lancer;

/**
 * Un fichier de scène qui ne peut être utilisé. Le message tient en une ligne : le fichier, la ligne si elle est
 * connue, la section, la clé, la faute et ce qui est attendu.
 */
public class SceneFautive extends RuntimeException {

    private static final long serialVersionUID = 1;

    public SceneFautive(String message) {
        super(message);
    }

    public SceneFautive(String message, Throwable cause) {
        super(message, cause);
    }
}
