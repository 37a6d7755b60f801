package lancer.fenetre;

import java.awt.Cursor;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;
import javax.swing.Timer;
import javax.swing.UIManager;
import lancer.texte.Texte;

/** Messages de la fenêtre, sur le bas de l'image : les fautes de son état, puis un avis. */
@SuppressWarnings("serial")
final class Bandeau extends JTextArea {

    private static final int DUREE_AVIS_MS = 8000;
    private static final int MARGE = 6;

    private final Timer oubli = new Timer(DUREE_AVIS_MS, e -> dire(""));
    private Etat etat = new Etat();
    /** L'état dont un clic a fermé les fautes, jusqu'à ce qu'elles changent ou que le fichier soit relu. */
    private Etat ferme = etat;
    private String avis = "";

    Bandeau() {
        donnerALire(this, "message");
        setVisible(false);
        oubli.setRepeats(false);
        setToolTipText("cliquer pour fermer");
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                ferme = etat;
                dire("");
            }
        });
    }

    static JTextArea etiquette(String nom) {
        JTextArea etiquette = new JTextArea(" ");
        etiquette.setOpaque(false);
        donnerALire(etiquette, nom);
        return etiquette;
    }

    /** Donne à ce texte ce nom, et l'aspect d'une étiquette de plusieurs lignes. */
    private static void donnerALire(JTextArea texte, String nom) {
        texte.setName(nom);
        texte.getAccessibleContext().setAccessibleName(nom);
        texte.setEditable(false);
        texte.setFocusable(false);
        texte.setLineWrap(true);
        texte.setWrapStyleWord(true);
        texte.setCursor(Cursor.getDefaultCursor());
    }

    /** Montre les fautes de cet état. */
    void montrer(Etat nouveau) {
        etat = nouveau;
        ecrire();
    }

    /** Remplace l'avis, d'une ou de plusieurs lignes, qui s'efface au bout de quelques secondes ; vide pour aucun. */
    void dire(String nouveau) {
        avis = nouveau;
        oubli.restart();
        ecrire();
    }

    /** Remplace l'avis par cet échec, qui reste jusqu'à un clic ou un autre avis. */
    void retenir(String echec) {
        avis = echec;
        oubli.stop();
        ecrire();
    }

    private void ecrire() {
        boolean lues = etat.source.faute == ferme.source.faute && etat.getFautes().equals(ferme.getFautes());
        String fautes = lues ? "" : String.join("\n", etat.getFautes());
        String texte = Stream.of(fautes, avis).filter(dit -> !dit.isEmpty())
                .flatMap(dit -> Stream.of(dit.split("\n"))).map(Texte::echappe).collect(Collectors.joining("\n"));
        boolean grave = !fautes.isEmpty() || !oubli.isRunning();
        setBackground(UIManager.getColor("ToolTip.background"));
        setForeground(UIManager.getColor("ToolTip.foreground"));
        setBorder(BorderFactory.createCompoundBorder(BorderFactory.createMatteBorder(0, MARGE, 0, 0,
                UIManager.getColor("Component." + (grave ? "error" : "warning") + ".focusedBorderColor")),
                BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE)));
        if (!texte.equals(getText())) {
            setText(texte);
            setVisible(!texte.isEmpty());
            revalidate();
            getParent().repaint();
        }
    }
}
