package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.SwingUtilities;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lancer;
import lancer.Scene;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;

/** La fenêtre elle-même : ses menus, ses touches, son icône, et l'écran qui manque. */
class FenetreTest extends EssaiFenetre {

    @Test
    void unArticleDeMenuQuiNePeutRienEstGrise() throws Exception {
        banc = new BancFenetre(lente().lent());
        JMenu dessin = banc.cadre.getJMenuBar().getMenu(2);
        attendre("on peut arrêter", () -> dessin.getItem(1).isEnabled());
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("il n'y a plus rien à arrêter", () -> !dessin.getItem(1).isEnabled());
        assertTrue(dessin.getItem(0).isEnabled(), "on peut redessiner");
    }

    @Test
    void chaqueMenuEtChaqueArticleSeChoisitParUneLettreQueSesVoisinsNOntPas() throws Exception {
        ouvrir();
        JMenuBar menus = banc.cadre.getJMenuBar();
        verifierLesLettres(Arrays.stream(menus.getComponents()));
        for (int k = 0; k < menus.getMenuCount(); k++) {
            // ceux des scènes sont sans nombre
            if (!menus.getMenu(k).getText().equals("Scènes")) {
                verifierLesLettres(Arrays.stream(menus.getMenu(k).getMenuComponents()));
            }
        }
    }

    private static void verifierLesLettres(Stream<Component> articles) {
        List<Integer> lettres = articles.filter(article -> article instanceof JMenuItem)
                .map(article -> ((JMenuItem) article).getMnemonic()).collect(Collectors.toList());
        assertEquals(lettres.size(), new HashSet<>(lettres).size(), lettres.toString());
        assertFalse(lettres.contains(KeyEvent.VK_UNDEFINED), lettres.toString());
    }

    @Test
    void f1MontreLesTouchesDansUnTableauQuiResteOuvert() throws Exception {
        ouvrir();
        banc.frapper(KeyEvent.VK_F1);
        JLabel table = composant("table", JLabel.class);
        Window touches = SwingUtilities.getWindowAncestor(table);
        assertTrue(table.getText().contains("<tr><td>Échap<td>arrêter le dessin"), table.getText());
        banc.frapper(touches, KeyEvent.VK_SUBTRACT);
        attendre("une touche essayée d'ici va au cadre", () -> banc.atelier.reglages.getReflets() == 2);
        assertTrue(surFilEvenements(touches::isShowing));
        banc.imageAchevee();
        banc.frapper(touches, KeyEvent.VK_ESCAPE);
        attendre("Échap le ferme", () -> !touches.isShowing());
    }

    @Test
    void lesPanneauxSeRangentACoteDuCadreEtSansSeRecouvrir() throws Exception {
        ImageMemoire image = ouvrir();
        Rectangle ecran = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
        // sans gestionnaire de fenêtres, il arrive que Java se trompe sur l'endroit où il l'a ouvert
        faire(() -> banc.cadre.setLocationRelativeTo(null));
        attendre("Java sait où est le cadre : au milieu", () -> Math.abs(banc.cadre.getBounds().getCenterX()
                - ecran.getCenterX()) <= 1);
        // et le reste su quand une souris l'a visé
        banc.viser(banc.panneau, 5, 5);
        banc.frapper(KeyEvent.VK_F3);
        composant("vitesse", JDialog.class);
        // à l'écran, car Java se trompe aussi sur l'endroit du panneau
        attendre("il ne cache pas l'image", () -> BancFenetre.trouver(image.codes, L) != null);
        // du panneau même, où elle ne sert à rien tant qu'aucun point n'est choisi
        banc.frapper(composant("vitesse", JDialog.class), KeyEvent.VK_ENTER);
        composant("pixel", Inspecteur.class);
        attendre("l'un ne recouvre pas l'autre", () -> {
            List<Rectangle> places = Arrays.stream(banc.cadre.getOwnedWindows()).filter(Window::isVisible).map(Window::getBounds)
                    .collect(Collectors.toList());
            return places.size() == 2 && places.stream().allMatch(p -> ecran.contains(p)
                    && places.stream().filter(p::intersects).count() == 1);
        });
    }

    @Test
    void duCadreEchapFermeLUneApresLAutreLesFenetresDACote() throws Exception {
        ouvrir();
        banc.frapper(KeyEvent.VK_F3);
        composant("vitesse", JDialog.class);
        banc.frapper(KeyEvent.VK_F1);
        composant("table", JLabel.class);
        for (int reste = 1; reste >= 0; reste--) {
            int encore = reste;
            banc.frapper(KeyEvent.VK_ESCAPE);
            attendre("une de moins", () -> Arrays.stream(banc.cadre.getOwnedWindows()).filter(Window::isVisible).count() == encore);
        }
    }

    @Test
    void surUnPetitEcranUnPanneauCacheDAbordLeCadrePlutotQuUnAutrePanneau() {
        Rectangle ecran = new Rectangle(0, 0, 1024, 768);
        Rectangle cadre = new Rectangle(0, 0, 812, 720);
        List<Rectangle> prises = new ArrayList<>();
        for (Dimension taille : new Dimension[] {new Dimension(350, 720), new Dimension(400, 230), new Dimension(560, 480)}) {
            Rectangle place = new Rectangle(Dialogues.place(taille, ecran, cadre, prises), taille);
            assertTrue(ecran.contains(place) && prises.stream().noneMatch(place::intersects), place + " et " + prises);
            prises.add(place);
        }
    }

    @Test
    void ceQuiSeMontreAUnNomPourUnLecteurDEcran() throws Exception {
        ouvrir();
        banc.frapper(KeyEvent.VK_ENTER);
        composant("pixel", Inspecteur.class);
        banc.frapper(KeyEvent.VK_F3);
        for (String nom : new String[] {"image", "avancement", "cote", "vitesse.graphique", "recit"}) {
            String dit = composant(nom, JComponent.class).getAccessibleContext().getAccessibleName();
            assertTrue(dit != null && !dit.trim().isEmpty(), nom);
        }
        attendre("l'image dit ce qu'elle est", () -> ("" + banc.panneau.getAccessibleContext().getAccessibleDescription())
                .startsWith("320 × 240 pixels"));
    }

    @Test
    void lIconeEstLaSceneDuCoursAPlusieursTailles() throws Exception {
        banc = new BancFenetre(lente());
        attendre("elle est là", () -> banc.cadre.getIconImages().size() == 4);
        Lancer lancer = new Lancer(new Scene("scenes/scene1.ini"), new Camera(128, 128));
        ImageMemoire dessinee = new ImageMemoire(128, 128, false);
        lancer.TracerPixels(dessinee, Constantes.MAX_REFLETS, 1);
        BufferedImage icone = new BufferedImage(128, 128, BufferedImage.TYPE_INT_RGB);
        icone.createGraphics().drawImage(banc.cadre.getIconImages().get(3), 0, 0, null);
        int proches = 0;
        for (int k = 0; k < 128 * 128; k++) {
            Color a = new Color(icone.getRGB(k % 128, k / 128));
            Color b = new Color(dessinee.codes[k]);
            proches += Math.abs(a.getRed() - b.getRed()) + Math.abs(a.getBlue() - b.getBlue()) < 8 ? 1 : 0;
        }
        assertTrue(proches > 128 * 128 * 3 / 4, "aux bords près, qu'elle a plus doux : " + proches);
    }

    @Test
    void sansEcranUneLigneProposeDeSePasserDeFenetre() throws Exception {
        // ailleurs qu'avec X11, l'écran ne se cache pas par une variable, et une fenêtre s'ouvrirait
        assumeTrue(System.getProperty("os.name").equals("Linux"), "pas un Linux");
        for (String affichage : new String[] {null, ":98765"}) {
            Path dit = dossier.resolve("dit.txt");
            ProcessBuilder programme = BancFenetre.processus(dit, "lancer.Main", scene.toString());
            programme.environment().remove("DISPLAY");
            if (affichage != null) {
                programme.environment().put("DISPLAY", affichage);
            }
            assertEquals(1, programme.start().waitFor());
            String ligne = new String(Files.readAllBytes(dit), StandardCharsets.UTF_8);
            assertTrue(ligne.matches("lancer : .*--image.*\\R"), ligne);
        }
    }
}
