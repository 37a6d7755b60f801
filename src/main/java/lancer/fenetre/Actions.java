package lancer.fenetre;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import java.util.function.IntPredicate;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.MenuSelectionManager;
import javax.swing.text.JTextComponent;

/**
 * La table des actions de la fenêtre : nom, touches, effet, condition. Les menus, les touches et le tableau de F1 en
 * viennent. Si plusieurs lignes ont la même touche, la première qui est possible répond.
 */
final class Actions {

    private static final int AVEC = InputEvent.CTRL_DOWN_MASK | InputEvent.ALT_DOWN_MASK | InputEvent.META_DOWN_MASK;

    private final List<Ligne> lignes = new ArrayList<>();
    private final List<Runnable> aMontrer = new ArrayList<>();

    /** Une action, ou plusieurs que distingue leur rang. Un menu dit son texte jusqu'aux deux points, F1 en entier. */
    static final class Ligne {

        private final String texte;
        private final BooleanSupplier possible;
        private final IntConsumer faire;
        private final String[] touches;
        private IntPredicate coche;
        private String[] choix = {};

        private Ligne(String texte, BooleanSupplier possible, IntConsumer faire, String... touches) {
            this.texte = texte;
            this.possible = possible;
            this.faire = faire;
            this.touches = touches;
        }

        /** Un article coché si {@code condition} est vraie, ou un sous-menu où chaque rang a son article. */
        Ligne coche(IntPredicate condition, String... noms) {
            coche = condition;
            choix = noms;
            return this;
        }
    }

    Ligne ligne(String texte, BooleanSupplier possible, IntConsumer faire, String... touches) {
        lignes.add(new Ligne(texte, possible, faire, touches));
        return lignes.get(lignes.size() - 1);
    }

    Ligne ligne(String texte, BooleanSupplier possible, Runnable faire, String... touches) {
        return ligne(texte, possible, rang -> faire.run(), touches);
    }

    /** Les touches, et ce qu'elles font. */
    Map<String, String> dire() {
        Map<String, String> dites = new LinkedHashMap<>();
        lignes.stream().filter(ligne -> ligne.texte != null && ligne.touches.length > 0)
                .forEach(ligne -> dites.merge(Touches.dire(ligne.touches), Character.toLowerCase(ligne.texte.charAt(0))
                        + ligne.texte.substring(1).replace("…", ""), (un, autre) -> un + "<br>sinon " + autre));
        return dites;
    }

    /** Fait défiler ce texte d'une page, vers le haut si {@code rang} est nul. */
    static void defiler(JScrollPane texte, int rang) {
        JScrollBar barre = texte.getVerticalScrollBar();
        barre.setValue(barre.getValue() + (2 * rang - 1) * barre.getBlockIncrement(1));
    }

    /** Grise les articles impossibles, et coche ceux qui sont choisis. */
    void montrer() {
        aMontrer.forEach(Runnable::run);
    }

    /** Donne à ce cadre les touches que n'ont prises ni un menu ni le composant qui a le clavier. */
    void lier(JFrame cadre) {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventPostProcessor(e -> cadre.isFocused()
                && !e.isConsumed() && MenuSelectionManager.defaultManager().getSelectedPath().length == 0
                && (executer(e, e.getKeyCode()) || executer(e, e.getExtendedKeyCode())));
    }

    /** Un texte et un tableau gardent les touches sans Ctrl ni Alt, sauf Échap et F1 à F12. */
    private static boolean estEcrite(KeyStroke touche, Component clavier) {
        int code = touche.getKeyCode();
        return (touche.getModifiers() & AVEC) == 0 && code != KeyEvent.VK_ESCAPE
                && (code < KeyEvent.VK_F1 || code > KeyEvent.VK_F12) && (clavier instanceof JTable
                || clavier instanceof JTextComponent && ((JTextComponent) clavier).isEditable());
    }

    /** Exécute la première ligne possible qui a cette touche. @return faux s'il n'y en a pas */
    private boolean executer(KeyEvent e, int code) {
        KeyStroke touche = KeyStroke.getKeyStroke(code, e.getModifiersEx(), e.getID() == KeyEvent.KEY_RELEASED);
        if (e.getID() == KeyEvent.KEY_TYPED || estEcrite(touche, e.getComponent())) {
            return false;
        }
        for (Ligne ligne : lignes) {
            for (int k = 0; k < ligne.touches.length; k++) {
                if (Touches.de(ligne.touches[k]).contains(touche) && ligne.possible.getAsBoolean()) {
                    executer(ligne, k);
                    return true;
                }
            }
        }
        return false;
    }

    private void executer(Ligne ligne, int rang) {
        ligne.faire.accept(rang);
        montrer();
    }

    /** Un menu de ces lignes ; {@code null} pour un trait. */
    JMenu menu(String nom, Ligne... siennes) {
        JMenu menu = new JMenu(nom);
        menu.setMnemonic(nom.charAt(0));
        menu.addChangeListener(e -> montrer());
        Arrays.stream(siennes).forEach(ligne -> ajouter(menu, ligne));
        return menu;
    }

    private void ajouter(JMenu menu, Ligne ligne) {
        if (ligne == null) {
            menu.addSeparator();
            return;
        }
        String nom = ligne.texte.split(" : ")[0];
        if (ligne.choix.length == 0) {
            ajouter(menu, ligne.coche == null ? new JMenuItem(nom) : new JCheckBoxMenuItem(nom), ligne, 0);
            return;
        }
        JMenu sousMenu = article(menu, new JMenu(nom), () -> { });
        aMontrer.add(() -> sousMenu.setEnabled(ligne.possible.getAsBoolean()));
        for (int k = 0; k < ligne.choix.length; k++) {
            ajouter(sousMenu, new JRadioButtonMenuItem(ligne.choix[k]), ligne, k);
        }
    }

    private void ajouter(JMenu menu, JMenuItem article, Ligne ligne, int rang) {
        article(menu, article, () -> executer(ligne, rang));
        if (rang < ligne.touches.length) {
            KeyStroke touche = Touches.de(ligne.touches[rang]).get(0);
            article.setAccelerator(touche);
            // liée par Swing, elle manquerait à un texte
            article.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(touche, "none");
        }
        aMontrer.add(() -> {
            article.setEnabled(ligne.possible.getAsBoolean());
            article.setSelected(ligne.coche != null && ligne.coche.test(rang));
        });
    }

    /** Ajoute un article. Sa lettre, si possible, est une que les autres articles de son menu n'ont pas. */
    static <T extends JMenuItem> T article(JMenu menu, T article, Runnable action) {
        // un nom de fichier qui commence par <html> doit être affiché tel quel
        article.putClientProperty("html.disable", true);
        article.updateUI();
        article.setMnemonic(article.getText().chars().filter(c -> c < 128 && Character.isLetterOrDigit(c))
                .map(KeyEvent::getExtendedKeyCodeForChar)
                .filter(lettre -> Arrays.stream(menu.getMenuComponents()).noneMatch(autre -> autre instanceof JMenuItem
                        && ((JMenuItem) autre).getMnemonic() == lettre)).findFirst().orElse(KeyEvent.VK_UNDEFINED));
        article.addActionListener(e -> action.run());
        menu.add(article);
        return article;
    }
}
