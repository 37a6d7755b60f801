package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Container;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import javax.swing.JPanel;
import javax.swing.JTextField;
import lancer.Sphere;
import lancer.commande.Option;
import lancer.fenetre.etat.Prise;
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
        lancer.Point vue = Prise.projeter(banc.etat().montre.dessin.lancer.getCamera(), p);
        Point2D ou = banc.placeDe(vue.x, vue.y);
        return new Point((int) ou.getX(), (int) ou.getY());
    }

    private Sphere sphere(int rang) {
        return (Sphere) banc.etat().demande.lue.objets.get(rang);
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
        attendre("plus de point", () -> banc.cadre.getTitle().equals(titre) && !article("Défaire le changement").isEnabled());
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
        attendre("elle est écrite", () -> !banc.cadre.getTitle().endsWith("•") && !banc.etat().enCours()
                && banc.etat().montre.dessin.demande.lue.objets.get(0) == sphere(0));
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
    void unFichierQuiAChangeEntreTempsNEstPasLuEtCtrlEYEcritLeChangement() throws Exception {
        ouvrir();
        tirer(centre(), 40, -20);
        lancer.Point voulu = sphere(0).getCentre();
        banc.imageAchevee();
        ecrire(BLEUE);
        attendre("le bandeau le dit", () -> banc.bandeau.getText().contains("boule.ini a changé sur le disque"));
        assertEquals(voulu, sphere(0).getCentre());
        banc.frapperCtrl('e');
        attendre("écrit et relu", () -> !banc.cadre.getTitle().endsWith("•") && banc.etat().getOccupation() == null);
        assertEquals(BLEUE.replace("0 0.2 6", SceneLue.ecrire(voulu)), fichier());
        banc.attendreCodes("l'image est celle du fichier", attendue(L, H));
        banc.attendreMessage("écrit dans boule.ini");
    }

    @Test
    void unNombreSeTapeDansLOngletPixelEtLImageSuit() throws Exception {
        ouvrir();
        banc.cliquer(banc.panneau, centre().x, centre().y);
        JTextField rayon = composant("rayon", JTextField.class);
        assertEquals("1", surFilEvenements(rayon::getText));
        taper(rayon, "-2");
        banc.attendreMessage(scene + ", ligne 3, [Sphere 1], rayon : hors limites : « -2 » ; attendu : ");
        assertEquals("-2", surFilEvenements(rayon::getText), "elle reste à corriger");
        taper(rayon, "0.80");
        attendre("elle est prise", () -> sphere(0).getRayon() == 0.8);
        banc.attendreMessage("");
        banc.frapper(KeyEvent.VK_UP);
        banc.frapper(KeyEvent.VK_SHIFT, KeyEvent.VK_UP);
        attendre("un centième, puis dix", () -> sphere(0).getRayon() == 0.91 && rayon.getText().equals("0.91"));
        JTextField couleur = composant("Kd", JTextField.class);
        taper(couleur, "0 0 1");
        attendre("la couleur aussi", () -> sphere(0).getKd().b == 1);
        banc.imageAchevee();
        banc.frapperCtrl('e');
        attendre("écrits", () -> !banc.cadre.getTitle().endsWith("•"));
        assertEquals(ROUGE.replace("rayon=1", "rayon=0.91").replace("Kd=0.9 0.15 0.1", "Kd=0 0 1"), fichier());
        banc.attendreCodes("l'image est celle du fichier", attendue(L, H));
    }

    private void taper(JTextField champ, String texte) throws Exception {
        faire(() -> {
            champ.requestFocusInWindow();
            champ.setText(texte);
        });
        attendre("le clavier y est", champ::isFocusOwner);
        banc.frapper(KeyEvent.VK_ENTER);
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
        tirer(surFilEvenements(() -> place(banc.etat().demande.lue.lampes.get(0).getPosition())), -30, 10);
        attendre("elle est plus à gauche", () -> banc.etat().demande.lue.lampes.get(0).getPosition().x < -0.2);
    }

    @Test
    void chaqueVueEstCelleDeLaLigneDeCommandeEtDitSaValeurSousLaSouris() throws Exception {
        ouvrir();
        String[] dits = {"N = .*", "d = \\d+\\.\\d+", "lampes : \\d", "rayons : \\d+", "marge : \\d+ décimales .*"};
        for (int k = 0; k < dits.length; k++) {
            String nom = Option.VUES.get(k);
            int rang = k;
            faire(article(1, "Vue : " + nom)::doClick);
            // à l'écran, les pixels à voir de la marge sont plus gros que dans son fichier
            banc.attendreCodes(nom, attendue("--vue=" + nom));
            attendre("elle se dit", () -> banc.resume().startsWith("vue " + nom + ", 320"));
            assertTrue(((Container) composant("legende", JPanel.class)).getComponentCount() > 2, "ses teintes aussi");
            banc.viser(banc.panneau, banc.panneau.getWidth() / 2 + k % 2, banc.panneau.getHeight() / 2);
            attendre("sa valeur sous la souris", () -> banc.pixel.getText().matches("pixel .* " + dits[rang]));
        }
        faire(article(1, "Vue : normales")::doClick);
        attendre("une autre vue", () -> banc.resume().startsWith("vue normales"));
        banc.viser(banc.panneau, (banc.panneau.getWidth() - L) / 2 + 5, (banc.panneau.getHeight() - H) / 2 + 5);
        attendre("le ciel se dit", () -> banc.pixel.getText().endsWith(" ciel"));
        faire(article(1, "Vue : image")::doClick);
        banc.attendreImage("et l'on revient à l'image", attendue(L, H));
    }
}
