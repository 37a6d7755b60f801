package lancer.fenetre;

import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.KeyStroke;

/**
 * Les touches d'une notation comme {@code menu shift Z} : celles d'un clavier anglais, d'un clavier français et du pavé
 * numérique. {@code menu} est Ctrl, ou Commande sur un Mac.
 */
final class Touches {

    /** Les touches de 0 à 9 d'un clavier français, sans Maj. */
    private static final String FRANCAIS = "à&é\"'(-è_ç";

    /** Notation, nom et code d'une touche : les noms de Java suivent la langue de la machine. */
    private static final Object[][] NOMMEES = {{"ESCAPE", "Échap", KeyEvent.VK_ESCAPE},
        {"ENTER", "Entrée", KeyEvent.VK_ENTER}, {"SPACE", "Espace", KeyEvent.VK_SPACE},
        {"PAGE_UP", "Page précédente", KeyEvent.VK_PAGE_UP}, {"PAGE_DOWN", "Page suivante", KeyEvent.VK_PAGE_DOWN},
        {"-", "−", KeyEvent.VK_MINUS, KeyEvent.VK_SUBTRACT}, {"UP", "Haut", KeyEvent.VK_UP, KeyEvent.VK_KP_UP},
        {"DOWN", "Bas", KeyEvent.VK_DOWN, KeyEvent.VK_KP_DOWN},
        {"LEFT", "Gauche", KeyEvent.VK_LEFT, KeyEvent.VK_KP_LEFT},
        {"RIGHT", "Droite", KeyEvent.VK_RIGHT, KeyEvent.VK_KP_RIGHT}};

    private Touches() {
    }

    /** La première est celle qu'un menu affiche. */
    static List<KeyStroke> de(String notation) {
        String touche = touche(notation);
        int avec = modificateurs(notation);
        int maj = avec | InputEvent.SHIFT_DOWN_MASK;
        List<KeyStroke> touches = new ArrayList<>();
        char c = touche.charAt(0);
        Object[] nommee = nommee(touche);
        if (nommee != null) {
            for (int k = 2; k < nommee.length; k++) {
                touches.add(KeyStroke.getKeyStroke((Integer) nommee[k], avec, notation.startsWith("released ")));
            }
        } else if (Character.isDigit(c)) {
            int francaise = KeyEvent.getExtendedKeyCodeForChar(FRANCAIS.charAt(c - '0'));
            for (int code : new int[] {c, KeyEvent.VK_NUMPAD0 + c - '0', francaise}) {
                touches.add(KeyStroke.getKeyStroke(code, avec));
            }
            touches.add(KeyStroke.getKeyStroke(francaise, maj));
            touches.add(KeyStroke.getKeyStroke(c, maj));
        } else if (c == '+') {
            touches.add(KeyStroke.getKeyStroke(KeyEvent.VK_PLUS, avec));
            touches.add(KeyStroke.getKeyStroke(KeyEvent.VK_ADD, avec));
            touches.add(KeyStroke.getKeyStroke(KeyEvent.VK_EQUALS, maj));
        } else {
            // une lettre, ou F et un nombre
            touches.add(KeyStroke.getKeyStroke(touche.length() == 1 ? c
                    : KeyEvent.VK_F1 - 1 + Integer.parseInt(touche.substring(1)), avec));
        }
        return touches;
    }

    private static Object[] nommee(String touche) {
        for (Object[] nommee : NOMMEES) {
            if (nommee[0].equals(touche)) {
                return nommee;
            }
        }
        return null;
    }

    private static String touche(String notation) {
        return notation.substring(notation.lastIndexOf(' ') + 1);
    }

    private static int modificateurs(String notation) {
        // getMenuShortcutKeyMaskEx n'existe que depuis Java 10 : il rend ce masque six bits plus haut
        int menu = Toolkit.getDefaultToolkit().getMenuShortcutKeyMask() << 6;
        return (notation.contains("menu ") ? menu : 0) | (notation.contains("ctrl ") ? InputEvent.CTRL_DOWN_MASK : 0)
                | (notation.contains("alt ") ? InputEvent.ALT_DOWN_MASK : 0)
                | (notation.contains("shift ") ? InputEvent.SHIFT_DOWN_MASK : 0);
    }

    /** Texte de ces touches, par exemple « Ctrl+Alt+1, 2, 3, 4 » : ce qui se répète n'est dit qu'une fois. */
    static String dire(String... notations) {
        List<String> noms = Arrays.stream(notations).map(Touches::touche).map(touche -> nommee(touche) == null
                ? touche : (String) nommee(touche)[1]).collect(Collectors.toList());
        return notations[0].substring(0, notations[0].length() - touche(notations[0]).length())
                .replace("menu", "Ctrl").replace("ctrl", "Ctrl").replace("alt", "Alt").replace("shift", "Maj")
                .replace(' ', '+') + (noms.size() <= 4 ? String.join(", ", noms)
                : noms.get(0) + " à " + noms.get(noms.size() - 1));
    }
}
