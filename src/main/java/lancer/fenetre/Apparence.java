package lancer.fenetre;

import java.awt.Font;
import java.awt.Toolkit;
import java.util.Locale;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.plaf.InputMapUIResource;

/** L'apparence des fenêtres : FlatLaf, sombre si le bureau l'est, ou l'apparence de Java si FlatLaf est absent. */
final class Apparence {

    private Apparence() {
    }

    /** À appeler avant de créer le premier composant. @throws Error sans polices, ou sans fontconfig */
    static void preparer() {
        new Font(Font.DIALOG, Font.PLAIN, 1).canDisplay('a');
        // sinon, FlatLaf chercherait une bibliothèque du système, absente de l'archive
        System.setProperty("flatlaf.useNativeLibrary", "false");
        UIManager.put("swing.boldMetal", false);
        UIManager.put("MenuItem.acceleratorDelimiter", "+");
        // les flèches et Ctrl servent à l'image, et non à changer d'onglet ou à déplacer un trait
        UIManager.put("TabbedPane.ancestorInputMap", new InputMapUIResource());
        UIManager.put("SplitPane.ancestorInputMap", new InputMapUIResource());
        // certaines versions de Java n'ont pas en français les textes des dialogues
        UIManager.getDefaults().addResourceBundle("lancer.fenetre.dialogues");
        try {
            UIManager.setLookAndFeel("com.formdev.flatlaf." + (estSombre() ? "FlatDarkLaf" : "FlatLightLaf"));
        } catch (ReflectiveOperationException | UnsupportedLookAndFeelException | LinkageError e) {
            // l'apparence de Java est déjà en place
        }
    }

    /** Dit si le bureau a un thème sombre, quand Java le sait. */
    private static boolean estSombre() {
        Object theme = Toolkit.getDefaultToolkit().getDesktopProperty("gnome.Net/ThemeName");
        return theme != null && theme.toString().toLowerCase(Locale.ROOT).contains("dark");
    }
}
