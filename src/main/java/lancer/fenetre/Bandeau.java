package lancer.fenetre;

import java.awt.Cursor;
import java.awt.datatransfer.StringSelection;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.EnumMap;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;
import javax.swing.Timer;
import javax.swing.UIManager;
import javax.swing.border.Border;
import lancer.texte.Texte;

/** Messages de la fenêtre, sur le bas de l'image : d'abord la faute de la scène, puis les autres. */
@SuppressWarnings("serial")
final class Bandeau extends JTextArea {

    /** Sujets des messages, dans leur ordre d'affichage ; un avis s'efface au bout de quelques secondes. */
    enum Sujet { SCENE, DESSIN, DISQUE, AVIS }

    private static final int DUREE_AVIS_MS = 8000;
    private static final int MARGE_V = 6;
    private static final Border MARGES = BorderFactory.createEmptyBorder(MARGE_V, MARGE_V, MARGE_V, MARGE_V);

    private final Timer oubli = new Timer(DUREE_AVIS_MS, e -> dire(Sujet.AVIS, ""));
    private final Map<Sujet, String> dits = new EnumMap<>(Sujet.class);

    Bandeau() {
        setName("message");
        donnerALire(this);
        setVisible(false);
        oubli.setRepeats(false);
        setToolTipText("cliquer pour fermer ; le menu Fichier le copie");
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                dits.clear();
                dire(Sujet.AVIS, "");
            }
        });
    }

    void copier() {
        getToolkit().getSystemClipboard().setContents(new StringSelection(getText()), null);
    }

    static JTextArea etiquette(String nom) {
        JTextArea etiquette = new JTextArea(" ");
        etiquette.setName(nom);
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

    /** Remplace le message de ce sujet, d'une ou de plusieurs lignes ; un message vide l'efface. */
    void dire(Sujet sujet, String message) {
        dits.put(sujet, message);
        dits.values().removeIf(String::isEmpty);
        if (sujet == Sujet.AVIS && !message.isEmpty()) {
            oubli.restart();
        }
        String texte = dits.values().stream().flatMap(dit -> Stream.of(dit.split("\n"))).map(Texte::echappe)
                .collect(Collectors.joining("\n"));
        boolean grave = dits.keySet().stream().anyMatch(dit -> dit != Sujet.AVIS);
        setBackground(UIManager.getColor("ToolTip.background"));
        setForeground(UIManager.getColor("ToolTip.foreground"));
        setBorder(BorderFactory.createCompoundBorder(BorderFactory.createMatteBorder(0, MARGE_V, 0, 0, grave
                ? UIManager.getColor("Component.error.focusedBorderColor")
                : UIManager.getColor("Component.warning.focusedBorderColor")), MARGES));
        if (!texte.equals(getText())) {
            setText(texte);
            setVisible(!texte.isEmpty());
            revalidate();
            getParent().repaint();
        }
    }
}
