package lancer.fenetre;

import java.awt.EventQueue;
import java.awt.Window;
import java.util.Arrays;
import java.util.concurrent.FutureTask;
import java.util.stream.IntStream;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import lancer.Main;
import lancer.commande.Options;

/** Photographie la fenêtre et les paramètres de ses variantes, pour le README : l'image à écrire, puis les options du programme. */
final class CaptureReglages {

    private static final int PERIODE_MS = 100;

    private CaptureReglages() {
    }

    public static void main(String[] args) throws Exception {
        Options options = Options.lire(Arrays.copyOfRange(args, 1, args.length));
        Fenetre fenetre = Ouverture.ouvrir(new Main(options, System.out, System.err), options, System.err, () -> { });
        attendreLImage(fenetre);
        EventQueue.invokeLater(article(fenetre, "Paramètres des variantes…")::doClick);
        while (Arrays.stream(Window.getWindows()).filter(Window::isShowing).count() < 2) {
            Thread.sleep(PERIODE_MS);
        }
        attendreLImage(fenetre);
        CaptureInspecteur.photographier(args[0]);
    }

    private static void attendreLImage(Fenetre fenetre) throws Exception {
        boolean complete = false;
        while (!complete) {
            Thread.sleep(PERIODE_MS);
            FutureTask<Boolean> question = new FutureTask<>(() -> fenetre.getImageComplete() != null);
            EventQueue.invokeLater(question);
            complete = question.get();
        }
    }

    private static JMenuItem article(Fenetre fenetre, String texte) {
        return Arrays.stream(fenetre.getCadre().getJMenuBar().getComponents()).map(JMenu.class::cast)
                .flatMap(menu -> IntStream.range(0, menu.getItemCount()).mapToObj(menu::getItem))
                .filter(article -> article != null && article.getText().equals(texte)).findFirst().get();
    }
}
