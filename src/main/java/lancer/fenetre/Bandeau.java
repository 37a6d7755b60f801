package lancer.fenetre;

import java.awt.Color;
import java.awt.Cursor;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;
import javax.swing.Timer;

/** Un message par-dessus le bas de l'image, en entier quelle que soit sa longueur ; invisible s'il est vide. */
final class Bandeau extends JTextArea {

    private static final long serialVersionUID = 1;

    private static final Color FOND_ERREUR = new Color(0xA61B1B);
    private static final Color FOND_AVIS = new Color(0xFFE9A8);
    private static final int DUREE_AVIS_MS = 8000;
    private static final int MARGE_V = 6;
    private static final int MARGE_H = 10;

    private final Timer oubli = new Timer(DUREE_AVIS_MS, e -> avis(""));
    private boolean erreur;

    Bandeau() {
        setName("message");
        setEditable(false);
        setFocusable(false);
        setLineWrap(true);
        setWrapStyleWord(true);
        setBorder(BorderFactory.createEmptyBorder(MARGE_V, MARGE_H, MARGE_V, MARGE_H));
        setVisible(false);
        oubli.setRepeats(false);
        // un fichier déposé ici l'est sur la fenêtre
        setTransferHandler(null);
        setCursor(Cursor.getDefaultCursor());
        setToolTipText("cliquer pour fermer");
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                avis("");
            }
        });
    }

    /** Un message qui reste jusqu'à ce qu'il n'ait plus lieu d'être. */
    void erreur(String texte) {
        oubli.stop();
        erreur = true;
        montrer(texte, FOND_ERREUR, Color.WHITE);
    }

    /** Un message qui s'efface de lui-même ; vide, il efface le précédent. */
    void avis(String texte) {
        oubli.restart();
        erreur = false;
        montrer(texte, FOND_AVIS, Color.BLACK);
    }

    void effacerErreur() {
        if (erreur) {
            avis("");
        }
    }

    private void montrer(String texte, Color fond, Color encre) {
        setBackground(fond);
        setForeground(encre);
        if (!texte.equals(getText())) {
            setText(texte);
            setVisible(!texte.isEmpty());
            revalidate();
            getParent().repaint();
        }
    }
}
