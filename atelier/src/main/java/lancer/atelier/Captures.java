package lancer.atelier;

import java.awt.AWTException;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.io.File;
import java.io.IOException;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import lancer.Main;
import lancer.commande.Options;
import lancer.fenetre.Fenetre;
import lancer.fenetre.Ouverture;

/**
 * Les captures d'écran du README : le programme, ouvert devant un robot qui frappe des touches.
 *
 * <pre>
 * xvfb-run java -cp blinn/target/blinn.jar:mesures/target/mesures.jar lancer.mesures.Captures target/captures
 * </pre>
 */
public final class Captures {

    private static final int PAUSE_MS = 300;
    private static final int ESSAIS = 400;

    private final Robot robot;
    private final File dossier;

    private Captures(File dossier) throws AWTException {
        this.dossier = dossier;
        robot = new Robot();
        robot.setAutoDelay(PAUSE_MS);
    }

    /** @param args le dossier où les écrire */
    public static void main(String[] args) throws Exception {
        Captures captures = new Captures(new File(args[0]));
        captures.capturer("fenetre-reglages", KeyEvent.VK_F2, "--sans=Brume,Antialias", "scenes/bowling.ini");
        System.exit(0);
    }

    /** @param touche ce qu'il faut frapper une fois l'image achevée */
    private void capturer(String nom, int touche, String... options) throws Exception {
        CountDownLatch fin = new CountDownLatch(1);
        Fenetre fenetre = Ouverture.ouvrir(new Main(Options.lire(options), System.out, System.err), Options.lire(options), System.err,
                fin::countDown);
        attendre(() -> {
            // sans gestionnaire de fenêtres, le clavier se demande
            fenetre.getCadre().toFront();
            fenetre.getCadre().requestFocus();
            return fenetre.getImageComplete() != null && fenetre.getCadre().isFocused();
        });
        robot.keyPress(touche);
        robot.keyRelease(touche);
        attendre(() -> fenetre.getImageComplete() != null && Window.getWindows().length > 1);
        robot.delay(PAUSE_MS);
        ecrire(nom);
        EventQueue.invokeLater(() -> fenetre.getCadre().dispatchEvent(new WindowEvent(fenetre.getCadre(), WindowEvent.WINDOW_CLOSING)));
        fin.await();
    }

    private void ecrire(String nom) throws IOException {
        Rectangle vue = new Rectangle();
        for (Window fenetre : Window.getWindows()) {
            vue = !fenetre.isShowing() ? vue : vue.isEmpty() ? fenetre.getBounds() : vue.union(fenetre.getBounds());
        }
        ImageIO.write(robot.createScreenCapture(vue), "png", new File(dossier, nom + ".png"));
    }

    private void attendre(Callable<Boolean> condition) throws Exception {
        boolean vraie = false;
        for (int k = 0; k < ESSAIS && !vraie; k++) {
            robot.delay(PAUSE_MS);
            FutureTask<Boolean> question = new FutureTask<>(condition);
            EventQueue.invokeAndWait(question);
            vraie = question.get();
        }
        if (!vraie) {
            throw new IllegalStateException("la fenêtre ne répond pas");
        }
    }
}
