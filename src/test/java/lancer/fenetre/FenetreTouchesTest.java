package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static lancer.fenetre.BancFenetre.texte;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import javax.swing.JComboBox;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import lancer.commande.Etape;
import org.junit.jupiter.api.Test;

/** Les touches de la table, sur un clavier anglais et sur un français : ce que chacune fait, et à qui elle va. */
class FenetreTouchesTest extends EssaiInspecteur {

    /** Donne cette disposition au clavier de l'écran ; les tests qui suivent retrouvent l'anglaise. */
    private static void disposer(String clavier) throws Exception {
        try {
            assertEquals(0, new ProcessBuilder("setxkbmap", clavier).inheritIO().start().waitFor());
        } catch (IOException e) {
            assumeTrue(false, "pas de setxkbmap : le paquet x11-xkb-utils");
        }
        Thread.sleep(200);
    }

    private void attendreEtape(String quoi, Etape etape) throws Exception {
        attendre(quoi, () -> banc.controleur.etat.getReglages().getEtape() == etape && !banc.controleur.etat.enCours);
    }

    private void attendreReflets(String quoi, int reflets) throws Exception {
        attendre(quoi, () -> banc.controleur.etat.getReglages().getReflets() == reflets && !banc.controleur.etat.enCours);
    }

    @Test
    void lesChiffresPlusEtMoinsServentSurUnClavierAnglaisEtFrancaisEtAuPave() throws Exception {
        ouvrir();
        banc.robot.keyPress(KeyEvent.VK_NUM_LOCK);
        banc.robot.keyRelease(KeyEvent.VK_NUM_LOCK);
        try {
            for (String clavier : new String[] {"us", "fr"}) {
                disposer(clavier);
                for (int pave : new int[] {KeyEvent.VK_0, KeyEvent.VK_NUMPAD0}) {
                    String ou = clavier + ", pavé " + (pave == KeyEvent.VK_NUMPAD0) + " : ";
                    for (Etape etape : Etape.values()) {
                        // le robot appuie sur la touche où ce chiffre est gravé, sans Maj
                        banc.frapper(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, pave + 1 + etape.ordinal());
                        attendreEtape(ou + etape, etape);
                    }
                    banc.frapper(KeyEvent.VK_CONTROL, pave);
                    attendre(ou + "remplie", () -> article(1, "Remplir la fenêtre").isSelected());
                    banc.frapper(KeyEvent.VK_CONTROL, pave + 1);
                    attendre(ou + "taille demandée", () -> !article(1, "Remplir la fenêtre").isSelected());
                }
                banc.frapper(KeyEvent.VK_MINUS);
                attendreReflets(clavier + ", −", 2);
                banc.frapper(KeyEvent.VK_SHIFT, KeyEvent.VK_EQUALS);
                attendreReflets(clavier + ", +", 5);
                banc.frapper(KeyEvent.VK_ADD);
                attendreReflets(clavier + ", + du pavé", 10);
                banc.frapperCtrl('z');
                attendreReflets(clavier + ", Ctrl+Z", 5);
                cliquer(150, 110);
                attendreVerdict("Au bit près");
                Inspecteur ouvert = inspecteur();
                banc.frapper(KeyEvent.VK_1);
                attendre(clavier + ", 1 isole un rebond", () -> ouvert.rebond == 1);
                banc.frapper(KeyEvent.VK_0);
                attendre(clavier + ", 0 les montre tous", () -> ouvert.rebond == 0);
                banc.frapper(KeyEvent.VK_NUMPAD1);
                attendre(clavier + ", 1 du pavé", () -> ouvert.rebond == 1);
                banc.frapper(KeyEvent.VK_NUMPAD0);
                attendre(clavier + ", 0 du pavé", () -> ouvert.rebond == 0);
                banc.frapper(KeyEvent.VK_ESCAPE);
                attendre("le panneau se ferme", () -> !ouvert.isShowing());
            }
        } finally {
            banc.robot.keyPress(KeyEvent.VK_NUM_LOCK);
            banc.robot.keyRelease(KeyEvent.VK_NUM_LOCK);
            disposer("us");
        }
    }

    @Test
    void pageSuivanteFaitDefilerLeRecitEtNeChangePasDeScene() throws Exception {
        Files.write(dossier.resolve("chat.ini"), BLEUE.getBytes(StandardCharsets.UTF_8));
        ouvrir();
        attendre("il y a une scène suivante", () -> article(3, "Scène suivante").isEnabled());
        cliquer(150, 100);
        attendreVerdict("Au bit près");
        JTree recit = composant("recit", JTree.class);
        JScrollBar barre = ((JScrollPane) recit.getParent().getParent()).getVerticalScrollBar();
        banc.frapper(KeyEvent.VK_D);
        attendre("déplié, il déborde", barre::isVisible);
        assertEquals(0, surFilEvenements(barre::getValue));
        banc.frapper(KeyEvent.VK_PAGE_DOWN);
        attendre("il défile", () -> barre.getValue() > 0);
        banc.frapper(KeyEvent.VK_PAGE_UP);
        attendre("et revient", () -> barre.getValue() == 0);
        assertEquals("lancer — boule.ini", banc.cadre.getTitle());
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
        attendre("l'image d'avant", () -> banc.panneau.tenue != null);
        banc.robot.keyRelease(KeyEvent.VK_SPACE);
        attendre("puis celle-ci", () -> banc.panneau.tenue == null);
    }

    @Test
    void lesTouchesServentAussiSurLeCadreEtUnTexteQueLOnEcritGardeLesSiennes() throws Exception {
        ouvrir();
        faire(banc.cadre::requestFocus);
        attendre("le clavier est au cadre", banc.cadre::isFocusOwner);
        banc.frapper(KeyEvent.VK_F2);
        JTextField seuil = composant("seuil", JTextField.class);
        faire(() -> {
            seuil.requestFocusInWindow();
            seuil.selectAll();
        });
        attendre("le clavier est au seuil", seuil::isFocusOwner);
        for (int touche : new int[] {KeyEvent.VK_1, KeyEvent.VK_E, KeyEvent.VK_MINUS, KeyEvent.VK_3, KeyEvent.VK_ENTER}) {
            banc.frapper(touche);
        }
        attendre("le seuil est celui de l'image", () -> banc.controleur.etat.getReglages().getSeuil() == 0.001);
        assertEquals(5, banc.controleur.etat.getReglages().getReflets());
        assertNull(BancFenetre.chercher(null, Inspecteur.class), "Entrée n'a pas ouvert l'onglet Pixel");
    }

    @Test
    void apresUnDialogueLeClavierRevientALImageEtMajEtUneFlechePoussentCeQuiEstPris() throws Exception {
        ouvrir();
        banc.viser(banc.panneau, banc.panneau.getWidth() / 2, banc.panneau.getHeight() / 2);
        banc.robot.keyPress(KeyEvent.VK_SHIFT);
        banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.keyRelease(KeyEvent.VK_SHIFT);
        banc.frapperCtrl('o');
        JFileChooser choix = composant(null, JFileChooser.class);
        attendre("le clavier est au dialogue", () -> SwingUtilities.getWindowAncestor(choix).isFocused());
        faire(choix::cancelSelection);
        attendre("le dialogue est fermé", () -> !choix.isShowing());
        banc.frapper(KeyEvent.VK_SHIFT, KeyEvent.VK_RIGHT);
        attendre("poussée", () -> banc.controleur.etat.estDeplace());
    }

    @Test
    void sansSceneRienNEstARelireNiADefaireEtLesTouchesNeFontRien() throws Exception {
        banc = new BancFenetre(TAILLE);
        JFileChooser choix = composant(null, JFileChooser.class);
        attendre("le clavier est au dialogue", () -> SwingUtilities.getWindowAncestor(choix).isFocused());
        faire(choix::cancelSelection);
        attendre("le dialogue est fermé", () -> !choix.isShowing());
        for (String nom : new String[] {"Relire la scène et redessiner", "Arrêter le dessin", "Défaire", "Refaire"}) {
            assertFalse(surFilEvenements(article(nom)::isEnabled), nom);
        }
        for (int touche : new int[] {KeyEvent.VK_ESCAPE, KeyEvent.VK_F5, KeyEvent.VK_F2, KeyEvent.VK_PAGE_DOWN, KeyEvent.VK_ADD,
            KeyEvent.VK_SPACE, KeyEvent.VK_ENTER, KeyEvent.VK_D}) {
            banc.frapper(touche);
        }
        banc.frapperCtrl('z');
        banc.robot.waitForIdle();
        assertEquals("", banc.message() + texte(banc.erreur));
        banc.frapperCtrl('o');
        choisir(scene);
        banc.attendreImage("puis une scène s'ouvre", attendue(L, H));
    }

    @Test
    void unDessinArreteEnPleinEcranSeDit() throws Exception {
        banc = new BancFenetre(lente().lent());
        attendre("le brouillon se voit", () -> banc.panneau.montree != null);
        banc.frapper(KeyEvent.VK_F11);
        attendre("plein écran", () -> banc.panneau.ligne.startsWith("lancer — boule.ini — dessin "));
        attendre("le temps qui reste se dit", () -> banc.panneau.ligne.matches(".* — \\d+,\\d\\d s, reste \\d+ (s|min)"));
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("il est arrêté", () -> banc.panneau.ligne.matches(
                "lancer — boule.ini — dessin arrêté à \\d+ % — .* ; F5 pour le reprendre"));
        banc.main.lent = false;
        banc.frapper(KeyEvent.VK_F5);
        attendre("puis repris", () -> !banc.controleur.etat.enCours && banc.panneau.ligne.isEmpty());
    }

    @Test
    void leTableauDesToucheSeParcourtAuClavierEtLaPageDitLesMemes() throws Exception {
        ouvrir();
        banc.frapper(KeyEvent.VK_F1);
        JLabel table = composant("table", JLabel.class);
        Window touches = SwingUtilities.getWindowAncestor(table);
        faire(() -> {
            touches.setSize(touches.getWidth(), 200);
            touches.validate();
        });
        JScrollBar barre = ((JScrollPane) table.getParent().getParent()).getVerticalScrollBar();
        banc.frapper(KeyEvent.VK_PAGE_DOWN);
        attendre("il défile", () -> barre.getValue() > 0);
        String page = new String(Files.readAllBytes(Paths.get("docs/fenetre.md")), StandardCharsets.UTF_8);
        for (String ligne : table.getText().replaceFirst(".*?<tr>", "").split("<tr>")) {
            String[] dit = ligne.substring("<td>".length()).split("<td>");
            assertTrue(page.contains("| " + dit[0] + " | " + dit[1] + " |"), "| " + dit[0] + " | " + dit[1] + " |");
        }
    }
}
