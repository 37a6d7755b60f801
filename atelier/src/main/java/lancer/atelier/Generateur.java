package lancer.atelier;

import java.io.BufferedWriter;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.PrintStream;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.Random;

/**
 * Écrit sur la sortie standard une scène aussi grande que l'on veut :
 *
 * <pre>
 * java -cp mesures/target/mesures.jar lancer.atelier.Generateur foule N [GRAINE]
 * java -cp mesures/target/mesures.jar lancer.atelier.Generateur tournesol N
 * </pre>
 *
 * Les mêmes arguments donnent le même texte, à l'octet, sur toute machine.
 */
public final class Generateur {

    /** Au-delà, ce n'est plus une scène mais un disque plein. */
    public static final int N_MAX = 100000000;

    /** Graine de {@code foule} si l'on n'en donne pas. */
    public static final long GRAINE = 1;

    private static final String USAGE = "usage : Generateur foule N [GRAINE] | tournesol N";

    private Generateur() {
    }

    /** @param args voir la description de la classe */
    public static void main(String[] args) {
        int statut;
        try (Writer sortie = new BufferedWriter(new OutputStreamWriter(
                new FileOutputStream(FileDescriptor.out), StandardCharsets.UTF_8), 1 << 16)) {
            statut = executer(args, sortie, System.err);
        } catch (IOException e) {
            System.err.println("Generateur : écriture impossible : " + e.getMessage());
            statut = 1;
        }
        System.exit(statut);
    }

    /**
     * Ce que fait {@link #main}, sans quitter Java.
     *
     * @return 0, ou 2 après une ligne sur {@code erreurs} si la demande ne va pas
     * @throws IOException si la sortie ne peut être écrite
     */
    static int executer(String[] args, Appendable sortie, PrintStream erreurs) throws IOException {
        String faute = refuser(args);
        if (faute != null) {
            erreurs.println("Generateur : " + faute + " ; " + USAGE);
            return 2;
        }
        int nombre = Integer.parseInt(args[1]);
        if (args[0].equals("foule")) {
            foule(sortie, nombre, args.length > 2 ? Long.parseLong(args[2]) : GRAINE);
        } else {
            tournesol(sortie, nombre);
        }
        return 0;
    }

    /** Ce qui ne va pas dans les arguments, ou {@code null}. */
    private static String refuser(String[] args) {
        String scene = args.length == 0 ? "" : args[0];
        boolean foule = scene.equals("foule");
        if (!foule && !scene.equals("tournesol")) {
            return "scène inconnue : « " + scene + " »";
        }
        if (args.length < 2) {
            return scene + " : il manque un nombre";
        }
        if (args.length > (foule ? 3 : 2)) {
            return scene + " : un argument de trop : « " + args[args.length - 1] + " »";
        }
        if (!estEntier(args[1], 1, N_MAX)) {
            return scene + " : « " + args[1] + " » n'est pas un entier de 1 à " + N_MAX;
        }
        if (args.length > 2 && !estEntier(args[2], Long.MIN_VALUE, Long.MAX_VALUE)) {
            return scene + " : la graine « " + args[2] + " » n'est pas un entier";
        }
        return null;
    }

    private static boolean estEntier(String texte, long min, long max) {
        try {
            long valeur = Long.parseLong(texte);
            return min <= valeur && valeur <= max;
        } catch (NumberFormatException e) {
            return false;
        }
    }

    /**
     * Des boules au hasard qui ne se touchent pas, devant l'œil.
     *
     * @param n de 1 à {@link #N_MAX}
     * @param graine du hasard ; la même graine donne la même foule
     */
    public static void foule(Appendable sortie, int n, long graine) throws IOException {
        verifier(n);
        new Foule(new Plume(sortie), n, graine, new Random(graine)).ecrire();
    }

    /**
     * Des boules rangées comme les graines d'un tournesol, sur un sol : n boules, et celle du sol.
     *
     * @param n de 1 à {@link #N_MAX}
     */
    public static void tournesol(Appendable sortie, int n) throws IOException {
        verifier(n);
        new Tournesol(new Plume(sortie), n).ecrire();
    }

    private static void verifier(int n) {
        if (n < 1 || n > N_MAX) {
            throw new IllegalArgumentException("nombre de boules : " + n + ", au lieu de 1 à " + N_MAX);
        }
    }
}
