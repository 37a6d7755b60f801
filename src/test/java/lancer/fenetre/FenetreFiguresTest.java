package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.AWTException;
import java.awt.Color;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import lancer.image.ImageMemoire;
import javax.swing.JPanel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Les figures de l'inspecteur, par-dessus l'image et vues de côté. */
class FenetreFiguresTest extends EssaiInspecteur {

    private Process programme;

    @Test
    void echapArreteDAbordUnDessinPuisFermeEtLaFigureSEnVa() throws Exception {
        ouvrir();
        int[] codes = attendue(L, H);
        banc.attendreImage("sans figure", codes);
        cliquer(150, 110);
        attendreRecit(couleur(codes[110 * L + 150]));
        attendre("la figure est sur l'image", () -> Ecran.trouver(codes, L) == null);
        assertArrayEquals(codes, banc.etat().getImageEntiere().codes, "et pas dans l'image");
        ImageMemoire avant = banc.etat().getImageEntiere();
        banc.main.lent();
        banc.frapper(KeyEvent.VK_F5);
        attendre("le dessin recommence", () -> banc.etat().enCours() && banc.etat().montre.dessin.image != avant);
        presser(KeyEvent.VK_ESCAPE);
        attendre("le dessin est arrêté", () -> !banc.etat().enCours());
        assertNotNull(inspecteur(), "mais l'inspecteur reste");
        attendreVerdict("L'image n'est pas achevée");
        banc.main.lent = false;
        JPanel ouvert = inspecteur();
        presser(KeyEvent.VK_ESCAPE);
        attendre("l'inspecteur se ferme", () -> !ouvert.isShowing());
        banc.frapper(KeyEvent.VK_F5);
        banc.attendreImage("sans figure de nouveau", codes);
    }

    @Test
    void aLaLoupeLePixelQueMenentLesFlechesResteEnVue() throws Exception {
        ouvrir();
        ouvrirAuMilieu();
        presser(KeyEvent.VK_SHIFT, KeyEvent.VK_UP);
        presser(KeyEvent.VK_SHIFT, KeyEvent.VK_UP);
                for (int k = 0; k < 4; k++) {
            presser(KeyEvent.VK_CONTROL, KeyEvent.VK_UP);
        }
        attendre("la loupe est au plus fort", () -> banc.reduction() == 16);
        attendreEnVue(L / 2, H / 2 - 20);
        for (int k = 1; k <= 3; k++) {
            presser(KeyEvent.VK_SHIFT, KeyEvent.VK_LEFT);
            attendreEnVue(L / 2 - 10 * k, H / 2 - 20);
        }
    }

    private void attendreEnVue(int x, int y) throws Exception {
                attendreTitre(x, y);
        // autour du milieu, la moitié de ce que la loupe laisse voir
        attendre("il est en vue", () -> Math.abs(banc.pixelVise().x - x) <= banc.panneau.getWidth() / 32
                && Math.abs(banc.pixelVise().y - y) <= banc.panneau.getHeight() / 32);
    }

    @AfterEach
    void arreterLeProgramme() {
        if (programme != null) {
            programme.destroyForcibly();
        }
    }

    @Test
    void surUnEcranDenseUnPixelEnEstUnEtLAnneauEntoureLePixelCliqueLoupeComprise() throws Exception {
        BancFenetre.exigerEcran();
        int[] attendue = attendue(L, H);
        assertTrue(IntStream.range(0, L * H).allMatch(k -> Math.hypot(k % L - 150, k / L - 110) > 22 || plusSombre(attendue[k]) < 200),
                "rien de clair, là où se verra l'anneau");
        programme = BancFenetre.processus(dossier.resolve("dit.txt"), "-Dsun.java2d.uiScale=2", "lancer.Main", TAILLE,
                scene.toString()).start();
        Robot robot = new Robot();
        Point coin = new Point();
        attendre("l'image", () -> voir(attendue, coin));
        cliquer(robot, coin);
        attendre("la figure la couvre", () -> !voir(attendue, coin));
        // sur un si petit écran, le panneau déplace l'image en s'ouvrant ; F2 y cache la figure : elle se retrouve
        attendre("l'image, à sa nouvelle place", () -> {
            robot.keyPress(KeyEvent.VK_F2);
            robot.keyRelease(KeyEvent.VK_F2);
            return voir(attendue, coin);
        });
        cliquer(robot, coin);
        // la souris compte en points, de deux pixels : le pixel visé est le premier des siens
        Point vise = new Point(150 - coin.x % 2, 110 - coin.y % 2);
        attendre("l'anneau", () -> estEntoure(robot, coin.x + vise.x + 0.5, coin.y + vise.y + 0.5));
        robot.mouseWheel(-1);
        robot.mouseWheel(-1);
        robot.mouseWheel(-1);
        attendre("l'image est grossie huit fois, et le milieu du pixel reste où il est",
                () -> estGrossie(robot, attendue, coin, vise));
        attendre("l'anneau, à la loupe", () -> estEntoure(robot, coin.x + vise.x + 0.5, coin.y + vise.y + 0.5));
        attendre("Ctrl+Q termine le programme", () -> {
            robot.keyPress(KeyEvent.VK_CONTROL);
            robot.keyPress(KeyEvent.VK_Q);
            robot.keyRelease(KeyEvent.VK_Q);
            robot.keyRelease(KeyEvent.VK_CONTROL);
            return programme.waitFor(500, TimeUnit.MILLISECONDS);
        });
        assertEquals(0, programme.exitValue());
        assertEquals(0, Files.size(dossier.resolve("dit.txt")));
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
