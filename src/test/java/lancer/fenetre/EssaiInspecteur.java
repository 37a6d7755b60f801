package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.surFilEvenements;

import java.awt.event.KeyEvent;
import javax.swing.JTextArea;
import javax.swing.JTextPane;

/** De quoi attendre, dans l'inspecteur ouvert, son titre, son récit et son verdict. */
abstract class EssaiInspecteur extends EssaiFenetre {

    static Inspecteur inspecteur() throws Exception {
        return BancFenetre.chercher(null, Inspecteur.class);
    }

    static void attendreTitre(int x, int y) throws Exception {
        JTextPane recit = composant("recit", JTextPane.class);
        attendre("le pixel " + x + ", " + y, () -> recit.getText().startsWith("pixel " + x + ", " + y));
    }

    static String attendreRecit(String fin) throws Exception {
        JTextPane recit = composant("recit", JTextPane.class);
        attendre("le récit finit par " + fin, () -> recit.getText().replaceFirst("   ←[^\n]*$", "").endsWith(fin));
        return surFilEvenements(recit::getText);
    }

    static void attendreVerdict(String debut) throws Exception {
        JTextArea verdict = composant("verdict", JTextArea.class);
        attendre("le verdict « " + debut + " »", () -> verdict.getText().startsWith(debut));
    }

    void presser(int... touches) throws Exception {
        banc.frapper(touches);
    }

    static String couleur(int code) {
        return String.format(" = #%06X", code & 0xFFFFFF);
    }

    void ouvrirAuMilieu() throws Exception {
        banc.robot.mouseMove(0, 0);
        banc.frapper(KeyEvent.VK_ENTER);
        attendreTitre(L / 2, H / 2);
    }
}
