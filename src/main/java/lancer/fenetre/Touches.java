package lancer.fenetre;

import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.KeyStroke;

/**
 * Les touches d'une notation comme {@code menu shift Z} : celles d'un clavier anglais, d'un clavier français et du pavé
 * numérique. {@code menu} est Ctrl, ou Commande sur un Mac.
 */
final class Touches {

    /** Les touches de 0 à 9 d'un clavier français, sans Maj. */
    private static final String FRANCAIS = "à&é\"'(-è_ç";
    private static final List<String> FLECHES = Arrays.asList("UP", "DOWN", "LEFT", "RIGHT");

    /** Le nom de chaque touche, après sa notation : ceux de Java suivent la langue de la machine. */
    private static final List<String> NOMS = Arrays.asList("ESCAPE", "Échap", "ENTER", "Entrée", "SPACE", "Espace",
            "PAGE_UP", "Page précédente", "PAGE_DOWN", "Page suivante", "LEFT", "Gauche", "RIGHT", "Droite", "UP", "Haut",
            "DOWN", "Bas", "-", "−");

    private Touches() {
    }

    /** La première est celle qu'un menu affiche. */
    static List<KeyStroke> de(String notation) {
        String touche = touche(notation);
        int avec = modificateurs(notation);
        int maj = avec | InputEvent.SHIFT_DOWN_MASK;
        int[] codes;
        if (touche.matches("\\d")) {
            int n = Integer.parseInt(touche);
            int francaise = KeyEvent.getExtendedKeyCodeForChar(FRANCAIS.charAt(n));
            codes = new int[] {KeyEvent.VK_0 + n, avec, KeyEvent.VK_NUMPAD0 + n, avec, francaise, avec, francaise, maj,
                KeyEvent.VK_0 + n, maj};
        } else if (touche.equals("+")) {
            codes = new int[] {KeyEvent.VK_PLUS, avec, KeyEvent.VK_ADD, avec, KeyEvent.VK_EQUALS, maj};
        } else if (touche.equals("-")) {
            codes = new int[] {KeyEvent.VK_MINUS, avec, KeyEvent.VK_SUBTRACT, avec};
        } else {
            int code = KeyStroke.getKeyStroke(touche).getKeyCode();
            int fleche = FLECHES.indexOf(touche);
            codes = new int[] {code, avec, fleche < 0 ? code : KeyEvent.VK_KP_UP + fleche, avec};
        }
        return IntStream.range(0, codes.length / 2).mapToObj(k -> KeyStroke.getKeyStroke(codes[2 * k], codes[2 * k + 1],
                notation.startsWith("released "))).distinct().collect(Collectors.toList());
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
        List<String> noms = Arrays.stream(notations).map(Touches::touche).map(touche -> NOMS.contains(touche)
                ? NOMS.get(NOMS.indexOf(touche) + 1) : touche).collect(Collectors.toList());
        return notations[0].substring(0, notations[0].length() - touche(notations[0]).length())
                .replace("menu", "Ctrl").replace("ctrl", "Ctrl").replace("alt", "Alt").replace("shift", "Maj")
                .replace(' ', '+') + (noms.size() <= 4 ? String.join(", ", noms)
                : noms.get(0) + " à " + noms.get(noms.size() - 1));
    }
}
