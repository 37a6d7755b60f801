package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static lancer.fenetre.BancFenetre.texte;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import javax.swing.JComboBox;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JTextField;
import javax.swing.JPanel;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import lancer.commande.Etape;
import lancer.commande.Option;
import org.junit.jupiter.api.Test;

/** Les touches de la table, sur un clavier anglais et sur un français : ce que chacune fait, et à qui elle va. */
class FenetreTouchesTest extends EssaiInspecteur {

    /** Donne cette disposition au clavier de l'écran ; les tests qui suivent retrouvent l'anglaise. */
    private void disposer(String clavier) throws Exception {
        try {
            assertEquals(0, new ProcessBuilder("setxkbmap", clavier).inheritIO().start().waitFor());
        } catch (IOException e) {
            assumeTrue(false, "pas de setxkbmap : le paquet x11-xkb-utils");
        }
        banc.robot.waitForIdle();
    }

    private void attendreEtape(String quoi, Etape etape) throws Exception {
        attendre(quoi, () -> banc.etat().demande.reglages.get(Option.ETAPE) == etape && !banc.etat().enCours());
    }

    private void attendreReflets(String quoi, int reflets) throws Exception {
        attendre(quoi, () -> banc.etat().demande.reglages.get(Option.REFLETS) == reflets
                && !banc.etat().enCours());
    }

    @Test
    void lesTouchesServentSurUnClavierFrancaisAllemandOuSuisseEtAuPave() throws Exception {
        ouvrir();
        int police = banc.etat().ecran.police;
        try {
            for (String clavier : new String[] {"fr", "de", "ch"}) {
                disposer(clavier);
                for (String touche : new String[] {"ctrl+plus", "ctrl+minus", "ctrl+KP_Add", "ctrl+0"}) {
                    int voulue = police + (touche.matches(".*(plus|Add)") ? 1 : 0);
                    taper(touche);
                    attendre(clavier + ", " + touche, () -> banc.etat().ecran.police == voulue);
                }
                for (Etape etape : Etape.values()) {
                    banc.frapper(KeyEvent.VK_F6 + etape.ordinal());
                    attendreEtape(clavier + ", " + etape, etape);
                }
                taper("minus");
                attendreReflets(clavier + ", −", 2);
                taper("plus");
                attendreReflets(clavier + ", +", 5);
                taper("KP_Add");
                attendreReflets(clavier + ", + du pavé", 10);
                taper("KP_Subtract");
                attendreReflets(clavier + ", − du pavé", 5);
                banc.frapperCtrl('r');
                attendre(clavier + ", remplie", () -> article(1, "Remplir la fenêtre").isSelected());
                banc.frapperCtrl('r');
                attendre(clavier + ", taille demandée", () -> !article(1, "Remplir la fenêtre").isSelected());
                cliquer(150, 110);
                attendreVerdict("Au bit près");
                JTree recit = composant("recit", JTree.class);
                int replies = surFilEvenements(recit::getRowCount);
                taper("d");
                attendre(clavier + ", D déplie", () -> recit.getRowCount() > replies);
                taper("d");
                attendre(clavier + ", et replie", () -> recit.getRowCount() == replies);
                banc.frapper(KeyEvent.VK_ESCAPE);
                attendre("le panneau se ferme", () -> !recit.isShowing());
            }
        } finally {
            disposer("us");
        }
    }

    /** Frappe, comme une main, la touche qui porte ce signe sur ce clavier, avec Maj s'il la faut. */
    private void taper(String signe) throws Exception {
        BancFenetre.mettreDevant(banc.cadre);
        try {
            assertEquals(0, new ProcessBuilder("xdotool", "key", signe).inheritIO().start().waitFor());
        } catch (IOException e) {
            assumeTrue(false, "pas de xdotool");
        }
    }

    @Test
    void apresUnClicDansLesReglagesEspaceCompareEtUnReglageAtteintParTabLaGarde() throws Exception {
        ouvrir();
        banc.frapper(KeyEvent.VK_F2);
        JComboBox<?> etapes = composant("étape du cours", JComboBox.class);
        attendre("F2 mène au premier réglage", () -> SwingUtilities.isDescendingFrom(
                banc.cadre.getFocusOwner(), etapes.getParent()));
        banc.frapper(KeyEvent.VK_SPACE);
        attendre("Espace y ouvre la liste", etapes::isPopupVisible);
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("et Échap la ferme", () -> !etapes.isPopupVisible());
        faire(() -> etapes.requestFocusInWindow());
        banc.cliquer(etapes, 10, 10);
        attendre("un clic l'ouvre aussi", etapes::isPopupVisible);
        java.awt.Point ici = surFilEvenements(etapes::getLocationOnScreen);
        banc.robot.mouseMove(ici.x + 10, ici.y + surFilEvenements(etapes::getHeight) + 8);
        banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        attendreEtape("la première étape", Etape.LAMBERT);
        attendre("le clavier est à l'image", banc.panneau::isFocusOwner);
        banc.robot.keyPress(KeyEvent.VK_SPACE);
        attendre("l'image d'avant", () -> banc.etat().montre.tenue);
        banc.robot.keyRelease(KeyEvent.VK_SPACE);
        attendre("puis celle-ci", () -> !banc.etat().montre.tenue);
    }

    @Test
    void lesTouchesServentAussiSurLeCadreEtUnTexteQueLOnEcritGardeLesSiennes() throws Exception {
        ouvrir();
        faire(banc.cadre::requestFocus);
        attendre("le clavier est au cadre", banc.cadre::isFocusOwner);
        banc.frapper(KeyEvent.VK_F2);
        JTextField seuil = composant("seuil des reflets", JTextField.class);
        faire(() -> {
            seuil.requestFocusInWindow();
            seuil.selectAll();
        });
        attendre("le clavier est au seuil", seuil::isFocusOwner);
        for (int touche : new int[] {KeyEvent.VK_1, KeyEvent.VK_E, KeyEvent.VK_MINUS, KeyEvent.VK_3, KeyEvent.VK_ENTER}) {
            banc.frapper(touche);
        }
        attendre("le seuil est celui de l'image", () -> banc.etat().demande.reglages.get(Option.SEUIL) == 0.001);
        assertEquals(5, banc.etat().demande.reglages.get(Option.REFLETS));
        assertFalse(surFilEvenements(BancFenetre.chercher("pixel", JPanel.class)::isShowing), "Entrée n'a pas ouvert l'onglet Pixel");
    }

    @Test
    void sansSceneRienNEstARelireNiADefaireEtLesTouchesNeFontRien() throws Exception {
        banc = new BancFenetre(TAILLE);
        JFileChooser choix = composant(null, JFileChooser.class);
        attendre("le clavier est au dialogue", () -> SwingUtilities.getWindowAncestor(choix).isFocused());
        faire(choix::cancelSelection);
        attendre("le dialogue est fermé", () -> !choix.isShowing());
        for (int menu = 0; menu < 3; menu++) {
            for (Component article : banc.cadre.getJMenuBar().getMenu(menu).getMenuComponents()) {
                String nom = article instanceof JMenuItem ? ((JMenuItem) article).getText() : "";
                assertTrue(!(article instanceof JMenuItem) || article.isEnabled()
                        == nom.matches("Ouvrir une scène…|Quitter|Remplir la fenêtre|Textes .*"), nom);
            }
        }
        for (int touche : new int[] {KeyEvent.VK_ESCAPE, KeyEvent.VK_F5, KeyEvent.VK_F2, KeyEvent.VK_F6, KeyEvent.VK_ADD,
            KeyEvent.VK_SPACE, KeyEvent.VK_ENTER, KeyEvent.VK_D}) {
            banc.frapper(touche);
        }
        banc.frapperCtrl('z');
        banc.robot.waitForIdle();
        assertEquals("", texte(banc.erreur));
        banc.frapperCtrl('o');
        choisir(scene);
        banc.attendreCodes("puis une scène s'ouvre", attendue(L, H));
    }

    @Test
    void f1DitLesTouchesQueDitLaPageDansUnPetitDialogue() throws Exception {
        ouvrir();
        banc.frapper(KeyEvent.VK_F1);
        JLabel table = composant("table", JLabel.class);
        Dimension place = surFilEvenements(() -> SwingUtilities.getWindowAncestor(table).getSize());
        assertTrue(place.width * place.height < 1280 * 800 * 2 / 5, place.toString());
        String page = new String(Files.readAllBytes(Paths.get("docs/fenetre.md")), StandardCharsets.UTF_8);
        for (String ligne : table.getText().replaceFirst(".*?<tr>", "").split("<tr>")) {
            String[] dit = ligne.substring("<td>".length()).split("<td>");
            // le nom d'une touche suit la langue de la machine des tests
            assertTrue(page.contains(" | " + dit[1] + " |"), dit[1]);
        }
        banc.frapper(SwingUtilities.getWindowAncestor(table), KeyEvent.VK_ESCAPE);
        attendre("Échap le ferme", () -> !table.isShowing());
    }
}
