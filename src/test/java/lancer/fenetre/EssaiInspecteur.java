package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.chercher;
import static lancer.fenetre.BancFenetre.composant;
import static lancer.fenetre.BancFenetre.faire;
import static lancer.fenetre.BancFenetre.surFilEvenements;

import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.JTextArea;
import javax.swing.JPanel;
import javax.swing.JTree;
import javax.swing.tree.DefaultMutableTreeNode;
import lancer.inspection.Recit.Noeud;

/** De quoi attendre, dans l'inspecteur ouvert, son pixel, son récit et son verdict. */
abstract class EssaiInspecteur extends EssaiFenetre {

    static JPanel inspecteur() throws Exception {
        return chercher("pixel", JPanel.class);
    }

    static void attendreTitre(int x, int y) throws Exception {
        JTree recit = composant("recit", JTree.class);
        attendre("le pixel " + x + ", " + y, () -> lu(recit).startsWith("pixel " + x + ", " + y + "\n"));
    }

    /** Les lignes qui se voient de l'arbre, à demander sur le fil des événements. */
    static String lu(JTree arbre) {
        return IntStream.range(0, arbre.getRowCount()).mapToObj(r -> ((Noeud) ((DefaultMutableTreeNode) arbre.getPathForRow(r)
                .getLastPathComponent()).getUserObject()).texte).collect(Collectors.joining("\n"));
    }

    static String attendreRecit(String fin) throws Exception {
        JTree recit = composant("recit", JTree.class);
        attendre("le récit finit par " + fin, () -> lu(recit).endsWith(fin));
        return surFilEvenements(() -> lu(recit));
    }

    static void attendreVerdict(String debut) throws Exception {
        JTextArea verdict = composant("verdict", JTextArea.class);
        attendre("le verdict « " + debut + " »", () -> BancFenetre.delier(verdict.getText()).startsWith(debut));
    }

    /** Frappe ces touches quand l'image a le clavier. */
    void presser(int... touches) throws Exception {
        BancFenetre.mettreDevant(banc.cadre);
        faire(banc.panneau::requestFocusInWindow);
        attendre("le clavier est à l'image", banc.panneau::isFocusOwner);
        banc.frapper(touches);
    }

    /** Clique, de la vraie souris, sur la ligne du récit qui commence ainsi. */
    void cliquerSur(JTree recit, String debut) throws Exception {
        Rectangle place = surFilEvenements(() -> {
            String[] lignes = lu(recit).split("\n");
            int ligne = IntStream.range(0, lignes.length).filter(k -> lignes[k].startsWith(debut)).findFirst().getAsInt();
            recit.scrollRowToVisible(ligne);
            return recit.getRowBounds(ligne);
        });
        banc.cliquer(recit, place.x + 20, place.y + place.height / 2);
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
