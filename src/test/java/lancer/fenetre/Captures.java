package lancer.fenetre;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.io.File;
import java.util.Arrays;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import lancer.Main;

/**
 * Photographie la fenêtre et l'un de ses panneaux, pour les pages : l'image à écrire ; un pixel à cliquer, « x,y », ou l'article de menu
 * à choisir ; le composant à attendre, et ce qui s'y lit ; puis les options du programme.
 */
final class Captures {

    private static final int PERIODE_MS = 100;
    private static final int PATIENCE = 3000;
    private static final int PEINTURE_MS = 1000;

    private Captures() {
    }

    public static void main(String[] args) throws Exception {
        Main.main(Arrays.copyOfRange(args, 4, args.length));
        Component image = attendre("image", "");
        attendre("resume", "réflexion");
        EventQueue.invokeAndWait(() -> SwingUtilities.getWindowAncestor(image).setLocation(0, 0));
        EventQueue.invokeLater(() -> agir(image, args[1]));
        attendre(args[2], args[3]);
        attendre("resume", "réflexion");
        photographier(args[0]);
    }

    private static void agir(Component image, String action) {
        if (action.matches("\\d+,\\d+")) {
            int[] xy = Arrays.stream(action.split(",")).mapToInt(Integer::parseInt).toArray();
            for (int geste : new int[] {MouseEvent.MOUSE_MOVED, MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED}) {
                image.dispatchEvent(new MouseEvent(image, geste, 0, InputEvent.BUTTON1_DOWN_MASK, xy[0], xy[1], 1, false,
                        MouseEvent.BUTTON1));
            }
            return;
        }
        JMenuBar menus = ((JFrame) SwingUtilities.getWindowAncestor(image)).getJMenuBar();
        Arrays.stream(menus.getComponents()).map(JMenu.class::cast)
                .flatMap(menu -> IntStream.range(0, menu.getItemCount()).mapToObj(menu::getItem))
                .filter(article -> article != null && article.getText().equals(action)).findFirst().get().doClick();
    }

    /** Écrit ce que montre l'écran, et termine le programme. */
    private static void photographier(String fichier) throws Exception {
        Thread.sleep(PEINTURE_MS);
        Rectangle ecran = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
        ImageIO.write(new Robot().createScreenCapture(ecran), "png", new File(fichier));
        System.exit(0);
    }

    /** Le composant de ce nom, une fois à l'écran, et ce texte dedans. */
    private static Component attendre(String nom, String texte) throws InterruptedException {
        for (int fois = 0; fois < PATIENCE; fois++) {
            for (Window fenetre : Window.getWindows()) {
                for (Component trouve : EssaiFenetre.contenus(fenetre)) {
                    if (trouve.isShowing() && nom.equals(trouve.getName()) && (texte.isEmpty() || lire(trouve).contains(texte))) {
                        return trouve;
                    }
                }
            }
            Thread.sleep(PERIODE_MS);
        }
        System.err.println("Rien ne se nomme « " + nom + " » en disant « " + texte + " »");
        System.exit(1);
        return null;
    }

    private static String lire(Component texte) {
        return EssaiFenetre.delier(texte instanceof JLabel ? ((JLabel) texte).getText() : ((JTextComponent) texte).getText());
    }
}
