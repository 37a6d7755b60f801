package lancer.fenetre;

import static lancer.fenetre.EssaiFenetre.H;
import static lancer.fenetre.EssaiFenetre.L;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.AWTException;
import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import lancer.Main;
import lancer.essai.Essai;
import lancer.essai.EssaiProcessus;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Un programme dont la fenêtre s'ouvre, dans sa machine virtuelle : arrêté pendant qu'il dessine, ou mal installé. */
@Tag("fenetre")
@Timeout(900)
class FenetreProcessusTest extends EssaiProcessus {

    @Test
    void ctrlCFenetreOuverteRend130() throws Exception {
        EssaiFenetre.exigerEcran();
        verifierCtrlC("--taille=400x300", SCENE);
    }

    @Test
    void fermerLaFenetrePendantLeDessinFinitLeProgrammeSansRienDireEtLesTouchesYSontEnFrancais() throws Exception {
        EssaiFenetre.exigerEcran();
        List<String> commande = java("-Duser.language=en", "--taille=1200x700", "--reflets=1000", "--seuil=0", SCENE);
        int classe = commande.indexOf("lancer.Main");
        commande.set(classe, FermerEnDessinant.class.getName());
        commande.set(classe - 1, commande.get(classe - 1) + File.pathSeparator + Essai.origine(FenetreProcessusTest.class));
        assertEquals(0, statut(preparer(commande)), erreur());
        assertEquals("", erreur());
        assertEquals("Page suivante", sortie().trim());
        verifierDossier();
    }

    @Test
    void uneClasseDAccessibiliteAbsenteNEstPasUnEcranAbsent() throws Exception {
        EssaiFenetre.exigerEcran();
        assertEquals(1, statut(preparer(java("-Djavax.accessibility.assistive_technologies=absente.Classe", SCENE))));
        assertTrue(erreur().contains("absente.Classe") && !erreur().contains("pas d'écran"), erreur());
        assertEquals(1, erreur().split("\n").length, erreur());
    }

    /** Aucune fenêtre n'est faite : rien d'autre ne s'écrit que cette ligne, et le statut est 1. */
    @Test
    void sansPolicesUneLigneNommeLesPaquets() throws Exception {
        EssaiFenetre.exigerEcran();
        File polices = new File("/usr/lib/x86_64-linux-gnu/libfontconfig.so.1");
        assumeTrue(polices.exists() && new File("/usr/bin/bwrap").exists(), "ni fontconfig à cacher, ni bwrap");
        List<String> commande = new ArrayList<>(Arrays.asList("bwrap", "--dev-bind", "/", "/", "--bind", "/dev/null",
                polices.getCanonicalPath()));
        commande.addAll(java("", SCENE));
        assertEquals(1, statut(preparer(commande)));
        assertTrue(erreur().matches("lancer : pas de polices .* les paquets fontconfig et fonts-dejavu-core, ou --image FICHIER.png\n"),
                erreur());
    }

    @Test
    void unEcranDeTrenteBitsEstDitTel() throws Exception {
        assumeTrue(new File("/usr/bin/Xvfb").exists() && new File("/usr/bin/xvfb-run").exists(), "pas de Xvfb");
        List<String> commande = new ArrayList<>(Arrays.asList("xvfb-run", "-a", "-s", "-screen 0 640x480x30"));
        commande.addAll(java("", SCENE));
        assertEquals(1, statut(preparer(commande)));
        assertTrue(erreur().matches("lancer : écran de 30 bits, .* attendu : un écran de 24 bits, ou --image FICHIER.png\n"), erreur());
    }

    @Test
    void unUtilisateurSansDossierNEnAPasUnDeCeNom() throws Exception {
        EssaiFenetre.exigerEcran();
        processus = preparer(java("-Duser.home=?", "--statistiques", "--taille=32x24", SCENE)).start();
        attendre(() -> sortie().contains("trace.ms") || !processus.isAlive());
        assertTrue(processus.isAlive(), erreur());
        assertEquals(Arrays.asList("flux"), Arrays.asList(dossier.toFile().list()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", ":98765"})
    void sansEcranUneLigneProposeDeSePasserDeFenetre(String affichage) throws Exception {
        // ailleurs qu'avec X11, l'écran ne se cache pas par une variable, et une fenêtre s'ouvrirait
        assumeTrue(System.getProperty("os.name").equals("Linux"), "pas un Linux");
        ProcessBuilder programme = preparer(java("", SCENE));
        programme.environment().put("DISPLAY", affichage);
        assertEquals(1, statut(programme));
        assertTrue(erreur().matches("lancer : .*--image.*\\R"), erreur());
    }

    /** Le même Java, sans la bibliothèque qui ouvre des fenêtres sous X11, que certains paquets n'ont pas. */
    @Test
    void unJavaSansFenetresDevantUnEcranLeDitAuLieuDeNierLEcran() throws Exception {
        EssaiFenetre.exigerEcran();
        Path vrai = Paths.get(System.getProperty("java.home")).toRealPath();
        assumeTrue(Files.exists(vrai.resolve("lib/libawt_xawt.so")), "pas un Java de Linux");
        Path java = dossier.resolve("java");
        Files.createDirectories(java.resolve("lib/server"));
        Files.createDirectories(java.resolve("bin"));
        Files.copy(vrai.resolve("bin/java"), java.resolve("bin/java"));
        Path classes = Files.createSymbolicLink(java.resolve("lib/modules"), vrai.resolve("lib/modules"));
        for (String ou : new String[] {"lib", "lib/server"}) {
            for (File f : vrai.resolve(ou).toFile().listFiles()) {
                // Java cherche ses bibliothèques à côté d'elles-mêmes, et non de leurs liens
                if (f.getName().matches("(?!libawt_xawt).*\\.(so|cfg|dat)")) {
                    Files.copy(f.toPath(), java.resolve(ou).resolve(f.getName()));
                }
            }
        }
        List<String> commande = java("", SCENE);
        commande.set(0, java.resolve("bin/java").toString());
        assertEquals(1, statut(preparer(commande)));
        Files.delete(classes);
        assertTrue(erreur().matches("lancer : impossible d'ouvrir une fenêtre : .*default-jdk.*--image.*\\R"), erreur());
    }

    @Test
    void surUnEcranDenseUnPixelEnEstUnEtLAnneauEntoureLePixelCliqueLoupeComprise() throws Exception {
        EssaiFenetre.exigerEcran();
        Path scene = Essai.scene(dossier.resolve("boule.ini"), EssaiFenetre.ROUGE);
        Path png = dossier.resolve("attendue.png");
        Essai.executer(EssaiFenetre.TAILLE, "--image", png.toString(), scene.toString());
        int[] attendue = EssaiFenetre.codes(ImageIO.read(png.toFile()));
        assertTrue(IntStream.range(0, L * H).allMatch(k -> Math.hypot(k % L - 150, k / L - 110) > 22 || plusSombre(attendue[k]) < 200),
                "rien de clair, là où se verra l'anneau");
        processus = preparer(java("-Dsun.java2d.uiScale=2 -Djava.util.prefs.userRoot=" + dossier, EssaiFenetre.TAILLE,
                scene.toString())).start();
        Robot robot = new Robot();
        Point coin = new Point();
        EssaiFenetre.attendre("l'image", () -> voir(attendue, coin));
        cliquer(robot, coin);
        EssaiFenetre.attendre("la figure la couvre", () -> !voir(attendue, coin));
        // sur un si petit écran, le panneau déplace l'image en s'ouvrant ; F2 y cache la figure : elle se retrouve
        EssaiFenetre.attendre("l'image, à sa nouvelle place", () -> {
            robot.keyPress(KeyEvent.VK_F2);
            robot.keyRelease(KeyEvent.VK_F2);
            return voir(attendue, coin);
        });
        cliquer(robot, coin);
        // la souris compte en points, de deux pixels : le pixel visé est le premier des siens
        Point vise = new Point(150 - coin.x % 2, 110 - coin.y % 2);
        EssaiFenetre.attendre("l'anneau", () -> estEntoure(robot, coin.x + vise.x + 0.5, coin.y + vise.y + 0.5));
        robot.mouseWheel(-1);
        robot.mouseWheel(-1);
        robot.mouseWheel(-1);
        EssaiFenetre.attendre("l'image est grossie huit fois, et le milieu du pixel reste où il est",
                () -> estGrossie(robot, attendue, coin, vise));
        EssaiFenetre.attendre("l'anneau, à la loupe", () -> estEntoure(robot, coin.x + vise.x + 0.5, coin.y + vise.y + 0.5));
        EssaiFenetre.attendre("Ctrl+Q termine le programme", () -> {
            robot.keyPress(KeyEvent.VK_CONTROL);
            robot.keyPress(KeyEvent.VK_Q);
            robot.keyRelease(KeyEvent.VK_Q);
            robot.keyRelease(KeyEvent.VK_CONTROL);
            return processus.waitFor(500, TimeUnit.MILLISECONDS);
        });
        assertEquals(0, processus.exitValue());
        assertEquals("", sortie() + erreur());
    }

    /** Vrai si l'on voit cette image entière, dont le coin est alors celui-ci. */
    private static boolean voir(int[] attendue, Point coin) throws AWTException {
        Point ici = EssaiFenetre.trouver(attendue);
        coin.setLocation(ici == null ? coin : ici);
        return ici != null;
    }

    private static void cliquer(Robot robot, Point coin) {
        robot.mouseMove(coin.x + 150, coin.y + 110);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }

    /** Vrai si l'on voit presque partout du blanc autour, au rayon d'un anneau pour des caractères deux fois plus grands. */
    private static boolean estEntoure(Robot robot, double x, double y) {
        int blancs = 0;
        for (int k = 0; k < 16; k++) {
            int plusClair = 0;
            for (double rayon = 16; rayon <= 20; rayon += 0.5) {
                Color vu = robot.getPixelColor((int) (x + rayon * Math.cos(k * Math.PI / 8)),
                        (int) (y + rayon * Math.sin(k * Math.PI / 8)));
                plusClair = Math.max(plusClair, plusSombre(vu.getRGB()));
            }
            blancs += plusClair > 200 ? 1 : 0;
        }
        // les traits qui partent de là le recouvrent
        return blancs >= 12;
    }

    private static int plusSombre(int code) {
        return Math.min(code & 0xFF, Math.min(code >> 8 & 0xFF, code >> 16 & 0xFF));
    }

    /**
     * Vrai si l'on voit, hors de l'anneau et des traits, les pixels des environs huit fois plus grands, à un pixel de l'écran près,
     * le pixel visé à sa place.
     */
    private static boolean estGrossie(Robot robot, int[] attendue, Point coin, Point vise) {
        BufferedImage vue = robot.createScreenCapture(new Rectangle(coin.x + vise.x - 100, coin.y + vise.y - 100, 200, 200));
        int vus = 0;
        int cherches = 0;
        for (int dx = -11; dx <= 11; dx++) {
            for (int dy = -11; dy <= 11; dy++) {
                if (Math.hypot(dx, dy) > 4) {
                    int code = attendue[(vise.y + dy) * L + vise.x + dx];
                    cherches++;
                    // presque aux deux coins opposés de son carré
                    vus += vue.getRGB(97 + 8 * dx, 97 + 8 * dy) == code && vue.getRGB(103 + 8 * dx, 103 + 8 * dy) == code ? 1 : 0;
                }
            }
        }
        return vus > 0.8 * cherches;
    }

    /** Le programme, dont la fenêtre est fermée comme par la croix dès que l'image s'y dessine. */
    static final class FermerEnDessinant {

        private FermerEnDessinant() {
        }

        public static void main(String[] args) throws Exception {
            Main.main(args);
            while (!EssaiFenetre.vivent("lancer-1")) {
                Thread.sleep(1);
            }
            Frame fenetre = Frame.getFrames()[0];
            System.out.println(KeyEvent.getKeyText(KeyEvent.VK_PAGE_DOWN));
            // la croix se clique dans le fil des événements
            EventQueue.invokeAndWait(() -> fenetre.dispatchEvent(new WindowEvent(fenetre, WindowEvent.WINDOW_CLOSING)));
        }
    }
}
