package lancer.fenetre;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import java.util.function.IntPredicate;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.ComponentInputMap;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
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

    /** Une ligne de la table : une action, ou plusieurs que distingue leur rang. Seules celles dites sont dans F1. */
    static final class Ligne {

        private final String nom;
        private final String dit;
        private final BooleanSupplier possible;
        private final IntConsumer faire;
        private final String[] touches;
        private String[] choix = {};
        private IntPredicate choisi;

        private Ligne(String nom, String dit, BooleanSupplier possible, IntConsumer faire, String... touches) {
            this.nom = nom;
            this.dit = dit;
            this.possible = possible;
            this.faire = faire;
            this.touches = touches;
        }

        /** Un sous-menu où chaque rang a son article. */
        Ligne choix(String... noms) {
            choix = noms;
            return this;
        }

        /** L'article de ce rang est coché si {@code condition} est vraie. */
        Ligne coche(IntPredicate condition) {
            choisi = condition;
            return this;
        }

        private boolean sansLien() {
            return touches.length > 0 && !touches[0].matches("F\\d+|.* .*");
        }
    }

    private final List<Ligne> lignes = new ArrayList<>();
    private final List<Runnable> aMontrer = new ArrayList<>();

    /** Ajoute une ligne. @param nom celui de son article @param dit son effet dans F1, ou {@code null} */
    Ligne ligne(String nom, String dit, BooleanSupplier possible, IntConsumer faire, String... touches) {
        lignes.add(new Ligne(nom, dit, possible, faire, touches));
        return lignes.get(lignes.size() - 1);
    }

    Ligne ligne(String nom, String dit, BooleanSupplier possible, Runnable faire, String... touches) {
        return ligne(nom, dit, possible, rang -> faire.run(), touches);
    }

    /** Ajoute un geste de la souris, que F1 décrit. */
    void souris(String geste, String dit) {
        ligne(geste, dit, () -> false, () -> { });
    }

    /** Le tableau de F1 : les touches, et leur effet. */
    Map<String, String> dire() {
        Map<String, String> dites = new LinkedHashMap<>();
        lignes.stream().filter(ligne -> ligne.dit != null).forEach(ligne -> dites.merge(ligne.touches.length == 0
                ? ligne.nom : Touches.dire(ligne.touches), ligne.dit, (un, autre) -> un + "<br>sinon " + autre));
        return dites;
    }

    /** Fait défiler ce texte d'une page, vers le haut si {@code rang} est nul. */
    static void defiler(JScrollPane texte, int rang) {
        JScrollBar barre = texte.getVerticalScrollBar();
        barre.setValue(barre.getValue() + (2 * rang - 1) * barre.getBlockIncrement(1));
    }

    private void executer(Ligne ligne, int rang) {
        ligne.faire.accept(rang);
        montrer();
    }

    /** Grise les articles impossibles, et coche ceux qui sont choisis. */
    void montrer() {
        aMontrer.forEach(Runnable::run);
    }

    /** Lie les touches de la table. Liées à la racine du cadre, elles manqueraient à un menu ouvert. */
    void lier(JComponent contenu) {
        // en place, cette table serait relue à chaque touche qui s'y ajoute
        ComponentInputMap touches = new ComponentInputMap(contenu);
        for (Ligne ligne : lignes) {
            for (int k = 0; k < ligne.touches.length; k++) {
                int rang = k;
                for (KeyStroke touche : Touches.de(ligne.touches[k])) {
                    touches.put(touche, touche);
                    if (contenu.getActionMap().get(touche) == null) {
                        contenu.getActionMap().put(touche, new Touche(touche));
                    }
                    ((Touche) contenu.getActionMap().get(touche)).siennes.add(() -> ligne.possible.getAsBoolean()
                            ? () -> executer(ligne, rang) : null);
                }
            }
        }
        contenu.setInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW, touches);
    }

    /** Ce que fait une touche : la première de ses lignes qui est possible. */
    @SuppressWarnings("serial")
    private static final class Touche extends AbstractAction {

        /** Vrai si un texte ou un tableau garde cette touche pour lui : sans Ctrl ni Alt, sauf Échap et F1 à F12. */
        private final boolean saisie;
        private final List<Supplier<Runnable>> siennes = new ArrayList<>();

        Touche(KeyStroke touche) {
            int code = touche.getKeyCode();
            saisie = (touche.getModifiers() & AVEC) == 0 && code != KeyEvent.VK_ESCAPE
                    && (code < KeyEvent.VK_F1 || code > KeyEvent.VK_F12);
        }

        private Runnable premiere() {
            return siennes.stream().map(Supplier::get).filter(Objects::nonNull).findFirst().orElse(null);
        }

        /** Sinon, la touche garde son autre sens : dans un menu ouvert, dans un texte. */
        @Override
        public boolean isEnabled() {
            Component clavier = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
            boolean ecrit = clavier instanceof JTable
                    || clavier instanceof JTextComponent && ((JTextComponent) clavier).isEditable();
            return !(saisie && ecrit) && MenuSelectionManager.defaultManager().getSelectedPath().length == 0
                    && premiere() != null;
        }

        @Override
        public void actionPerformed(ActionEvent e) {
            premiere().run();
        }
    }

    /** Un menu de ces lignes, de sous-menus et d'autres actions ; {@code null} pour un trait. */
    JMenu menu(String nom, Object... contenu) {
        JMenu menu = new JMenu(nom);
        menu.setMnemonic(nom.charAt(0));
        for (Object quoi : contenu) {
            if (quoi == null) {
                menu.addSeparator();
            } else if (quoi instanceof Ligne) {
                ajouter(menu, (Ligne) quoi);
            } else {
                menu.add((javax.swing.Action) quoi);
            }
        }
        return menu;
    }

    private void ajouter(JMenu menu, Ligne ligne) {
        if (ligne.choix.length > 0) {
            JMenu sousMenu = article(menu, new JMenu(ligne.nom), null, () -> { });
            aMontrer.add(() -> sousMenu.setEnabled(ligne.possible.getAsBoolean()));
            for (int k = 0; k < ligne.choix.length; k++) {
                ajouter(sousMenu, new JRadioButtonMenuItem(ligne.choix[k]), ligne, k);
            }
        } else {
            String nom = ligne.nom + (ligne.sansLien() ? " (" + Touches.dire(ligne.touches) + ")" : "");
            ajouter(menu, ligne.choisi == null ? new JMenuItem(nom) : new JCheckBoxMenuItem(nom), ligne, 0);
        }
    }

    private void ajouter(JMenu menu, JMenuItem article, Ligne ligne, int rang) {
        // liée à son article, une touche sans Ctrl ni Alt manquerait à un texte ou à un menu
        article(menu, article, rang < ligne.touches.length && !ligne.sansLien()
                ? Touches.de(ligne.touches[rang]).get(0) : null, () -> executer(ligne, rang));
        aMontrer.add(() -> {
            article.setEnabled(ligne.possible.getAsBoolean());
            article.setSelected(ligne.choisi != null && ligne.choisi.test(rang));
        });
    }

    /** Ajoute un article. Sa lettre, si possible, est une que les autres articles de son menu n'ont pas. */
    static <T extends JMenuItem> T article(JMenu menu, T article, KeyStroke touche, Runnable action) {
        // un nom de fichier qui commence par <html> doit être affiché tel quel
        article.putClientProperty("html.disable", true);
        article.updateUI();
        article.setMnemonic(article.getText().chars().filter(c -> c < 128 && Character.isLetterOrDigit(c))
                .map(KeyEvent::getExtendedKeyCodeForChar)
                .filter(lettre -> Arrays.stream(menu.getMenuComponents()).noneMatch(autre -> autre instanceof JMenuItem
                        && ((JMenuItem) autre).getMnemonic() == lettre)).findFirst().orElse(KeyEvent.VK_UNDEFINED));
        if (touche != null) {
            article.setAccelerator(touche);
        }
        article.addActionListener(e -> action.run());
        menu.add(article);
        return article;
    }
}
