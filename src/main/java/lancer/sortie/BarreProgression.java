package lancer.sortie;

import java.io.PrintStream;
import lancer.Lancer;

/** Une barre sur l'erreur standard pendant un dessin qui dure ; rien si ce n'est pas un terminal, ou si c'est fini vite. */
public final class BarreProgression implements Runnable {

    private static final int LARGEUR = 40;

    /** Temps entre deux états de la barre, et avant le premier, en millisecondes. */
    private static final int PERIODE_MS = 200;

    private final Lancer lancer;
    private final PrintStream terminal;
    private Thread fil;
    private boolean visible;

    public BarreProgression(Lancer lancer, PrintStream terminal) {
        this.lancer = lancer;
        this.terminal = terminal;
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
