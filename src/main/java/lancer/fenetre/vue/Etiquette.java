package lancer.fenetre.vue;

import java.awt.Cursor;
import java.awt.Insets;
import javax.swing.BorderFactory;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;

/** Un texte de plusieurs lignes, qui se lit sans se changer. Aucune ne commence par un signe de ponctuation. */
@SuppressWarnings("serial")
class Etiquette extends JTextArea {

    private static final int COLONNES = 40;

    Etiquette(String nom) {
        setName(nom);
        getAccessibleContext().setAccessibleName(nom);
        setEditable(false);
        setFocusable(false);
        setOpaque(false);
        // aligné sur les autres textes
        setMargin(new Insets(0, 0, 0, 0));
        setLineWrap(true);
        setWrapStyleWord(true);
        setCursor(Cursor.getDefaultCursor());
    }

    /** Celle-ci, de ce texte, pour un dialogue. */
    Etiquette dire(String texte) {
        setColumns(COLONNES);
        setText(texte);
        setSize(getPreferredSize().width, Short.MAX_VALUE);
        return this;
    }

    /** Sa place, de tant de lignes quel que soit son texte, qui défile s'il est plus long. */
    JScrollPane enPlace(int lignes) {
        setRows(lignes);
        setColumns(1);
        JScrollPane place = new JScrollPane(this);
        place.setBorder(BorderFactory.createEmptyBorder());
        return place;
    }

    @Override
    public void setText(String texte) {
        String lie = lier(texte);
        if (!lie.equals(getText())) {
            super.setText(lie);
            // ce qui défile montre son début
            setCaretPosition(0);
        }
    }

    /** Le même texte, où une espace qui précède un signe, ou un guillemet, est insécable. */
    static String lier(String texte) {
        return texte.replaceAll(" (?=[:;%?!»])", "\u00A0").replace("« ", "«\u00A0");
    }
}
