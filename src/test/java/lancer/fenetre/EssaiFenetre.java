package lancer.fenetre;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.AWTError;
import java.awt.AWTException;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.datatransfer.StringSelection;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import javax.swing.tree.DefaultMutableTreeNode;
import lancer.essai.Essai;
import lancer.fenetre.etat.EssaiSuite;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Suite;
import lancer.image.ImageMemoire;
import lancer.inspection.Recit.Noeud;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Une fenêtre du programme sur un vrai écran : on y frappe, on y regarde, et on attend sans dormir pour rien. */
@Tag("fenetre")
@Timeout(900)
abstract class EssaiFenetre {

    static final int L = 320;
    static final int H = 240;
    static final String TAILLE = "--taille=" + L + "x" + H;
    static final String ROUGE = EssaiSuite.ROUGE;
    static final String BLEUE = ROUGE.replace("0.9 0.15 0.1", "0.1 0.2 0.9");

    /** Attente au-delà de laquelle cela n'arrivera plus : quarante fois la plus lente des ouvertures de fenêtre, et au moins 40 s. */
    private static volatile long patienceNs = TimeUnit.SECONDS.toNanos(40);

    @TempDir
    Path dossier;
    Path scene;
    Robot robot;
    MainLent main;
    Fenetre fenetre;
    JFrame cadre;
    JComponent panneau;
    /** Ce que l'essai retient repart avec elle, et au plus tard à sa fin : aucun fil ne reste aux essais suivants. */
    final CountDownLatch suite = new CountDownLatch(1);
    private final CountDownLatch fin = new CountDownLatch(1);

    @BeforeEach
    void ecrireLaScene() throws Exception {
        scene = dossier.resolve("boule.ini");
        ecrire(ROUGE);
    }

    @AfterEach
    void finir() throws Exception {
        suite.countDown();
        if (cadre != null) {
            fermer();
        }
    }

    void ecrire(String texte) throws Exception {
        Files.write(scene, texte.getBytes(StandardCharsets.UTF_8));
    }

    String lu() throws Exception {
        return new String(Files.readAllBytes(scene), StandardCharsets.UTF_8);
    }

    /** Le programme, ralenti si on le demande, qui ouvrira la scène. */
    MainLent lente() {
        return new MainLent(TAILLE, scene.toString());
    }

    /** Ouvre la fenêtre sur la scène, et attend son image. */
    ImageMemoire ouvrir() throws Exception {
        ouvrir(lente());
        return imageAchevee();
    }

    void ouvrir(MainLent celui) throws Exception {
        exigerEcran();
        long debut = System.nanoTime();
        main = celui;
        robot = new Robot();
        // ni l'endroit où l'essai d'avant a laissé la souris, qu'un menu ouvert dessous suivrait, ni ce qu'il a copié ne comptent
        Dimension ecran = Toolkit.getDefaultToolkit().getScreenSize();
        robot.mouseMove(ecran.width - 1, ecran.height - 1);
        Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(""), null);
        fenetre = main.ouvrir(fin::countDown);
        cadre = fenetre.getCadre();
        panneau = composant("image", JComponent.class);
        patienceNs = Math.max(patienceNs, 40 * (System.nanoTime() - debut));
    }

    /** Ferme la fenêtre, sans rien demander, et attend que le programme se dise fini. */
    void fermer() throws Exception {
        faire(() -> {
            Arrays.stream(Window.getWindows()).filter(w -> w != cadre).forEach(Window::dispose);
            if (cadre.isDisplayable()) {
                fenetre.recevoir(Suite::fermer);
            }
        });
        assertTrue(fin.await(patienceNs, TimeUnit.NANOSECONDS), "la fenêtre est fermée, et le programme ne finit pas");
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

    /** Attend la suite sans être interrompu, comme un disque lent ou une boucle sans fin. */
    void retenir() {
        while (true) {
            try {
                suite.await();
                return;
            } catch (InterruptedException e) {
                // Échap n'arrête pas ce fil
            }
        }
    }

    /** Ce conteneur et tout ce qu'il contient. */
    static List<Component> contenus(Component c) {
        List<Component> contenus = new ArrayList<>(Arrays.asList(c));
        for (Component enfant : c instanceof Container ? ((Container) c).getComponents() : new Component[0]) {
            contenus.addAll(contenus(enfant));
        }
        return contenus;
    }

    /** Le composant visible de ce nom (ou de cette classe si {@code nom} est nul), dans n'importe quelle fenêtre ; ou {@code null}. */
    static <T extends Component> T chercher(String nom, Class<T> classe) throws Exception {
        return surFilEvenements(() -> chercherIci(nom, classe));
    }

    private static <T extends Component> T chercherIci(String nom, Class<T> classe) {
        return Arrays.stream(Window.getWindows()).flatMap(w -> contenus(w).stream())
                .filter(c -> c.isShowing() && classe.isInstance(c) && (nom == null || nom.equals(c.getName()))).map(classe::cast)
                .findFirst().orElse(null);
    }

    /** Le composant de ce nom, quand il sera là. */
    static <T extends Component> T composant(String nom, Class<T> classe) throws Exception {
        List<T> trouves = new ArrayList<>();
        attendre(classe.getSimpleName() + " " + nom, () -> {
            trouves.add(chercherIci(nom, classe));
            return trouves.get(trouves.size() - 1) != null;
        });
        return trouves.get(trouves.size() - 1);
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
        mettreDevant(cadre);
        appuyer(touches);
    }

    void frapperCtrl(char lettre) throws Exception {
        frapper(KeyEvent.VK_CONTROL, KeyEvent.getExtendedKeyCodeForChar(lettre));
    }

    /** De même, quand ce composant a le clavier. */
    void frapper(JComponent ou, int... touches) throws Exception {
        mettreDevant(SwingUtilities.getWindowAncestor(ou));
        faire(ou::requestFocusInWindow);
        attendre("le clavier y est", ou::isFocusOwner);
        appuyer(touches);
    }

    private void appuyer(int... touches) {
        for (int touche : touches) {
            robot.keyPress(touche);
        }
        for (int k = touches.length - 1; k >= 0; k--) {
            robot.keyRelease(touches[k]);
        }
    }

    /** Met la vraie souris sur ce point du composant, dont la fenêtre passe devant. */
    Point viser(Component composant, int x, int y) throws Exception {
        Window sienne = SwingUtilities.getWindowAncestor(composant);
        mettreDevant(sienne);
        Point ou = surFilEvenements(() -> {
            // sans gestionnaire de fenêtres, Java croit parfois la sienne dans le coin de l'écran : bougée, il sait où elle est
            sienne.setLocation(sienne.getX() + 1, sienne.getY());
            Point coin = composant.getLocationOnScreen();
            return new Point(coin.x + x, coin.y + y);
        });
        robot.mouseMove(ou.x, ou.y);
        return ou;
    }

    void cliquer(Component composant, int x, int y) throws Exception {
        viser(composant, x, y);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }

    /** L'endroit du panneau où se voit ce point de l'image. */
    Point place(double xe, double ye) throws Exception {
        lancer.Point ou = surFilEvenements(() -> etat().ecran.loupe.placeDe(etat().getVisible().image, xe, ye));
        return new Point((int) ou.x, (int) ou.y);
    }

    /** Choisit ce fichier dans le dialogue qui s'ouvre ; rend le nom qui était proposé. */
    static String choisir(Path fichier) throws Exception {
        JFileChooser choix = composant(null, JFileChooser.class);
        // comme quelqu'un : d'abord le clavier est au dialogue, et ce qui fut frappé avant ne va plus à la fenêtre
        attendre("le clavier est au dialogue", () -> SwingUtilities.getWindowAncestor(choix).isFocused());
        String propose = surFilEvenements(() -> {
            File selection = choix.getSelectedFile();
            choix.setSelectedFile(fichier == null ? null : fichier.toFile());
            if (fichier == null) {
                choix.cancelSelection();
            } else {
                choix.approveSelection();
            }
            return selection == null ? null : selection.getName();
        });
        attendre("le dialogue est fermé", () -> !choix.isShowing());
        return propose;
    }

    /** L'image, une fois achevée. */
    ImageMemoire imageAchevee() throws Exception {
        attendre("l'image est achevée", () -> !etat().enCours() && etat().getImageEntiere() != null);
        return surFilEvenements(() -> etat().getImageEntiere());
    }

    /** Attend que l'image achevée soit celle-ci. */
    void attendreCodes(String quoi, int[] codes) throws Exception {
        attendre(quoi, () -> etat().getImageEntiere() != null && Arrays.equals(etat().getImageEntiere().codes, codes));
    }

    /** De même, à l'écran aussi. */
    void attendreImage(String quoi, int[] codes) throws Exception {
        attendreCodes(quoi, codes);
        attendre(quoi + ", à l'écran", () -> trouver(codes) != null);
    }

    /**
     * L'endroit de l'écran où se voit cette image, au pixel près, ou {@code null}. L'écran entier est fouillé : sans
     * gestionnaire de fenêtres, il arrive que Java se trompe sur l'endroit où est la sienne.
     */
    static Point trouver(int[] image) throws AWTException {
        Rectangle ecran = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
        int[] vu = codes(new Robot().createScreenCapture(ecran));
        // un pixel qui n'est pas de la couleur du coin écarte d'un coup tout fond de cette couleur
        int temoin = IntStream.range(0, image.length).filter(k -> image[k] != image[0]).findFirst().orElse(0);
        return IntStream.range(0, vu.length)
                .filter(k -> k % ecran.width <= ecran.width - L && k / ecran.width <= ecran.height - image.length / L)
                .filter(k -> vu[k + temoin / L * ecran.width + temoin % L] == image[temoin])
                .filter(k -> IntStream.range(0, image.length).allMatch(i -> vu[k + i / L * ecran.width + i % L] == image[i]))
                .mapToObj(k -> new Point(k % ecran.width, k / ecran.width)).findFirst().orElse(null);
    }

    static int[] codes(BufferedImage image) {
        int[] codes = image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
        Arrays.setAll(codes, k -> codes[k] | 0xFF000000);
        return codes;
    }

    /** Les pixels que le programme écrit de la scène, sans fenêtre. */
    int[] attendue(String... options) throws Exception {
        return codes(ImageIO.read(pngSansFenetre(options).toFile()));
    }

    Path pngSansFenetre(String... options) throws Exception {
        Path png = Files.createTempFile(dossier, "attendu", ".png");
        List<String> args = new ArrayList<>(Arrays.asList(options));
        args.addAll(Arrays.asList("--image", png.toString(), TAILLE, scene.toString()));
        Essai essai = Essai.executer(args.toArray(new String[0]));
        assertEquals(0, essai.code, essai.toString());
        return png;
    }

    Etat etat() {
        return fenetre.getEtat();
    }

    /** Ce texte, où une espace insécable est une espace : {@link lancer.fenetre.vue} lie les signes à leurs mots. */
    static String delier(String texte) {
        return texte.replaceAll("\u00A0(?=[:;%?!»])", " ").replace("«\u00A0", "« ");
    }

    /** Attend que ce texte, comme la ligne du bas, « resume », le bandeau, « message », ou le verdict, commence ainsi. */
    static void attendreTexte(String nom, String debut) throws Exception {
        JTextArea texte = composant(nom, JTextArea.class);
        attendre(nom + " dit « " + debut + " »", () -> delier(texte.getText()).startsWith(debut));
    }

    static void attendreMessage(String debut) throws Exception {
        if (debut.isEmpty()) {
            attendre("plus de message", () -> chercherIci("message", JTextArea.class) == null);
        } else {
            attendreTexte("message", debut);
        }
    }

    /** Les lignes qui se voient du récit, à demander sur le fil des événements. */
    static String lu(JTree recit) {
        return IntStream.range(0, recit.getRowCount()).mapToObj(r -> ((Noeud) ((DefaultMutableTreeNode) recit.getPathForRow(r)
                .getLastPathComponent()).getUserObject()).texte).collect(Collectors.joining("\n"));
    }

    /** Les fils du programme qui vivent encore et dont le nom commence ainsi. */
    static boolean vivent(String debut) {
        return Thread.getAllStackTraces().keySet().stream().anyMatch(fil -> fil.getName().startsWith(debut) && fil.isAlive());
    }
}
