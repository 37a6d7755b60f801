package lancer.commande;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Timer;
import java.util.TimerTask;
import java.util.function.DoubleSupplier;

/** Une barre sur l'erreur standard, si le travail dure. Le terminal le plus étroit la montre sur une ligne. */
public final class BarreProgression extends TimerTask {

    /** Largeur de la barre, en caractères. */
    private static final int LARGEUR = 20;

    /** Temps entre deux états de la barre, et avant le premier, en millisecondes. */
    private static final int PERIODE_MS = 200;

    /** Lien de l'erreur standard sur Linux : Java ne sait pas si elle est un terminal. */
    private static final Path ERREUR_STANDARD = Paths.get("/proc/self/fd/2");

    private final DoubleSupplier avancement;
    private final PrintStream terminal;
    private final Timer horloge = new Timer("lancer-barre", true);
    private boolean finie;

    /** @param avancement la part faite, de 0 à 1 */
    public BarreProgression(DoubleSupplier avancement, PrintStream terminal) {
        this.avancement = avancement;
        this.terminal = terminal;
        horloge.schedule(this, PERIODE_MS, PERIODE_MS);
    }

    /** Dit si l'erreur standard est un terminal. La barre ne doit être écrite ni dans un fichier, ni dans un tube. */
    public static boolean surUnTerminal() {
        try {
            String cible = Files.readSymbolicLink(ERREUR_STANDARD).toString();
            return cible.startsWith("/dev/pts/") || cible.startsWith("/dev/tty");
        } catch (IOException | UnsupportedOperationException e) {
            return System.console() != null;
        }
    }

    @Override
    public synchronized void run() {
        if (!finie) {
            double part = avancement.getAsDouble();
            char[] barre = new char[LARGEUR];
            Arrays.fill(barre, '.');
            Arrays.fill(barre, 0, Math.min(LARGEUR, (int) (LARGEUR * part)), '#');
            montrer("\r[" + new String(barre) + "] " + (int) (100 * part) + " %");
        }
    }

    /** Efface la barre. */
    public synchronized void finir() {
        horloge.cancel();
        finie = true;
        montrer("\r\u001b[K");
    }

    private void montrer(String texte) {
        terminal.print(texte);
        terminal.flush();
    }
}
