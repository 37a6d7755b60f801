package lancer.commande;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.NoSuchElementException;
import java.util.Scanner;
import java.util.Timer;
import java.util.TimerTask;
import java.util.function.DoubleSupplier;

/** Une barre sur l'erreur standard, si le travail dure ; elle tient dans la largeur du terminal. */
public final class BarreProgression extends TimerTask {

    /** Colonnes de la barre, si le terminal en a assez, et celles de ce qui l'entoure : « [] 100 % » et le curseur. */
    private static final int LARGEUR = 40;
    private static final int AUTOUR = 9;

    /** Temps entre deux états de la barre, et avant le premier, en millisecondes. */
    private static final int PERIODE_MS = 200;

    /** Lien de l'erreur standard sur Linux : Java ne sait pas si elle est un terminal. */
    private static final Path ERREUR_STANDARD = Paths.get("/proc/self/fd/2");

    private final DoubleSupplier avancement;
    private final PrintStream terminal;
    private final Timer horloge = new Timer("lancer-barre", true);
    private int largeur;
    private boolean visible;
    private boolean effacee;

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

    /** Colonnes de cette barre, d'après celles du terminal : Java ne les sait pas, {@code stty} les lui demande. */
    private static int demanderLargeur() {
        ProcessBuilder stty = new ProcessBuilder("sh", "-c", "stty size <&2 2>/dev/null");
        stty.redirectError(ProcessBuilder.Redirect.INHERIT);
        try (Scanner taille = new Scanner(stty.start().getInputStream(), "US-ASCII")) {
            taille.nextInt();
            int colonnes = taille.nextInt();
            return colonnes == 0 ? LARGEUR : Math.max(0, Math.min(LARGEUR, colonnes - AUTOUR));
        } catch (IOException | NoSuchElementException e) {
            return LARGEUR;
        }
    }

    @Override
    public synchronized void run() {
        if (!effacee) {
            if (!visible) {
                visible = true;
                largeur = demanderLargeur();
            }
            double part = avancement.getAsDouble();
            char[] barre = new char[largeur];
            Arrays.fill(barre, '.');
            Arrays.fill(barre, 0, Math.min(largeur, (int) (largeur * part)), '#');
            montrer("\r[" + new String(barre) + "] " + (int) (100 * part) + " %");
        }
    }

    public synchronized void finir() {
        horloge.cancel();
        effacee = true;
        if (visible) {
            montrer("\r\u001b[K");
        }
    }

    private void montrer(String texte) {
        terminal.print(texte);
        terminal.flush();
    }
}
