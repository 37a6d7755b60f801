package lancer.fenetre;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import lancer.commande.Etape;
import lancer.commande.Option;
import org.junit.jupiter.api.Test;

/** Les touches, sur plusieurs claviers : ce que chacune fait, et à qui elle va. */
class FenetreTouchesTest extends EssaiFenetre {

    private <T> void attendreReglage(String quoi, Option<T> option, T voulu) throws Exception {
        attendre(quoi, () -> etat().demande.reglages.get(option).equals(voulu) && !etat().enCours());
    }

    private static void lancerProgramme(String... commande) throws Exception {
        try {
            assertEquals(0, new ProcessBuilder(commande).inheritIO().start().waitFor());
        } catch (IOException e) {
            assumeTrue(false, "pas de " + commande[0] + " : les paquets x11-xkb-utils et xdotool");
        }
    }

    /** Donne cette disposition au clavier de l'écran ; les tests qui suivent retrouvent l'anglaise. */
    private void disposer(String clavier) throws Exception {
        lancerProgramme("setxkbmap", clavier);
        robot.waitForIdle();
    }

    /** Frappe, comme une main, la touche qui porte ce signe sur ce clavier, avec Maj s'il la faut. */
    private void taper(String signe) throws Exception {
        mettreDevant(cadre);
        lancerProgramme("xdotool", "key", signe);
    }

    @Test
    void lesTouchesServentSurUnClavierFrancaisAllemandOuSuisseEtAuPave() throws Exception {
        ouvrir();
        int police = etat().ecran.police;
        try {
            for (String clavier : new String[] {"fr", "de", "ch"}) {
                disposer(clavier);
                for (Etape etape : Etape.values()) {
                    frapper(KeyEvent.VK_F6 + etape.ordinal());
                    attendreReglage(clavier + ", " + etape, Option.ETAPE, etape);
                }
                int[] reflets = {2, 5, 10, 5};
                String[] signes = {"minus", "plus", "KP_Add", "KP_Subtract"};
                for (int k = 0; k < signes.length; k++) {
                    taper(signes[k]);
                    attendreReglage(clavier + ", " + signes[k], Option.REFLETS, reflets[k]);
                }
                for (int k = 0; k < 2; k++) {
                    boolean remplie = k == 0;
                    frapperCtrl('r');
                    attendre(clavier + ", Ctrl+R", () -> etat().ecran.remplie == remplie);
                }
                String[] tailles = {"ctrl+plus", "ctrl+KP_Subtract", "ctrl+minus", "ctrl+KP_Add", "ctrl+KP_Add", "ctrl+0"};
                int[] points = {1, 0, -1, 0, 1, 0};
                for (int k = 0; k < tailles.length; k++) {
                    int voulue = police + points[k];
                    taper(tailles[k]);
                    attendre(clavier + ", " + tailles[k], () -> etat().ecran.police == voulue);
                }
                attendreReglage("et rien d'autre", Option.REFLETS, 5);
                cliquer(panneau, place(160, 110).x, place(160, 110).y);
                attendreTexte("verdict", "Au bit près");
                JTree recit = composant("recit", JTree.class);
                for (String d : new String[] {"d", "Caps_Lock", "d", "Caps_Lock"}) {
                    boolean avant = etat().ecran.tout;
                    taper(d);
                    attendre(clavier + ", " + d, () -> d.length() > 1 || etat().ecran.tout != avant);
                }
                frapper(KeyEvent.VK_SHIFT, KeyEvent.VK_RIGHT);
                attendre("une flèche mène plus loin", () -> lu(recit).startsWith("pixel 170, 110\n"));
                frapper(KeyEvent.VK_ESCAPE);
                attendre("le panneau se ferme", () -> !recit.isShowing());
            }
        } finally {
            disposer("us");
        }
    }

    @Test
    void apresUnClicDansLesReglagesEspaceCompareEtUnReglageAtteintParTabLaGarde() throws Exception {
        ouvrir();
        frapper(KeyEvent.VK_F2);
        JComboBox<?> etapes = composant("étape du cours", JComboBox.class);
        attendre("F2 mène au premier réglage", () -> SwingUtilities.isDescendingFrom(cadre.getFocusOwner(), etapes.getParent()));
        frapper(KeyEvent.VK_SPACE);
        attendre("Espace y ouvre la liste", etapes::isPopupVisible);
        frapper(KeyEvent.VK_ESCAPE);
        attendre("et Échap la ferme", () -> !etapes.isPopupVisible());
        faire(etapes::requestFocusInWindow);
        cliquer(etapes, 10, 10);
        attendre("un clic l'ouvre aussi", etapes::isPopupVisible);
        Point ici = surFilEvenements(etapes::getLocationOnScreen);
        robot.mouseMove(ici.x + 10, ici.y + surFilEvenements(etapes::getHeight) + 8);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        attendreReglage("la première étape", Option.ETAPE, Etape.LAMBERT);
        attendre("le clavier est à l'image", panneau::isFocusOwner);
        robot.keyPress(KeyEvent.VK_SPACE);
        attendre("l'image d'avant", () -> etat().montre.tenue);
        robot.keyRelease(KeyEvent.VK_SPACE);
        attendre("puis celle-ci", () -> !etat().montre.tenue);
        robot.keyPress(KeyEvent.VK_SPACE);
        attendre("de nouveau", () -> etat().montre.tenue);
        faire(etapes::requestFocusInWindow);
        attendre("celle-ci, même si son relâchement va ailleurs", () -> !etat().montre.tenue);
        robot.keyRelease(KeyEvent.VK_SPACE);
    }

    @Test
    void lesTouchesServentAussiSurLeCadreEtUnTexteQueLOnEcritGardeLesSiennes() throws Exception {
        ouvrir();
        faire(cadre::requestFocus);
        attendre("le clavier est au cadre", cadre::isFocusOwner);
        frapper(KeyEvent.VK_F2);
        JTextField seuil = composant("seuil des reflets", JTextField.class);
        faire(seuil::selectAll);
        for (int touche : new int[] {KeyEvent.VK_1, KeyEvent.VK_E, KeyEvent.VK_MINUS, KeyEvent.VK_3, KeyEvent.VK_ENTER}) {
            frapper(seuil, touche);
        }
        attendreReglage("le seuil est celui de l'image", Option.SEUIL, 0.001);
        assertEquals(5, etat().demande.reglages.get(Option.REFLETS));
        assertNull(chercher("recit", JTree.class), "Entrée n'a pas ouvert l'onglet Pixel");
        String present = surFilEvenements(seuil::getText);
        frapper(seuil, KeyEvent.VK_MINUS);
        frapper(seuil, KeyEvent.VK_ENTER);
        attendreMessage("seuil des reflets : valeur impossible, « ");
        frapper(seuil, KeyEvent.VK_ESCAPE);
        attendre("Échap rend celui de l'image", () -> seuil.getText().equals(present));
        assertNull(chercher("pixel", JPanel.class));
    }
}
