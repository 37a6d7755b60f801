package lancer.fenetre;

import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.KeyStroke;

/**
 * Les touches d'une notation comme {@code menu shift Z} : celles d'un clavier anglais, d'un clavier français et du pavé
 * numérique. {@code menu} est Ctrl, ou Commande sur un Mac.
 */
final class Touches {

    /** Les touches de 0 à 9 d'un clavier français, sans Maj. */
    private static final String FRANCAIS = "à&é\"'(-è_ç";

    private Touches() {
    }

    /** La première est celle qu'un menu affiche. */
    static List<KeyStroke> de(String notation) {
        String touche = touche(notation);
        int avec = modificateurs(notation);
        int maj = avec | InputEvent.SHIFT_DOWN_MASK;
        boolean relachee = notation.startsWith("released ");
        if (touche.matches("\\d")) {
            int n = Integer.parseInt(touche);
            int francaise = KeyEvent.getExtendedKeyCodeForChar(FRANCAIS.charAt(n));
            return touches(false, KeyEvent.VK_0 + n, avec, KeyEvent.VK_NUMPAD0 + n, avec, francaise, avec,
                    francaise, maj, KeyEvent.VK_0 + n, maj);
        }
        if (touche.equals("+")) {
            return touches(false, KeyEvent.VK_PLUS, avec, KeyEvent.VK_ADD, avec, KeyEvent.VK_EQUALS, maj);
        }
        if (touche.equals("-")) {
            return touches(false, KeyEvent.VK_MINUS, avec, KeyEvent.VK_SUBTRACT, avec);
        }
        int code = KeyStroke.getKeyStroke(touche).getKeyCode();
        // Java numérote les flèches dans un autre ordre au pavé
        int pave = code == KeyEvent.VK_UP ? KeyEvent.VK_KP_UP : code == KeyEvent.VK_DOWN ? KeyEvent.VK_KP_DOWN
                : code == KeyEvent.VK_LEFT ? KeyEvent.VK_KP_LEFT : code == KeyEvent.VK_RIGHT ? KeyEvent.VK_KP_RIGHT : code;
        return touches(relachee, code, avec, pave, avec);
    }

    private static List<KeyStroke> touches(boolean relachees, int... codes) {
        return IntStream.range(0, codes.length / 2)
                .mapToObj(k -> KeyStroke.getKeyStroke(codes[2 * k], codes[2 * k + 1], relachees)).distinct()
                .collect(Collectors.toList());
    }

    private static String touche(String notation) {
        return notation.substring(notation.lastIndexOf(' ') + 1);
    }

    private static int modificateurs(String notation) {
        int masque = 0;
        for (String mot : notation.split(" ")) {
            // getMenuShortcutKeyMaskEx n'existe que depuis Java 10 : il rend ce masque six bits plus haut
            masque |= mot.equals("menu") ? Toolkit.getDefaultToolkit().getMenuShortcutKeyMask() << 6
                    : mot.equals("ctrl") ? InputEvent.CTRL_DOWN_MASK : mot.equals("alt") ? InputEvent.ALT_DOWN_MASK
                    : mot.equals("shift") ? InputEvent.SHIFT_DOWN_MASK : 0;
        }
        return masque;
    }

    /** Texte de ces touches, par exemple « Ctrl+Alt+1, 2, 3, 4 » : ce qui se répète n'est dit qu'une fois. */
    static String dire(String... notations) {
        int avec = notations.length == 0 ? 0 : modificateurs(notations[0]);
        List<String> noms = Arrays.stream(notations).map(Touches::nommer).collect(Collectors.toList());
        String debut = avec == 0 ? "" : InputEvent.getModifiersExText(avec) + "+";
        return debut + (noms.size() > 4 ? Stream.of(noms.get(0), noms.get(noms.size() - 1))
                .collect(Collectors.joining(" à ")) : String.join(", ", noms));
    }

    private static String nommer(String notation) {
        String touche = touche(notation);
        return touche.equals("-") ? "−" : touche.matches("\\W|\\d") ? touche
                : KeyEvent.getKeyText(KeyStroke.getKeyStroke(touche).getKeyCode()).replace("Echap", "Échap");
    }
}
