package lancer.atelier;

import java.io.BufferedWriter;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;

/**
 * Écrit sur la sortie standard une scène aussi grande que l'on veut :
 *
 * <pre>
 * java -cp mesures/target/mesures.jar lancer.atelier.Generateur foule N
 * java -cp mesures/target/mesures.jar lancer.atelier.Generateur tournesol N
 * </pre>
 *
 * Les mêmes arguments donnent le même texte, à l'octet, sur toute machine.
 */
public final class Generateur {

    /** Au-delà, ce n'est plus une scène mais un disque plein. */
    private static final int N_MAX = 100000000;

    private Generateur() {
    }

    /** @param args voir la description de la classe */
    public static void main(String[] args) {
        try (Writer sortie = new BufferedWriter(new OutputStreamWriter(
                new FileOutputStream(FileDescriptor.out), StandardCharsets.UTF_8), 1 << 16)) {
            ecrire(sortie, args);
        } catch (IllegalArgumentException e) {
            System.err.println("Generateur : " + e.getMessage() + " ; usage : Generateur foule N | tournesol N");
            System.exit(2);
        } catch (IOException e) {
            System.err.println("Generateur : écriture impossible : " + e.getMessage());
            System.exit(1);
        }
    }

    /** @throws IllegalArgumentException si la demande ne va pas ; rien n'est alors écrit */
    static void ecrire(Appendable sortie, String... args) throws IOException {
        String scene = args.length == 2 ? args[0] : "";
        if (scene.equals("foule")) {
            Foule.ecrire(new Plume(sortie), nombre(args[1]));
        } else if (scene.equals("tournesol")) {
            Tournesol.ecrire(new Plume(sortie), nombre(args[1]));
        } else {
            throw new IllegalArgumentException("une scène, et son nombre de boules");
        }
    }

    private static int nombre(String texte) {
        int n = texte.matches("[0-9]{1,9}") ? Integer.parseInt(texte) : 0;
        if (n < 1 || n > N_MAX) {
            throw new IllegalArgumentException("nombre de boules : « " + texte + " », au lieu d'un entier de 1 à " + N_MAX);
        }
        return n;
    }
}
