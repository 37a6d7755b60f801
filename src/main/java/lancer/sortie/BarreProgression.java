package lancer.sortie;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import lancer.Lancer;

/** Une barre sur l'erreur standard pendant un dessin qui dure ; rien si ce n'est pas un terminal, ou si c'est bref. */
public final class BarreProgression implements Runnable {

    private static final int LARGEUR = 40;

    /** Temps entre deux états de la barre, et avant le premier, en millisecondes. */
    private static final int PERIODE_MS = 200;

    /** Ce vers quoi va l'erreur standard, sur Linux : Java ne sait pas le dire. */
    private static final Path ERREUR_STANDARD = Paths.get("/proc/self/fd/2");

    private final Lancer lancer;
    private final PrintStream terminal;
    private Thread fil;
    private boolean visible;

    public BarreProgression(Lancer lancer, PrintStream terminal) {
        this.lancer = lancer;
        this.terminal = terminal;
    }

    /** Vrai si l'erreur standard est un terminal : ailleurs qu'un fichier ou un tube, une barre se lit. */
    public static boolean possible() {
        try {
            String cible = Files.readSymbolicLink(ERREUR_STANDARD).toString();
            return cible.startsWith("/dev/pts/") || cible.startsWith("/dev/tty");
        } catch (IOException | UnsupportedOperationException e) {
            return System.console() != null;
        }
    }

    public void commencer() {
        fil = new Thread(this, "lancer-barre");
        fil.setDaemon(true);
        fil.start();
    }

    /** Efface la barre, et rend la ligne au terminal. */
    public void finir() {
        fil.interrupt();
        try {
            fil.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void run() {
        try {
            while (true) {
                Thread.sleep(PERIODE_MS);
                visible = true;
                terminal.print(ligne(lancer.getAvancement()));
                terminal.flush();
            }
        } catch (InterruptedException e) {
            if (visible) {
                terminal.print("\r\u001b[K");
                terminal.flush();
            }
        }
    }

    static String ligne(double part) {
        StringBuilder s = new StringBuilder("\r[");
        int pleins = (int) (LARGEUR * part);
        for (int k = 0; k < LARGEUR; k++) {
            s.append(k < pleins ? '#' : '.');
        }
        return s.append("] ").append((int) (100 * part)).append(" %").toString();
    }
}
