package lancer.fenetre;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Color;
import java.awt.Component;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.util.Arrays;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.plaf.basic.BasicHTML;
import lancer.fenetre.etat.Prise;
import lancer.fenetre.vue.figures.Figure;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** L'image, ce que la souris y fait et en dit, les menus, la place des onglets. */
class VueImageTest extends EssaiVue {

    private static final int BOUTON = InputEvent.BUTTON1_DOWN_MASK;
    private static final int MAJ = InputEvent.SHIFT_DOWN_MASK;

    /** Chaque pixel de l'écran a la couleur du pixel de l'image qui est là, ou celle du fond. */
    @ParameterizedTest
    @CsvSource({"311, 203, 0", "311, 203, 2", "200, 90, 4", "160, 120, 4"})
    void lImageEstAuMilieuUnPixelPourUnOuPlusGrandeALaLoupe(int largeur, int hauteur, int crans) {
        ouvrir();
        placer(largeur, hauteur);
        for (int k = 0; k < crans; k++) {
            molette(-1, largeur / 2 - 7, hauteur / 2 + 3);
        }
        ImageMemoire image = etat.getImageEntiere();
        BufferedImage vue = peint(panneau);
        int gris = panneau.getBackground().getRGB();
        for (int k = 0; k < largeur * hauteur; k++) {
            double x = k % largeur + 0.5;
            double y = k / largeur + 0.5;
            boolean dedans = etat.ecran.loupe.contient(image, x, y);
            int rang = etat.ecran.loupe.pixelDe(image, x, y).y * L + etat.ecran.loupe.pixelDe(image, x, y).x;
            assertEquals(dedans ? image.codes[rang] : gris, vue.getRGB(k % largeur, k / largeur), x + ", " + y);
        }
    }

    @Test
    void dansUnePlacePlusPetiteElleEstReduiteEtEntiere() {
        ouvrir();
        placer(L / 2, H);
        BufferedImage vue = peint(panneau);
        int gris = panneau.getBackground().getRGB();
        assertEquals(gris, vue.getRGB(L / 4, H / 8));
        assertTrue(Arrays.stream(vue.getRGB(0, H / 2, L / 2, 1, null, 0, L)).noneMatch(code -> code == gris), "toute sa largeur se voit");
        assertEquals(new Color(etat.getImageEntiere().codes[(H / 2 - 5) * L + L / 2]).getRed(),
                new Color(vue.getRGB(L / 4, H / 2 - 3)).getRed(), 25);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1x1", "16384x1", "1x16384", "1400x1000"})
    void quelleQueSoitSaTailleLeCadreTientDansLEcranEtUnPixelSExplique(String taille) {
        ouvrir(ROUGE, "--taille=" + taille);
        cadre.ouvrir();
        assertTrue(GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds().contains(cadre.getBounds()), "il y tient");
        placer(panneau.getWidth(), panneau.getHeight());
        int gris = panneau.getBackground().getRGB();
        assertTrue(Arrays.stream(EssaiFenetre.codes(peint(panneau))).anyMatch(code -> code != gris), "elle se voit");
        frapper(panneau, "ENTER");
        executer();
        assertTrue(recit().startsWith("pixel "), recit());
        assertEquals(!taille.equals("1x1"), dit("resume").contains(" montrés à "));
    }

    @Test
    void laSourisDitLePixelEtSaCouleurDesQuIlEnAUne() {
        ouvrir();
        survoler(80, 55);
        int code = etat.getImageEntiere().codes[55 * L + 80];
        Color c = new Color(code);
        assertTrue(pixelDit().startsWith(String.format("pixel 80, 55 : #%06X = %d %d %d ← ", code & 0xFFFFFF, c.getRed(), c.getGreen(),
                c.getBlue())), pixelDit());
        faire("F5, suite, suite, suite");
        survoler(80, 55);
        assertTrue(pixelDit().startsWith("pixel 80, 55 (brouillon) : #"), pixelDit());
        etat.montre.dessin.image.codes[55 * L + 80] = 0;
        survoler(80, 55);
        assertEquals("", pixelDit().trim(), "pas encore dessiné");
        etat.montre.dessin.image.codes[55 * L + 80] = code;
        souris(panneau, MouseEvent.MOUSE_EXITED, 0, 0, 0);
        assertEquals("", pixelDit().trim());
    }

    private void survoler(int x, int y) {
        souris(panneau, MouseEvent.MOUSE_MOVED, 0, place(x, y).x, place(x, y).y);
    }

    @ParameterizedTest
    @CsvSource({"normales, N = .*", "distance, d = \\d+\\.\\d+", "lampes, lampes : \\d", "rayons, rayons : \\d+",
        "marge, marge : \\d+ décimales .*"})
    void uneVueDitSesTeintesEtSaValeurSousLaSouris(String vue, String valeur) {
        ouvrir();
        choisir("Vue : " + vue);
        executer();
        assertTrue(dit("resume").startsWith("vue " + vue + ", 160"), dit("resume"));
        assertTrue(composant("legende", JPanel.class).getComponentCount() > 2);
        survoler(80, 55);
        assertTrue(pixelDit().matches("pixel 80, 55 .* " + valeur), pixelDit());
        int[] ecran = etat.getImageEntiere().aLEcran;
        assertEquals(vue.equals("marge"), ecran != null, "à l'écran, les pixels à voir de la marge sont plus gros que dans son fichier");
        assertEquals((ecran == null ? etat.getImageEntiere().codes : ecran)[55 * L + 80], peint(panneau).getRGB(place(80, 55).x,
                place(80, 55).y));
        choisir("Vue : image");
        executer();
        assertEquals(0, composant("legende", JPanel.class).getComponentCount());
    }

    @Test
    void unClicExpliqueLePixelMemeLentEtTremble() {
        ouvrir();
        cliquer(80, 55);
        Point ou = place(90, 60);
        souris(panneau, MouseEvent.MOUSE_PRESSED, BOUTON, ou.x, ou.y);
        souris(panneau, MouseEvent.MOUSE_RELEASED, BOUTON, ou.x + 1, ou.y);
        for (int[] autre : new int[][] {{BOUTON, 5}, {InputEvent.BUTTON3_DOWN_MASK, 0}, {BOUTON | MAJ, 0}}) {
            souris(panneau, MouseEvent.MOUSE_PRESSED, autre[0], ou.x, ou.y);
            souris(panneau, MouseEvent.MOUSE_RELEASED, autre[0], ou.x + autre[1], ou.y);
            faire("Échap");
            faire("F2");
        }
        // le second clic d'un double clic
        panneau.dispatchEvent(new MouseEvent(panneau, MouseEvent.MOUSE_RELEASED, 0, BOUTON, ou.x, ou.y, 2, false, MouseEvent.BUTTON1));
        assertEquals("[expliquer 80 55, arreter, expliquer 91 60, arreter]", journal.toString());
        placer(L + 20, H);
        souris(panneau, MouseEvent.MOUSE_PRESSED, BOUTON, 2, 50);
        souris(panneau, MouseEvent.MOUSE_RELEASED, BOUTON, 2, 50);
        assertEquals(4, journal.size(), "hors de l'image, rien");
    }

    @Test
    void majEtLaSourisTirentUneBouleQuUnClicDroitNeLachePas() {
        ouvrir(ROUGE.replace("-4 6 -3", "0.6 0.8 5"), "--taille=" + L + "x" + H);
        Point ou = place(80, 55);
        for (int maj : new int[] {0, MAJ}) {
            souris(panneau, MouseEvent.MOUSE_MOVED, maj, ou.x, ou.y);
            assertEquals(maj == MAJ, Arrays.stream(EssaiFenetre.codes(peint(panneau))).anyMatch(code -> code == Figure.LAMPE.getRGB()),
                    "Maj montre l'étoile d'une lampe");
        }
        souris(panneau, MouseEvent.MOUSE_PRESSED, BOUTON | MAJ, ou.x, ou.y);
        souris(panneau, MouseEvent.MOUSE_DRAGGED, BOUTON | MAJ, ou.x + 10, ou.y);
        souris(panneau, MouseEvent.MOUSE_PRESSED, InputEvent.BUTTON3_DOWN_MASK, ou.x + 10, ou.y);
        souris(panneau, MouseEvent.MOUSE_RELEASED, InputEvent.BUTTON3_DOWN_MASK, ou.x + 10, ou.y);
        souris(panneau, MouseEvent.MOUSE_DRAGGED, BOUTON | MAJ, ou.x + 20, ou.y);
        assertEquals("", message(), "le bas de l'image se voit");
        assertTrue(dit("resume").startsWith("[Sphere 1] ligne 1 : centre="), dit("resume"));
        souris(panneau, MouseEvent.MOUSE_RELEASED, BOUTON | MAJ, ou.x + 20, ou.y);
        assertNull(etat.geste);
        assertEquals("lancer — boule.ini •", cadre.getTitle());
        executer();
        lancer.Point centre = Prise.projeter(etat.montre.dessin.lancer.getCamera(),
                ((lancer.Sphere) etat.demande.lue.objets.get(0)).getCentre());
        assertEquals(100, centre.x, 1);
        choisir("Défaire le changement");
        assertEquals("lancer — boule.ini", cadre.getTitle());
    }

    @Test
    void laMoletteGrossitAutourDeLaSourisQuiTireEnsuiteLImage() {
        ouvrir();
        Point ou = place(50, 60);
        souris(panneau, MouseEvent.MOUSE_MOVED, 0, ou.x, ou.y);
        molette(-1, ou.x, ou.y);
        molette(-1, ou.x, ou.y);
        assertTrue(pixelDit().startsWith("pixel 50, 60 : "), pixelDit());
        souris(panneau, MouseEvent.MOUSE_PRESSED, BOUTON, ou.x, ou.y);
        souris(panneau, MouseEvent.MOUSE_DRAGGED, BOUTON, ou.x + 31, ou.y + 17);
        souris(panneau, MouseEvent.MOUSE_RELEASED, BOUTON, ou.x + 31, ou.y + 17);
        assertTrue(pixelDit().startsWith("pixel 50, 60 : "), pixelDit());
        assertEquals("[]", journal.toString(), "ni dessin, ni clic");
        molette(1, ou.x, ou.y);
        molette(1, ou.x, ou.y);
        assertEquals(1, etat.ecran.loupe.getReduction(etat.getImageEntiere()));
    }

    @Test
    void laFigureDuPixelEstSurLImageEtNonDedansTantQueSonOngletSeVoit() {
        ouvrir();
        int[] codes = etat.getImageEntiere().codes.clone();
        for (String geste : new String[] {"+, achève, -", "F2", "clic 80 55", "-, achève, Espace"}) {
            faire(geste + ", achève");
            placer(L, H);
            boolean nue = Arrays.equals(etat.getVisible().image.codes, EssaiFenetre.codes(peint(panneau)));
            assertEquals(geste.startsWith("clic"), !nue, geste);
        }
        faire("lâche Espace, +, achève");
        assertArrayEquals(codes, etat.getImageEntiere().codes);
    }

    @Test
    void leMessageDitLesFautesPuisLAvisEtUnClicLeFerme() {
        ouvrir();
        fichier("faute.ini", ROUGE.replace("rayon=1", "rayon=-1"));
        faire("ouvre faute.ini, achève, Ctrl+C");
        assertTrue(message().matches("(?s).*rayon : .*\nl'image qui reste est celle de boule.ini\nimage copiée, .*"), message());
        assertEquals("lancer — faute.ini", cadre.getTitle());
        souris(composant("message", JComponent.class), MouseEvent.MOUSE_PRESSED, BOUTON, 5, 5);
        assertEquals("", message());
    }

    @Test
    void lesOngletsSOuvrentADroiteSansDeplacerLImageEtEchapRendSaTailleAuCadre() {
        ouvrir();
        java.awt.Dimension avant = cadre.getSize();
        java.awt.Rectangle image = panneau.getBounds();
        for (String geste : new String[] {"F2", "F3", "clic 80 55"}) {
            faire(geste);
            assertTrue(cadre.getWidth() > avant.width);
            assertEquals(image.width, panneau.getWidth(), geste);
            assertEquals(image.x, panneau.getX(), geste);
        }
        assertEquals("Pixel", composant("panneau", JTabbedPane.class).getTitleAt(0));
        faire("achève, Échap");
        assertEquals(avant, cadre.getSize());
        assertEquals(image, panneau.getBounds());
    }

    @Test
    void ceQuiSeMontreAUnNomPourUnLecteurDEcran() {
        ouvrir();
        faire("clic 80 55, F3");
        for (String nom : new String[] {"image", "avancement", "cote", "recit", "vitesse.graphique"}) {
            assertFalse(composant(nom, JComponent.class).getAccessibleContext().getAccessibleName().trim().isEmpty(), nom);
        }
        assertTrue(panneau.getAccessibleContext().getAccessibleDescription().startsWith("160 × 120 pixels"));
    }

    @Test
    void sansSceneRienNEstARelireNiADefaireEtLesTouchesNeFontRien() {
        faireLeCadre();
        for (int menu = 0; menu < 3; menu++) {
            for (Component article : cadre.getJMenuBar().getMenu(menu).getMenuComponents()) {
                String nom = article instanceof JMenuItem ? ((JMenuItem) article).getText() : "";
                assertTrue(!(article instanceof JMenuItem) || article.isEnabled()
                        == nom.matches("Ouvrir une scène…|Quitter|Remplir la fenêtre|Textes .*"), nom);
            }
        }
        faire("F5, F2, F3, +, Espace, Ctrl+Haut, Ctrl+R, Ctrl+Z, Ctrl+E, Échap, va 1 0");
        assertEquals("[]", journal.toString());
    }

    @Test
    void leMenuDesScenesListeSonDossierQuandIlSOuvre() {
        assumeTrue(File.separatorChar == '/', "Windows refuse un nom de fichier où il y a un chevron");
        fichier("chat.ini", ROUGE);
        fichier("<html>rien.INI", ROUGE);
        ouvrir();
        JMenu scenes = cadre.getJMenuBar().getMenu(3);
        scenes.setSelected(true);
        assertEquals(3, scenes.getItemCount());
        assertEquals("<html>rien.INI", scenes.getItem(0).getText());
        assertNull(scenes.getItem(0).getClientProperty(BasicHTML.propertyKey), "ce qui le dessinerait en HTML");
        assertTrue(scenes.getItem(1).isSelected(), "celle qui est ouverte");
        scenes.getItem(2).doClick();
        assertEquals("[surveiller chat.ini, lire chat.ini]", journal.toString());
    }
}
