package lancer.fenetre;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.AWTError;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Point;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UnsupportedEncodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JProgressBar;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import lancer.Main;
import lancer.commande.Reglages;
import lancer.essai.Essai;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Pixel;
import lancer.fenetre.etat.Suite;
import lancer.image.ImageMemoire;

/** Une fenêtre à l'essai, sur un vrai écran : on y frappe des touches, on y regarde, et on attend sans dormir pour rien. */
final class BancFenetre {

    /** Attente au-delà de laquelle cela n'arrivera plus : quarante fois la plus lente des ouvertures de fenêtre, et au moins 40 s. */
    private static volatile long patienceNs = TimeUnit.SECONDS.toNanos(40);

    final ByteArrayOutputStream sortie;
    final ByteArrayOutputStream erreur;
    final CountDownLatch fin = new CountDownLatch(1);
    final Robot robot;
    final MainLent main;
    final Fenetre fenetre;
    final JFrame cadre;
    final JComponent panneau;
    final JTextArea bandeau;
    final JTextArea resume;
    final JLabel pixel;
    final JProgressBar avancement;

    BancFenetre(String... args) throws Exception {
        this(new MainLent(args));
    }

    BancFenetre(MainLent main) throws Exception {
        exigerEcran();
        long debut = System.nanoTime();
        this.main = main;
        sortie = main.sortie;
        erreur = main.erreur;
        robot = new Robot();
        // ni l'endroit où l'essai d'avant a laissé la souris, qu'un menu ouvert dessous suivrait, ni ce qu'il a copié ne comptent
        Dimension ecran = Toolkit.getDefaultToolkit().getScreenSize();
        robot.mouseMove(ecran.width - 1, ecran.height - 1);
        Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(""), null);
        fenetre = main.ouvrir(fin::countDown);
        cadre = fenetre.getCadre();
        panneau = composant("image", JComponent.class);
        bandeau = contenus(cadre).stream().filter(c -> "message".equals(c.getName())).map(JTextArea.class::cast).findFirst().get();
        resume = composant("resume", JTextArea.class);
        pixel = composant("pixel", JLabel.class);
        avancement = composant("avancement", JProgressBar.class);
        patienceNs = Math.max(patienceNs, 40 * (System.nanoTime() - debut));
    }

    static PrintStream flux(ByteArrayOutputStream octets) {
        try {
            return new PrintStream(octets, true, "UTF-8");
        } catch (UnsupportedEncodingException e) {
            throw new IllegalStateException(e);
        }
    }

    static String texte(ByteArrayOutputStream octets) {
        return new String(octets.toByteArray(), StandardCharsets.UTF_8);
    }

    /** Une fenêtre ne s'ouvre que si on l'exige : sans cela, le test est sauté, même devant un écran ; avec, il lui en faut un. */
    static void exigerEcran() {
        assumeTrue(Boolean.getBoolean("fenetre.exigee"), "ouvre une fenêtre, et -Dfenetre.exigee=true n'est pas donné");
        boolean ecran;
        try {
            ecran = !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError | LinkageError e) {
            ecran = false;
        }
        assertTrue(ecran, "-Dfenetre.exigee=true, et pas d'écran, ou un Java sans fenêtres");
    }

    static void attendre(String quoi, Callable<Boolean> condition) throws Exception {
        long limite = System.nanoTime() + patienceNs;
        while (!surFilEvenements(condition)) {
            if (System.nanoTime() > limite) {
                fail("toujours pas : " + quoi);
            }
            Thread.sleep(10);
        }
    }

    static <T> T surFilEvenements(Callable<T> question) throws Exception {
        FutureTask<T> tache = new FutureTask<>(question);
        EventQueue.invokeLater(tache);
        return tache.get(patienceNs, TimeUnit.NANOSECONDS);
    }

    static void faire(Runnable geste) throws Exception {
        surFilEvenements(Executors.callable(geste));
    }

    /** Le composant visible de ce nom (ou de cette classe si {@code nom} est nul), dans n'importe quelle fenêtre ; ou {@code null}. */
    static <T extends Component> T chercher(String nom, Class<T> classe) throws Exception {
        return surFilEvenements(() -> Arrays.stream(Window.getWindows()).filter(Component::isShowing).flatMap(w -> contenus(w).stream())
                .filter(c -> classe.isInstance(c) && (nom == null || nom.equals(c.getName()))).map(classe::cast).findFirst().orElse(null));
    }

    /** Ce conteneur et tout ce qu'il contient. */
    static List<Component> contenus(Component c) {
        List<Component> contenus = new ArrayList<>(Arrays.asList(c));
        for (Component enfant : c instanceof Container ? ((Container) c).getComponents() : new Component[0]) {
            contenus.addAll(contenus(enfant));
        }
        return contenus;
    }

    /** Le composant de ce nom, quand il sera là. */
    static <T extends Component> T composant(String nom, Class<T> classe) throws Exception {
        long limite = System.nanoTime() + patienceNs;
        while (true) {
            T trouve = chercher(nom, classe);
            if (trouve != null && surFilEvenements(trouve::isShowing)) {
                return trouve;
            }
            if (System.nanoTime() > limite) {
                return fail("toujours pas de " + classe.getSimpleName() + " " + nom);
            }
            Thread.sleep(10);
        }
    }

    /**
     * Attend que cette fenêtre ait le clavier. Celle qui s'ouvre le prend quand elle peut : l'attendre avant de frapper ailleurs,
     * sans quoi une touche va à la fenêtre qui vient de le perdre.
     */
    static void mettreDevant(Window fenetre) throws Exception {
        attendre("le clavier est à la fenêtre", () -> {
            if (!fenetre.isFocused()) {
                fenetre.toFront();
                fenetre.requestFocus();
            }
            // une touche frappée avant qu'un composant ait le clavier serait perdue
            return fenetre.isFocused() && fenetre.getFocusOwner() != null;
        });
    }

    /** Frappe des touches ensemble, comme Ctrl+S, quand le cadre les reçoit. */
    void frapper(int... touches) throws Exception {
        frapper(cadre, touches);
    }

    /** De même, quand cette fenêtre les reçoit. */
    void frapper(Window fenetre, int... touches) throws Exception {
        mettreDevant(fenetre);
        for (int touche : touches) {
            robot.keyPress(touche);
        }
        for (int k = touches.length - 1; k >= 0; k--) {
            robot.keyRelease(touches[k]);
        }
    }

    void frapperCtrl(char lettre) throws Exception {
        frapper(KeyEvent.VK_CONTROL, KeyEvent.getExtendedKeyCodeForChar(lettre));
    }

    /** Clique, de la vraie souris, sur ce point du composant. */
    void cliquer(Component composant, int x, int y) throws Exception {
        viser(composant, x, y);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }

    /** Met la vraie souris sur ce point du composant, dont la fenêtre passe devant. */
    void viser(Component composant, int x, int y) throws Exception {
        Window fenetre = SwingUtilities.getWindowAncestor(composant);
        mettreDevant(fenetre);
        Point ou = surFilEvenements(() -> {
            // sans gestionnaire de fenêtres, Java croit parfois la sienne dans le coin de l'écran : bougée, il sait où elle est
            fenetre.setLocation(fenetre.getX() + 1, fenetre.getY());
            Point coin = composant.getLocationOnScreen();
            return new Point(coin.x + x, coin.y + y);
        });
        robot.mouseMove(ou.x, ou.y);
    }

    /** L'image, une fois achevée. */
    ImageMemoire imageAchevee() throws Exception {
        attendre("l'image est achevée", () -> !etat().enCours() && etat().getImageEntiere() != null);
        return surFilEvenements(() -> etat().getImageEntiere());
    }

    /** Attend que l'image achevée soit celle-ci, quoi qui la couvre à l'écran. */
    void attendreCodes(String quoi, int[] codes) throws Exception {
        attendre(quoi, () -> etat().getImageEntiere() != null
                && Arrays.equals(etat().getImageEntiere().codes, codes));
    }

    /** Attend que l'image achevée soit celle-ci, à l'écran aussi. */
    void attendreImage(String quoi, int[] codes) throws Exception {
        attendreCodes(quoi, codes);
        attendre(quoi + ", à l'écran", () -> etat().getImageEntiere() != null
                && Ecran.trouver(codes, etat().getImageEntiere().largeur) != null);
    }

    static int[] codes(BufferedImage image) {
        int[] codes = image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
        for (int k = 0; k < codes.length; k++) {
            codes[k] |= 0xFF000000;
        }
        return codes;
    }

    /** L'état présent. */
    Etat etat() {
        return fenetre.getEtat();
    }

    /** Ce texte, où une espace insécable est une espace : {@link lancer.fenetre.vue} lie les signes à leurs mots. */
    static String delier(String texte) {
        return texte.replaceAll("\u00A0(?=[:;%?!»])", " ").replace("«\u00A0", "« ");
    }

    /** Ce que dit la ligne du bas. */
    String resume() {
        return delier(resume.getText());
    }

    void regler(Reglages voulus) {
        fenetre.recevoir(suite -> suite.regler(voulus));
    }

    /** L'observation de ce fichier, à cette version. */
    void observer(String fichier, String version) {
        fenetre.recevoir(suite -> suite.voirLeFichier(fichier, version));
    }

    double reduction() {
        return etat().ecran.loupe.getReduction(etat().getVisible().image);
    }

    /** La place de ce point de l'image, sur un écran qui a un pixel par point. */
    Point2D placeDe(double xe, double ye) {
        lancer.Point ou = etat().ecran.loupe.placeDe(etat().getVisible().image, xe, ye);
        return new Point2D.Double(ou.x, ou.y);
    }

    /** Le pixel qui est au milieu du panneau. */
    Pixel pixelVise() {
        return etat().ecran.loupe.pixelDe(etat().getVisible().image, panneau.getWidth() / 2.0, panneau.getHeight() / 2.0);
    }

    /** Le message du bandeau, vide s'il n'y en a pas. */
    String message() throws Exception {
        return surFilEvenements(() -> bandeau.isVisible() ? delier(bandeau.getText()) : "");
    }

    void attendreMessage(String debut) throws Exception {
        attendre("le message « " + debut + " »", () -> debut.isEmpty() ? !bandeau.isVisible()
                : bandeau.isVisible() && delier(bandeau.getText()).startsWith(debut));
    }

    /** Le texte copié, vide s'il n'y en a pas. */
    static String copie() throws Exception {
        Clipboard presse = Toolkit.getDefaultToolkit().getSystemClipboard();
        return presse.isDataFlavorAvailable(DataFlavor.stringFlavor) ? (String) presse.getData(DataFlavor.stringFlavor) : "";
    }

    /** Ferme la fenêtre, sans rien demander, et attend que le programme se dise fini. */
    void fermer() throws Exception {
        faire(() -> {
            for (Window w : Window.getWindows()) {
                if (w != cadre) {
                    w.dispose();
                }
            }
            if (cadre.isDisplayable()) {
                fenetre.recevoir(Suite::fermer);
            }
        });
        if (!fin.await(patienceNs, TimeUnit.NANOSECONDS)) {
            fail("la fenêtre est fermée, et le programme ne finit pas");
        }
    }

    /** Le programme dans un processus à lui, sur le même écran. */
    static ProcessBuilder processus(Path erreur, String... options) {
        List<String> commande = new ArrayList<>();
        commande.add(Paths.get(System.getProperty("java.home"), "bin", "java").toString());
        commande.add("-Dfile.encoding=UTF-8");
        commande.add("-cp");
        commande.add(Essai.origine(Main.class) + File.pathSeparator + Essai.origine(org.ini4j.Config.class));
        commande.addAll(Arrays.asList(options));
        return new ProcessBuilder(commande).redirectOutput(erreur.toFile()).redirectErrorStream(true);
    }

    /** Les fils du programme qui vivent encore et dont le nom commence ainsi. */
    static boolean vivent(String debut) {
        return Thread.getAllStackTraces().keySet().stream().anyMatch(fil -> fil.getName().startsWith(debut) && fil.isAlive());
    }

    /** Les pixels que le même programme écrit avec {@code --image}. */
    static int[] pixelsSansFenetre(Path dossier, Path scene, int largeur, int hauteur, String... options) throws IOException {
        return codes(ImageIO.read(pngSansFenetre(dossier, scene, largeur, hauteur, options).toFile()));
    }

    static Path pngSansFenetre(Path dossier, Path scene, int largeur, int hauteur, String... options) throws IOException {
        Path png = Files.createTempFile(dossier, "attendu", ".png");
        List<String> args = new ArrayList<>(Arrays.asList(options));
        args.addAll(Arrays.asList("--image", png.toString(), "--taille", largeur + "x" + hauteur, scene.toString()));
        Essai essai = Essai.executer(args.toArray(new String[0]));
        assertEquals(0, essai.code, essai.toString());
        return png;
    }
}
