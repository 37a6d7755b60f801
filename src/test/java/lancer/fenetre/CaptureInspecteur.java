package lancer.fenetre;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.io.File;
import javax.imageio.ImageIO;
import javax.swing.JLabel;
import lancer.Main;

/** Photographie la fenêtre et son inspecteur, pour le README : l'image à écrire, x, y, puis les options du programme. */
final class CaptureInspecteur {

    private static final int PERIODE_MS = 100;
    private static final int PEINTURE_MS = 1000;

    private CaptureInspecteur() {
    }

    public static void main(String[] args) throws Exception {
        Main.main(java.util.Arrays.copyOfRange(args, 3, args.length));
        Component panneau = attendre("image", "");
        attendre("resume", "réflexion");
        int x = Integer.parseInt(args[1]);
        int y = Integer.parseInt(args[2]);
        EventQueue.invokeAndWait(() -> panneau.dispatchEvent(new MouseEvent(panneau, MouseEvent.MOUSE_CLICKED, 0,
                InputEvent.BUTTON1_DOWN_MASK, x, y, 1, false, MouseEvent.BUTTON1)));
        attendre("verdict", "Au bit près");
        photographier(args[0]);
    }

    /** Écrit ce que montrent les fenêtres du programme, et le termine. */
    static void photographier(String fichier) throws Exception {
        Thread.sleep(PEINTURE_MS);
        Rectangle place = new Rectangle(-1, -1);
        for (Window fenetre : Window.getWindows()) {
            if (fenetre.isShowing()) {
                place.add(fenetre.getBounds());
            }
        }
        ImageIO.write(new Robot().createScreenCapture(place), "png", new File(fichier));
        System.exit(0);
    }

    /** Le composant de ce nom, une fois à l'écran, et ce texte dedans. */
    static Component attendre(String nom, String texte) throws InterruptedException {
        while (true) {
            for (Window fenetre : Window.getWindows()) {
                Component trouve = fenetre.isShowing() ? dans(fenetre, nom) : null;
                if (trouve != null && (texte.isEmpty() || ((JLabel) trouve).getText().contains(texte))) {
                    return trouve;
                }
            }
            Thread.sleep(PERIODE_MS);
        }
    }

    private static Component dans(Container contenant, String nom) {
        for (Component composant : contenant.getComponents()) {
            Component trouve = nom.equals(composant.getName()) ? composant
                    : composant instanceof Container ? dans((Container) composant, nom) : null;
            if (trouve != null) {
                return trouve;
            }
        }
        return null;
    }
}
