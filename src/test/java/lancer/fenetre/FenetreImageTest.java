package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static lancer.fenetre.BancFenetre.texte;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import javax.swing.JTree;
import lancer.fenetre.etat.Pixel;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** L'image à l'écran, quelle que soit la taille de la fenêtre, et ce qui s'en lit : son coût, et la couleur d'un pixel. */
class FenetreImageTest extends EssaiFenetre {

    @Test
    void changerDeTailleGardeLImageDemandeeEtSesProportions() throws Exception {
        ImageMemoire image = ouvrir();
        retailler(banc.panneau.getWidth() + 151, banc.panneau.getHeight() + 83);
        attendre("elle est à sa taille, au milieu", () -> Ecran.trouver(image.codes, L) != null);
        BufferedImage vue = peinte();
        assertEquals(banc.panneau.getBackground().getRGB(), vue.getRGB(60, 20));
        retailler(L / 2, H);
        // une colonne de gris, puis la moitié des pixels : une boule rouge au milieu, comme avant
        vue = peinte();
        assertEquals(L / 2, vue.getWidth());
        assertEquals(banc.panneau.getBackground().getRGB(), vue.getRGB(L / 4, H / 8));
        Color milieu = new Color(image.codes[H / 2 * L + L / 2]);
        assertEquals(milieu.getRed(), new Color(vue.getRGB(L / 4, vue.getHeight() / 2)).getRed(), 25);
        attendre("la réduction se dit", () -> banc.resume().startsWith("320 × 240 pixels montrés à 50 %, "));
        assertSame(image, banc.etat().getImageEntiere(), "rien n'est redessiné");
    }

    @Test
    void uneTaillePlusGrandeQueLEcranEstDessineeEnEntierEtMontreeReduite() throws Exception {
        banc = new BancFenetre(new MainLent("--taille=2000x1500", scene.toString()));
        ImageMemoire image = banc.imageAchevee();
        assertEquals("2000 x 1500", image.largeur + " x " + image.hauteur);
        double reduction = Math.min(banc.panneau.getWidth() / 2000.0, banc.panneau.getHeight() / 1500.0);
        assertTrue(reduction < 1, "l'écran du test est trop grand");
        String debut = "2000 × 1500 pixels montrés à " + (int) (100 * reduction) + " %, ";
        attendre("la réduction se dit", () -> banc.resume().startsWith(debut));
        Point coin = surFilEvenements(banc.panneau::getLocationOnScreen);
        attendre("le pixel dit est celui de l'image dessinée", () -> {
            banc.robot.mouseMove(coin.x + banc.panneau.getWidth() / 2 + 1, coin.y + banc.panneau.getHeight() / 2);
            banc.robot.mouseMove(coin.x + banc.panneau.getWidth() / 2, coin.y + banc.panneau.getHeight() / 2);
            return banc.pixel.getText().matches("pixel (99\\d|100\\d), (74\\d|75\\d) : .*");
        });
    }

    @Test
    void laLoupeMontreUneTresGrandeImageAuPlusPresEtDAbordUnPixelPourUn() throws Exception {
        ecrire("[Lampe 1]\nposition=0 5 0\ncouleur=1 1 1\n");
        banc = new BancFenetre("--taille=1500x1125", scene.toString());
        ImageMemoire image = banc.imageAchevee();
        banc.robot.mouseMove(0, 0);
        for (int grossi = 1; grossi <= 16; grossi *= 2) {
            int voulu = grossi;
            banc.frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_UP);
            attendre("× " + voulu, () -> banc.reduction() == voulu);
            BufferedImage vue = peinte();
            Pixel milieu = banc.pixelVise();
            assertEquals(image.codes[milieu.y * image.largeur + milieu.x],
                    vue.getRGB(vue.getWidth() / 2, vue.getHeight() / 2), "× " + grossi);
            int gris = banc.panneau.getBackground().getRGB();
            assertTrue(Arrays.stream(BancFenetre.codes(vue)).noneMatch(c -> c == gris), "× " + grossi + " couvre le panneau");
        }
        for (int cran = 5; cran > 0; cran--) {
            banc.frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_DOWN);
        }
        attendre("de nouveau réduite", () -> banc.reduction() < 1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1x1", "16384x1", "1x16384"})
    void surUneImageSansLargeurOuSansHauteurEntreeMontreLesRayonsDUnPixel(String taille) throws Exception {
        banc = new BancFenetre("--taille=" + taille, scene.toString());
        ImageMemoire image = banc.imageAchevee();
        banc.robot.mouseMove(0, 0);
        Rectangle cadre = surFilEvenements(banc.cadre::getBounds);
        assertTrue(GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds().contains(cadre),
                cadre + " tient dans l'écran");
        banc.frapper(KeyEvent.VK_ENTER);
        JTree recit = BancFenetre.composant("recit", JTree.class);
        attendre("le récit dit le pixel", () -> EssaiInspecteur.lu(recit).startsWith("pixel "));
        boolean reduite = image.codes.length > 1;
        attendre("et le résumé si elle est réduite", () -> banc.resume().contains("montrés à ") == reduite);
    }

    @Test
    void lesReglagesSeLisentEtLaSectionLaisseeDeCoteFaitUnAvis() throws Exception {
        ecrire(ROUGE + "[Brume dense]\n");
        banc = new BancFenetre(lente("--reflets=1"));
        attendre("le résumé les dit", () -> banc.resume().matches("320 × 240 pixels, .* s, 1 réflexion"));
        assertTrue(texte(banc.erreur).startsWith("lancer : " + scene + ", ligne 16, [Brume dense] : "), texte(banc.erreur));
    }

    @Test
    void laBarreDitLePixelSousLaSourisEtLeCoutDeLImage() throws Exception {
        banc = new BancFenetre(lente("--statistiques"));
        ImageMemoire image = banc.imageAchevee();
        banc.attendreImage("l'image est à l'écran", image.codes);
        Point coin = Ecran.trouver(image.codes, L);
        int k = 100 * L + 160;
        String debut = String.format("pixel 160, 100 : #%06X = ", image.codes[k] & 0xFFFFFF);
        banc.robot.mouseMove(coin.x + 10, coin.y + 10);
        attendre("le pixel se dit", () -> {
            banc.robot.mouseMove(coin.x + 160, coin.y + 100);
            return banc.pixel.getText().startsWith(debut);
        });
        String cout = "320 × 240 pixels, \\d+(\u00A0\\d{3})* rayons en \\d+,\\d\\d s, 5 réflexions";
        attendre("le coût se dit", () -> banc.resume().matches(cout));
        banc.frapper(KeyEvent.VK_F5);
        attendre("la seconde image se compte aussi", () -> texte(banc.sortie).split("\n").length == 20);
        String dit = texte(banc.sortie);
        assertTrue(dit.matches("(?:(?:[a-z]+\\.)+[a-z]+: [0-9.]+\n){20}"), dit);
        assertTrue(dit.startsWith("rayons.primaires: 76800\n"), dit);
    }

    @Test
    void seuleLaCouleurDUnPixelDessineSeDitEtCelleDUnBrouillonEstDiteTelle() throws Exception {
        // un fil par pavé : aucun n'attend qu'un autre ne soit plus retenu
        banc = new BancFenetre(new MainLent(args("--fils=80")) {
            @Override
            void peindre(int ye, Runnable peindre) {
                // le brouillon attend avant le bas de l'image
                if (ye >= H / 2 && !brouillonFait()) {
                    retenir();
                }
                super.peindre(ye, peindre);
            }
        }.lent());
        attendre("le haut du brouillon se dit", () -> {
            survoler(10, 10);
            return banc.pixel.getText().matches("pixel 10, 10 \\(brouillon\\) : #.*");
        });
        attendre("le bas n'a pas encore de couleur", () -> {
            survoler(10, H - 10);
            return banc.pixel.getText().trim().isEmpty();
        });
        suite.countDown();
        attendre("le bas du brouillon se dit", () -> banc.pixel.getText().matches("pixel 10, " + (H - 10) + " \\(brouillon\\) : #.*"));
        banc.main.lent = false;
        attendre("puis sa dernière couleur", () -> banc.pixel.getText().startsWith("pixel 10, " + (H - 10) + " : #"));
    }

    /** La souris est sur ce pixel de l'image, sans que l'écran ait à le dire. */
    private void survoler(int x, int y) {
        banc.panneau.dispatchEvent(new MouseEvent(banc.panneau, MouseEvent.MOUSE_MOVED, 0, 0, (banc.panneau.getWidth() - L) / 2 + x,
                (banc.panneau.getHeight() - H) / 2 + y, 0, false));
    }
}
