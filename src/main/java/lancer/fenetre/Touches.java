package lancer.fenetre;

import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.KeyStroke;

/**
 * Les touches d'une notation comme {@code menu shift Z}, qui est celle de {@link KeyStroke}, sauf {@code menu} : Ctrl,
 * ou Commande sur un Mac. Un clavier français et le pavé numérique en ont d'autres que le clavier anglais.
 */
final class Touches {

    /** Notation, nom français, autres touches : les noms que donne Java suivent la langue de la machine. */
    private static final String[][] NOMS = {{"ESCAPE", "Échap"}, {"ENTER", "Entrée"}, {"SPACE", "Espace"},
        {"PAGE_UP", "Page précédente"}, {"PAGE_DOWN", "Page suivante"}, {"LEFT", "Gauche", "KP_LEFT"},
        {"RIGHT", "Droite", "KP_RIGHT"}, {"UP", "Haut", "KP_UP"}, {"DOWN", "Bas", "KP_DOWN"},
        {"PLUS", "+", "ADD", "shift EQUALS"}, {"MINUS", "−", "SUBTRACT"}, {"menu", "Ctrl"}, {"ctrl", "Ctrl"},
        {"alt", "Alt"}, {"shift", "Maj"}};

    /** Les touches de 0 à 9 d'un clavier français, sans Maj. */
    private static final String FRANCAIS = "à&é\"'(-è_ç";

    private Touches() {
    }

    /** La première est celle qu'un menu affiche. */
    static List<KeyStroke> de(String notation) {
        // getMenuShortcutKeyMaskEx n'existe que depuis Java 10
        boolean mac = Toolkit.getDefaultToolkit().getMenuShortcutKeyMask() == InputEvent.META_MASK;
        int debut = notation.lastIndexOf(' ') + 1;
        String avec = notation.substring(0, debut).replace("menu", mac ? "meta" : "ctrl");
        String touche = notation.substring(debut);
        List<KeyStroke> touches = Stream.concat(Stream.of(touche), Arrays.stream(NOMS)
                .filter(nom -> nom[0].equals(touche)).flatMap(nom -> Arrays.stream(nom).skip(2)))
                .map(autre -> KeyStroke.getKeyStroke(avec + autre)).collect(Collectors.toList());
        if (Character.isDigit(touche.charAt(0))) {
            int chiffre = touches.get(0).getKeyCode();
            int sans = touches.get(0).getModifiers();
            int francais = KeyEvent.getExtendedKeyCodeForChar(FRANCAIS.charAt(chiffre - '0'));
            touches.add(KeyStroke.getKeyStroke(KeyEvent.VK_NUMPAD0 + chiffre - '0', sans));
            touches.add(KeyStroke.getKeyStroke(francais, sans));
            touches.add(KeyStroke.getKeyStroke(francais, sans | InputEvent.SHIFT_DOWN_MASK));
            touches.add(KeyStroke.getKeyStroke(chiffre, sans | InputEvent.SHIFT_DOWN_MASK));
        }
        return touches;
    }

    /** Texte de ces touches, par exemple « Ctrl+Alt+1, 2, 3, 4 » : ce qui se répète n'est dit qu'une fois. */
    static String dire(String... notations) {
        int debut = notations[0].lastIndexOf(' ') + 1;
        String dit = notations[0].substring(0, debut).replace(' ', '+') + Arrays.stream(notations)
                .map(notation -> notation.substring(debut)).collect(Collectors.joining(", "));
        for (String[] nom : NOMS) {
            dit = dit.replaceAll("\\b" + nom[0] + "\\b", nom[1]);
        }
        return notations.length > 4 ? dit.replaceFirst(",.*,", " à") : dit;
    }
}
