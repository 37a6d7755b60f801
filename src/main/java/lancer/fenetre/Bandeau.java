package lancer.fenetre;

import java.awt.Cursor;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;
import javax.swing.Timer;
import javax.swing.UIManager;
import javax.swing.border.Border;
import lancer.texte.Texte;

/** Messages de la fenêtre, sur le bas de l'image : les fautes de son état, puis un échec, puis un avis. */
@SuppressWarnings("serial")
final class Bandeau extends JTextArea {

    private static final int DUREE_AVIS_MS = 8000;
    private static final int MARGE_V = 6;
    private static final Border MARGES = BorderFactory.createEmptyBorder(MARGE_V, MARGE_V, MARGE_V, MARGE_V);

    private final Timer oubli = new Timer(DUREE_AVIS_MS, e -> dire(""));
    private Etat etat = new Etat();
    /**
     * Les fautes qu'un clic a fermées, jusqu'à ce qu'elles changent, et celle du fichier, jusqu'à une autre lecture.
     */
    private List<String> fermees = Collections.emptyList();
    private String fauteFermee;
    /** Le dernier échec d'un enregistrement, et un avis, qui s'efface au bout de quelques secondes ; vides sinon. */
    private String echec = "";
    private String avis = "";

    Bandeau() {
        setName("message");
        getAccessibleContext().setAccessibleName("message");
        donnerALire(this);
        setVisible(false);
        oubli.setRepeats(false);
        setToolTipText("cliquer pour fermer");
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                fermees = etat.getFautes();
                fauteFermee = etat.source.faute;
                echec = "";
                dire("");
            }
        });
    }

    static JTextArea etiquette(String nom) {
        JTextArea etiquette = new JTextArea(" ");
        etiquette.setName(nom);
        etiquette.getAccessibleContext().setAccessibleName(nom);
        etiquette.setOpaque(false);
        donnerALire(etiquette);
        return etiquette;
    }

    /** Donne à ce texte l'aspect d'une étiquette de plusieurs lignes. */
    private static void donnerALire(JTextArea texte) {
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

    /** Remplace l'échec du dernier enregistrement, qui reste jusqu'au suivant ; vide s'il a réussi. */
    void retenir(String nouveau) {
        echec = nouveau;
        ecrire();
    }

    /** Remplace l'avis, d'une ou de plusieurs lignes ; un avis vide l'efface. */
    void dire(String nouveau) {
        avis = nouveau;
        oubli.restart();
        ecrire();
    }

    private void ecrire() {
        List<String> toutes = etat.getFautes();
        boolean ferme = etat.source.faute == fauteFermee && toutes.equals(fermees);
        String fautes = ferme ? "" : String.join("\n", toutes);
        String texte = Stream.of(fautes, echec, avis).filter(dit -> !dit.isEmpty())
                .flatMap(dit -> Stream.of(dit.split("\n"))).map(Texte::echappe).collect(Collectors.joining("\n"));
        setBackground(UIManager.getColor("ToolTip.background"));
        setForeground(UIManager.getColor("ToolTip.foreground"));
        setBorder(BorderFactory.createCompoundBorder(BorderFactory.createMatteBorder(0, MARGE_V, 0, 0,
                UIManager.getColor(fautes.isEmpty() && echec.isEmpty() ? "Component.warning.focusedBorderColor"
                        : "Component.error.focusedBorderColor")), MARGES));
        if (!texte.equals(getText())) {
            setText(texte);
            setVisible(!texte.isEmpty());
            revalidate();
            getParent().repaint();
        }
    }
}
