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
    /** Ce qui efface la barre, dans les terminaux qui n'ont pas de séquence pour cela aussi. */
    private static final String BLANCS = PLEINE.replace('#', ' ') + "        ";

    /** Les bits du type d'un fichier, et le type d'un terminal (POSIX, {@code sys/stat.h}). */
    private static final int TYPE = 0170000;
    private static final int PERIPHERIQUE = 0020000;

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

    /** Dit si l'erreur standard est un terminal. Sous Windows, rien en Java ne le dit : il n'y a pas de barre. */
    private static boolean estUnTerminal() {
        try {
            int mode = (Integer) Files.getAttribute(Paths.get("/dev/fd/2"), "unix:mode");
            return (mode & TYPE) == PERIPHERIQUE;
        } catch (IOException | UnsupportedOperationException | IllegalArgumentException e) {
            return false;
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
            terminal.print("\r" + BLANCS + "\r");
            terminal.flush();
        }
    }
}
