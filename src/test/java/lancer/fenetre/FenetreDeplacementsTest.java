package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JOptionPane;
import lancer.Sphere;
import lancer.fenetre.etat.Prise;
import org.junit.jupiter.api.Test;

/** Ce qui est tiré n'est jamais perdu sans être dit ou demandé, quoi qui se lise ou s'écrive pendant ce temps. */
class FenetreDeplacementsTest extends EssaiFenetre {

    private lancer.Point centre() throws Exception {
        return surFilEvenements(() -> ((Sphere) banc.etat().demande.lue.objets.get(0)).getCentre());
    }

    private Point place() throws Exception {
        lancer.Point centre = centre();
        return surFilEvenements(() -> {
            lancer.Point vue = Prise.projeter(banc.etat().montre.dessin.lancer.getCamera(), centre);
            Point2D ou = banc.placeDe(vue.x, vue.y);
            return new Point((int) ou.getX(), (int) ou.getY());
        });
    }

    private void saisir() throws Exception {
        Point ou = place();
        banc.viser(banc.panneau, ou.x, ou.y);
        banc.robot.keyPress(KeyEvent.VK_SHIFT);
        banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.waitForIdle();
    }

    /** Mène la souris à tant de pixels de là. */
    private void mener(Point de, int dx, int dy) throws Exception {
        Point coin = surFilEvenements(banc.panneau::getLocationOnScreen);
        for (int k = 1; k <= 4; k++) {
            banc.robot.mouseMove(coin.x + de.x + dx * k / 4, coin.y + de.y + dy * k / 4);
            banc.robot.waitForIdle();
        }
    }

    private void lacher() {
        banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.keyRelease(KeyEvent.VK_SHIFT);
        banc.robot.waitForIdle();
    }

    private void tirer(int dx, int dy) throws Exception {
        Point de = place();
        saisir();
        mener(de, dx, dy);
        lacher();
    }

    private String fichier() throws Exception {
        return new String(Files.readAllBytes(scene), StandardCharsets.UTF_8);
    }

    private void repondre(String reponse) throws Exception {
        JOptionPane question = composant(null, JOptionPane.class);
        assertEquals("Ce qui est changé dans « boule.ini » n'y est pas écrit.", question.getMessage());
        faire(() -> question.setValue(reponse));
        attendre("la question est fermée", () -> !question.isShowing());
    }

    @Test
    void ouvrirUneAutreSceneOuQuitterDemandeCeQuiEstAFaireDeCeQuiEstTire() throws Exception {
        ouvrir();
        Path autre = dossier.resolve("autre.ini");
        Files.write(autre, BLEUE.getBytes(StandardCharsets.UTF_8));
        tirer(20, 0);
        lancer.Point voulu = centre();
        banc.frapperCtrl('q');
        repondre("Rester");
        assertTrue(banc.cadre.isDisplayable());
        assertEquals(voulu, centre());
        banc.frapperCtrl('o');
        choisir(autre);
        repondre("Écrire");
        attendre("l'autre est ouverte", () -> banc.cadre.getTitle().equals("lancer — autre.ini"));
        assertTrue(fichier().contains("centre=" + lancer.scene.SceneLue.ecrire(voulu)), fichier());
        attendre("et dessinée", () -> !banc.etat().montreUneAutre());
        banc.imageAchevee();
        String ecrit = fichier();
        banc.frapperCtrl('o');
        choisir(scene);
        attendre("rien n'y est tiré, rien n'est demandé", () -> !banc.etat().montreUneAutre()
                && banc.cadre.getTitle().equals("lancer — boule.ini"));
        banc.imageAchevee();
        tirer(20, 0);
        banc.frapperCtrl('q');
        repondre("Oublier");
        attendre("fermée", () -> !banc.cadre.isDisplayable());
        assertEquals(ecrit, fichier());
    }

    @Test
    void echapRemetCeQuiEstTireUnClicDroitNonEtCeQuiNeBougePasGardeSesDecimales() throws Exception {
        ecrire(ROUGE.replace("0 0.2 6", "0 0.123456789 6"));
        ouvrir();
        lancer.Point avant = centre();
        Point de = place();
        saisir();
        mener(de, 30, 0);
        banc.robot.mousePress(InputEvent.BUTTON3_DOWN_MASK);
        banc.robot.mouseRelease(InputEvent.BUTTON3_DOWN_MASK);
        mener(de, 60, 0);
        assertEquals(60, place().x - de.x, 1, "le clic droit ne lâche rien");
        assertEquals(0.123456789, centre().y);
        assertFalse(banc.bandeau.isVisible(), "le bas de l'image se voit");
        assertTrue(banc.resume().startsWith("[Sphere 1] ligne 1 : centre="), banc.resume());
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("il revient", () -> centreIci().equals(avant));
        mener(de, 80, 0);
        lacher();
        assertEquals(avant, centre());
        assertFalse(banc.cadre.getTitle().endsWith("•"));
    }

    private lancer.Point centreIci() {
        return ((Sphere) banc.etat().demande.lue.objets.get(0)).getCentre();
    }
}
