package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
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
import lancer.Sphere;
import lancer.commande.Option;
import lancer.fenetre.figures.Figure;
import lancer.scene.SceneLue;
import org.junit.jupiter.api.Test;

/** Ce que la fenêtre montre en classe : une boule qui se prend, des vues en fausses couleurs. */
class FenetreLeconTest extends EssaiFenetre {

    private Point centre() throws Exception {
        return surFilEvenements(this::centreIci);
    }

    private Point centreIci() {
        return place(sphere(0).getCentre());
    }

    private Point place(lancer.Point p) {
        lancer.Point vue = Figure.projeter(banc.controleur.getEtat().montre.dessin.lancer.getCamera(), p);
        Point2D ou = banc.panneau.placeDe(vue.x, vue.y);
        return new Point((int) ou.getX(), (int) ou.getY());
    }

    private Sphere sphere(int rang) {
        return (Sphere) banc.controleur.getEtat().demande.lue.objets.get(rang);
    }

    /** Tire, Maj tenue, d'autant de pixels. */
    private void tirer(Point de, int dx, int dy) throws Exception {
        saisir(de);
        glisser(de, dx, dy);
    }

    private void saisir(Point ou) throws Exception {
        banc.viser(banc.panneau, ou.x, ou.y);
        banc.robot.keyPress(KeyEvent.VK_SHIFT);
        banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    }

    private void glisser(Point de, int dx, int dy) throws Exception {
        Point coin = surFilEvenements(banc.panneau::getLocationOnScreen);
        for (int k = 1; k <= 4; k++) {
            banc.robot.mouseMove(coin.x + de.x + dx * k / 4, coin.y + de.y + dy * k / 4);
            banc.robot.waitForIdle();
        }
        banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.keyRelease(KeyEvent.VK_SHIFT);
        banc.robot.waitForIdle();
    }

    private String fichier() throws Exception {
        return new String(Files.readAllBytes(scene), StandardCharsets.UTF_8);
    }

    @Test
    void uneBouleTireeParMajEtLaSourisResteEnMemoireEtCtrlZLaRemet() throws Exception {
        int[] avant = ouvrir().codes;
        String titre = banc.cadre.getTitle();
        Point de = centre();
        tirer(de, 40, -20);
        Point a = centre();
        assertEquals(40, a.x - de.x, 1);
        assertEquals(-20, a.y - de.y, 1);
        assertEquals(6, sphere(0).getCentre().z, "dans le plan parallèle à l'écran");
        assertTrue(banc.message().startsWith("[Sphere 1] ligne 1 : centre="), banc.message());
        attendre("un point dans le titre", () -> banc.cadre.getTitle().equals(titre + " •"));
        int[] unefois = banc.imageAchevee().codes;
        assertEquals(ROUGE, fichier(), "rien ne s'est écrit");
        tirer(centre(), -10, 0);
        banc.frapperCtrl('z');
        banc.attendreCodes("Ctrl+Z défait un déplacement", unefois);
        banc.frapperCtrl('z');
        banc.attendreCodes("puis l'autre", avant);
        attendre("plus de point", () -> banc.cadre.getTitle().equals(titre) && !article("Défaire le déplacement").isEnabled());
    }

    @Test
    void ctrlEEcritDansLaSceneLaSeuleLigneDeCeQuiEstDeplace() throws Exception {
        String ini = "; une scène\r\n" + ROUGE.replace("centre=0 0.2 6", "Centre = 0 0.2 6 ").replace("\n", "\r\n");
        ecrire(ini);
        ouvrir();
        tirer(centre(), 40, -20);
        lancer.Point voulu = sphere(0).getCentre();
        int[] deplacee = banc.imageAchevee().codes;
        banc.frapperCtrl('e');
        attendre("elle est écrite", () -> !banc.cadre.getTitle().endsWith("•") && !banc.controleur.getEtat().enCours
                && banc.controleur.getEtat().montre.dessin.demande.lue.objets.get(0) == sphere(0));
        String ecrit = fichier();
        String valeur = ecrit.substring(ecrit.indexOf("Centre = ") + 9, ecrit.indexOf(" \r\nrayon=1\r"));
        assertEquals(ini.replace("0 0.2 6", valeur), ecrit);
        assertEquals(voulu, sphere(0).getCentre());
        banc.attendreCodes("l'image est la même", deplacee);
        assertEquals("écrit dans boule.ini", banc.message());
    }

    @Test
    void vueDeDerriereUneBouleSuitAussiLaSourisEtSEcritOuElleEst() throws Exception {
        String ini = "[Camera]\noeil=3 4 16\ncible=0 0 6\nchamp=40\n" + ROUGE;
        ecrire(ini);
        ouvrir();
        Point de = centre();
        tirer(de, 40, -20);
        assertEquals(de.x + 40, centre().x, 1);
        assertEquals(de.y - 20, centre().y, 1);
        lancer.Point voulu = sphere(0).getCentre();
        assertTrue(voulu.x < -0.1 && voulu.y > 0.3, "à droite de l'image, c'est vers les x négatifs : " + voulu);
        banc.imageAchevee();
        banc.frapperCtrl('e');
        attendre("écrite", () -> !banc.cadre.getTitle().endsWith("•"));
        assertEquals(ini.replace("0 0.2 6", SceneLue.ecrire(voulu)), fichier());
    }

    @Test
    void unFichierQuiAChangeEntreTempsNEstPasTouche() throws Exception {
        ouvrir();
        tirer(centre(), 40, -20);
        banc.imageAchevee();
        // avant que la surveillance ne le relise
        faire(() -> {
            try {
                ecrire(BLEUE);
            } catch (Exception e) {
                throw new IllegalStateException(e);
            }
            article(0, "Écrire dans la scène").doClick();
        });
        attendre("le message le dit", () -> banc.panneau.bandeau.getText().contains("a changé depuis sa lecture")
                || banc.panneau.bandeau.getText().contains("est oublié"));
        assertEquals(BLEUE, fichier());
        attendre("relue, elle n'a plus rien de déplacé", () -> banc.panneau.bandeau.getText().contains(
                "ce qui était déplacé dans boule.ini sans être écrit est oublié"));
        banc.attendreCodes("l'image est celle du fichier", attendue(L, H));
    }

    @Test
    void leCielNiUnSolNeSePrennentEtLaFenetreLeDit() throws Exception {
        ecrire("[Sphere sol]\ncentre=0 -19892.188 2099.569\nrayon=20000\nKd=0.5 0.5 0.5\n" + ROUGE);
        ouvrir();
        Point coin = new Point((banc.panneau.getWidth() - L) / 2, (banc.panneau.getHeight() - H) / 2);
        for (Point ou : new Point[] {new Point(coin.x + 30, coin.y + 20), new Point(coin.x + 300, coin.y + 235)}) {
            saisir(ou);
            // cet avis s'efface au bout de quelques secondes
            banc.attendreMessage("rien ne se tire ici");
            glisser(ou, 10, 0);
            assertFalse(banc.cadre.getTitle().contains("•"), "rien n'est déplacé");
            fermerLeMessage();
        }
    }

    @Test
    void uneLampeQuiSeVoitSePrendParSonEtoile() throws Exception {
        ecrire(ROUGE.replace("-4 6 -3", "0 1.5 5"));
        ouvrir();
        tirer(surFilEvenements(() -> place(banc.controleur.getEtat().demande.lue.lampes.get(0).getPosition())), -30, 10);
        attendre("elle est plus à gauche", () -> banc.controleur.getEtat().demande.lue.lampes.get(0).getPosition().x < -0.2);
    }

    @Test
    void chaqueVueEstCelleDeLaLigneDeCommandeEtDitSaValeurSousLaSouris() throws Exception {
        ouvrir();
        String[] dits = {"N = .*", "d = \\d+\\.\\d+", "lampes : \\d", "rayons : \\d+", "marge : \\d+ décimales .*"};
        for (int k = 0; k < dits.length; k++) {
            String nom = Option.VUES.get(k);
            int rang = k;
            faire(article(1, "Vue : " + nom)::doClick);
            banc.attendreImage(nom, attendue("--vue=" + nom));
            attendre("elle se dit", () -> banc.resume.getText().startsWith("vue " + nom + " : "));
            banc.viser(banc.panneau, banc.panneau.getWidth() / 2 + k % 2, banc.panneau.getHeight() / 2);
            attendre("sa valeur sous la souris", () -> banc.pixel.getText().matches("pixel .* " + dits[rang]));
        }
        faire(article(1, "Vue : normales")::doClick);
        attendre("une autre vue", () -> banc.resume.getText().startsWith("vue normales"));
        banc.viser(banc.panneau, (banc.panneau.getWidth() - L) / 2 + 5, (banc.panneau.getHeight() - H) / 2 + 5);
        attendre("le ciel se dit", () -> banc.pixel.getText().endsWith(" ciel"));
        faire(article(1, "Vue : image")::doClick);
        banc.attendreImage("et l'on revient à l'image", attendue(L, H));
    }
}
