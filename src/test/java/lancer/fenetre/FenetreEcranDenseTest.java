package lancer.fenetre;

import static lancer.fenetre.EssaiFenetre.H;
import static lancer.fenetre.EssaiFenetre.L;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.AWTException;
import java.awt.Color;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import lancer.essai.Essai;
import lancer.essai.EssaiProcessus;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Le programme sur un écran qui a deux pixels par point. */
@Tag("fenetre")
@Timeout(900)
class FenetreEcranDenseTest extends EssaiProcessus {

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
        Point ici = Ecran.trouver(attendue, L);
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
}
