package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.surFilEvenements;

import java.awt.event.KeyEvent;
import java.util.Arrays;
import javax.swing.JTextArea;
import javax.swing.JTextPane;

/** De quoi attendre, dans l'inspecteur ouvert, son titre, son récit et son verdict. */
abstract class EssaiInspecteur extends EssaiFenetre {

    static Inspecteur inspecteur() throws Exception {
        return (Inspecteur) surFilEvenements(() -> Arrays.stream(java.awt.Window.getWindows())
                .filter(w -> w instanceof Inspecteur && w.isShowing()).findFirst().orElse(null));
    }

    static void attendreTitre(int x, int y) throws Exception {
        attendre("le pixel " + x + ", " + y, () -> inspecteurSur("Rayons du pixel " + x + ", " + y));
    }

    static boolean inspecteurSur(String titre) {
        return Arrays.stream(java.awt.Window.getWindows()).anyMatch(w -> w instanceof Inspecteur && w.isShowing()
                && ((Inspecteur) w).getTitle().equals(titre));
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
        banc.frapper(inspecteur(), touches);
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
