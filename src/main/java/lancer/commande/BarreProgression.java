package lancer.commande;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.Timer;
import java.util.TimerTask;
import java.util.function.DoubleSupplier;

/** Une barre sur l'erreur standard, si elle est un terminal et si le travail dure. Elle est effacée à la fin. */
public final class BarreProgression extends TimerTask implements AutoCloseable {

    private static final String PLEINE = "####################";
    private static final String VIDE = "....................";

    /** Temps entre deux états de la barre, et avant le premier, en millisecondes. */
    private static final int PERIODE_MS = 200;

    private final PrintStream terminal;
    /** La part faite, de 0 à 1 ; {@code null} avant le début, et après la fin. */
    private DoubleSupplier avancement;

    public BarreProgression(PrintStream terminal) {
        this.terminal = terminal;
    }

    /** Montre désormais cet avancement. @param part la part faite, de 0 à 1 */
    public synchronized void suivre(DoubleSupplier part) {
        if (estUnTerminal()) {
            avancement = part;
            new Timer("lancer-barre", true).schedule(this, PERIODE_MS, PERIODE_MS);
        }
    }

    private static boolean estUnTerminal() {
        try {
            // sur Linux, le lien de l'erreur standard : Java ne sait pas si elle est un terminal
            String cible = Files.readSymbolicLink(Paths.get("/proc/self/fd/2")).toString();
            return cible.startsWith("/dev/pts/") || cible.startsWith("/dev/tty");
        } catch (IOException | UnsupportedOperationException e) {
            return System.console() != null;
        }
    }

    @Override
    public synchronized void run() {
        if (avancement != null) {
            double part = avancement.getAsDouble();
            int faits = (int) (PLEINE.length() * part);
            terminal.print("\r[" + PLEINE.substring(0, faits) + VIDE.substring(faits) + "] " + (int) (100 * part)
                    + " %");
            terminal.flush();
        }
    }

    /** Efface la barre. */
    @Override
    public synchronized void close() {
        if (avancement != null) {
            avancement = null;
            cancel();
            terminal.print("\r\u001b[K");
            terminal.flush();
        }
    }
}
