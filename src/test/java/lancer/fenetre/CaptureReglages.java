package lancer.fenetre;

import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import lancer.Main;

/** Photographie la fenêtre et les paramètres des variantes, pour le README : l'image à écrire, puis les options du programme. */
final class CaptureReglages {

    private CaptureReglages() {
    }

    public static void main(String[] args) throws Exception {
        Main.main(Arrays.copyOfRange(args, 1, args.length));
        JLabel resume = (JLabel) CaptureInspecteur.attendre("resume", "réflexion");
        EventQueue.invokeAndWait(() -> {
            JFrame cadre = (JFrame) SwingUtilities.getWindowAncestor(resume);
            SwingUtilities.processKeyBindings(new KeyEvent(cadre.getRootPane(), KeyEvent.KEY_PRESSED, 0, 0, KeyEvent.VK_F2,
                    KeyEvent.CHAR_UNDEFINED));
        });
        CaptureInspecteur.attendre("Blinn.facteur", "");
        CaptureInspecteur.photographier(args[0]);
    }
}
