package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;

import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextPane;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

/** L'inspecteur, avec l'anticrénelage : les échantillons du pixel se voient, et chacun peut être choisi. */
class FenetreEchantillonsTest extends EssaiFenetre {

    private static void presser(JComponent composant, int x, int y, int evenement) throws Exception {
        faire(() -> composant.dispatchEvent(new MouseEvent(composant, evenement, 0, InputEvent.BUTTON1_DOWN_MASK, x, y, 1, false,
                MouseEvent.BUTTON1)));
    }

    @Test
    void chaqueEchantillonSeChoisitDUnClicOuDUneToucheEtLePixelResteLeMeme() throws Exception {
        ecrire(ROUGE + "[Antialias]\nn=3\nseuil=0\n");
        ouvrir();
        presser(banc.panneau, (banc.panneau.getWidth() - L) / 2 + 150, (banc.panneau.getHeight() - H) / 2 + 100,
                MouseEvent.MOUSE_CLICKED);
        JTextPane recit = composant("recit", JTextPane.class);
        attendre("l'échantillon du centre", () -> recit.getText().contains("\nchaîne de l'échantillon 150.50, 100.50\n"));
        String somme = surFilEvenements(() -> recit.getText().replaceAll("(?s).*\n", ""));
        JComponent grille = composant("echantillons", JComponent.class);
        presser(grille, 5, 5, MouseEvent.MOUSE_PRESSED);
        attendre("le premier", () -> recit.getText().contains("\nchaîne de l'échantillon 150.17, 100.17\n"));
        KeyStroke suivante = KeyStroke.getKeyStroke(KeyEvent.VK_PAGE_DOWN, InputEvent.CTRL_DOWN_MASK);
        faire(() -> recit.getActionForKeyStroke(suivante).actionPerformed(new ActionEvent(recit, 0, "")));
        attendre("le deuxième", () -> recit.getText().contains("\nchaîne de l'échantillon 150.50, 100.17\n"));
        attendre("la même somme", () -> recit.getText().endsWith(somme));
        JLabel verdict = composant("verdict", JLabel.class);
        attendre("la comparaison", () -> verdict.getText().startsWith("Au bit près"));
    }

    @Test
    void laMethodeSeChoisitParSonMotDansUneListe() throws Exception {
        ecrire(ROUGE + "[Antialias]\nn=3\n");
        ouvrir();
        banc.frapper(KeyEvent.VK_F2);
        JComboBox<?> methode = composant("Antialias.methode", JComboBox.class);
        faire(methode::requestFocusInWindow);
        attendre("le clavier est à la liste", methode::hasFocus);
        banc.frapper(SwingUtilities.getWindowAncestor(methode), KeyEvent.VK_P);
        attendre("le mot", () -> "partage".equals(methode.getSelectedItem()));
        ecrire(ROUGE + "[Antialias]\nn=3\nmethode=partage\n");
        int[] attendue = attendue(L, H);
        banc.attendreImage("l'image suit", attendue);
    }
}
