package lancer;

import java.awt.AWTError;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import javax.imageio.ImageIO;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.SwingUtilities;
import javax.swing.SwingWorker;
import javax.swing.Timer;

/** Le programme (cours, « Bilan intermédiaire ») : dessine une scène dans une fenêtre, ou dans un fichier. */
public class Main implements Toile {

    private final Scene scene;
    private final BufferedImage image =
            new BufferedImage(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE, BufferedImage.TYPE_INT_RGB);
    private volatile double fait;

    public Main(Scene scene) {
        this.scene = scene;
    }

    /** @param args la scène, par exemple scenes/scene1.ini ; puis, pour se passer de fenêtre, l'image PNG à écrire */
    public static void main(String[] args) {
        String fichier = args.length > 0 ? args[0] : "scenes/scene1.ini";
        if (args.length > 2) {
            arreter(2, "trop d'arguments ; attendu, une scène, puis l'image à écrire : " + fichier + " image.png");
        } else if (args.length == 2 && !args[1].toLowerCase(Locale.ROOT).endsWith(".png")) {
            arreter(2, "image impossible : « " + args[1] + " » ; attendu, un fichier dont le nom finit par .png");
        } else if (args.length == 2 && Paths.get(args[1]).toAbsolutePath().equals(Paths.get(fichier).toAbsolutePath())) {
            arreter(2, "l'image effacerait la scène : " + fichier);
        }
        Main main = null;
        try {
            main = new Main(new Scene(fichier));
        } catch (IllegalArgumentException e) {
            arreter(2, e.getMessage());
        }
        if (args.length == 2) {
            main.doTracerImage(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);
            main.ecrire(args[1]);
        } else {
            exigerUnEcran(fichier);
            SwingUtilities.invokeLater(main::ouvrirFenetre);
        }
    }

    private static void arreter(int statut, String pourquoi) {
        System.err.println(pourquoi);
        System.exit(statut);
    }

    private void ecrire(String fichier) {
        try {
            ByteArrayOutputStream octets = new ByteArrayOutputStream();
            ImageIO.write(image, "png", octets);
            Files.write(Paths.get(fichier), octets.toByteArray());
        } catch (IOException e) {
            arreter(1, "écriture impossible : " + fichier + " ; attendu, un fichier d'un dossier qui existe, et où vous pouvez écrire");
        }
    }

    private static void exigerUnEcran(String fichier) {
        try {
            GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice();
        } catch (HeadlessException | AWTError e) {
            arreter(1, "Pas d'écran ici. Sans fenêtre : make IMAGE=image.png, ou java -jar target/lancer-base.jar " + fichier + " image.png");
        }
    }

    /** Dessine un pixel de cette couleur. */
    @Override
    public void drawPixel(Couleur coul, int xe, int ye) {
        image.setRGB(xe, ye, coul.getCode());
    }

    @Override
    public void avancer(double part) {
        fait = part;
    }

    /** Dessine la scène : le travail du SwingWorker. */
    public void doTracerImage(int largeur, int hauteur) {
        new Lancer(scene, new Camera(largeur, hauteur)).TracerImage(this, largeur, hauteur, Constantes.MAX_REFLETS);
    }

    /** Ce qui a fait échouer le dessin, et la ligne du projet où c'est arrivé. */
    private static String echec(Throwable cause) {
        return "Le dessin a échoué : " + cause.getClass().getSimpleName() + Arrays.stream(cause.getStackTrace())
                .filter(appel -> appel.getClassName().startsWith("lancer.")).findFirst()
                .map(appel -> ", " + appel.getFileName() + ":" + appel.getLineNumber()).orElse("");
    }

    private void ouvrirFenetre() {
        JPanel dessin = new JPanel() {
            private static final long serialVersionUID = 1;

            @Override
            protected void paintComponent(Graphics g) {
                g.drawImage(image, 0, 0, null);
            }
        };
        dessin.setPreferredSize(new Dimension(image.getWidth(), image.getHeight()));
        JProgressBar jauge = new JProgressBar(0, 100);
        JFrame fenetre = new JFrame("Lancer de rayons");
        fenetre.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        fenetre.add(dessin, BorderLayout.CENTER);
        fenetre.add(jauge, BorderLayout.SOUTH);
        fenetre.pack();
        fenetre.setLocationRelativeTo(null);
        fenetre.setVisible(true);
        Timer rafraichir = new Timer(50, e -> {
            jauge.setValue((int) (100 * fait));
            dessin.repaint();
        });
        rafraichir.start();
        new SwingWorker<Void, Void>() {
            @Override
            protected Void doInBackground() {
                doTracerImage(image.getWidth(), image.getHeight());
                return null;
            }

            @Override
            protected void done() {
                rafraichir.stop();
                dessin.repaint();
                try {
                    get();
                    jauge.setValue(100);
                } catch (InterruptedException | ExecutionException e) {
                    Throwable cause = e.getCause() == null ? e : e.getCause();
                    fenetre.setTitle(echec(cause));
                    System.err.println(echec(cause));
                    cause.printStackTrace();
                }
            }
        }.execute();
    }
}
