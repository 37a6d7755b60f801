package lancer.fenetre;

import java.awt.Color;
import java.awt.Window;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.Preferences;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.plaf.InputMapUIResource;

/** L'apparence de toutes les fenêtres : FlatLaf, clair ou sombre, ou l'apparence de Java si FlatLaf est absent. */
final class Apparence {

    private static final String SOMBRE = "sombre";

    /** Java avertit sur l'erreur standard s'il ne peut garder une préférence : ce message est inutile. */
    private static final Logger MUET = Logger.getLogger("java.util.prefs");

    private Apparence() {
    }

    /** Applique l'apparence choisie la dernière fois ; à appeler avant de créer le premier composant. */
    static void preparer() {
        MUET.setLevel(Level.OFF);
        // sinon, FlatLaf chercherait une bibliothèque du système, absente de l'archive
        System.setProperty("flatlaf.useNativeLibrary", "false");
        UIManager.put("swing.boldMetal", false);
        UIManager.put("MenuItem.acceleratorDelimiter", "+");
        // les flèches et Ctrl servent à l'image, et non à changer d'onglet ou à déplacer un trait
        UIManager.put("TabbedPane.ancestorInputMap", new InputMapUIResource());
        UIManager.put("SplitPane.ancestorInputMap", new InputMapUIResource());
        // certaines versions de Java n'ont pas en français les textes des dialogues
        UIManager.getDefaults().addResourceBundle("lancer.fenetre.dialogues");
        poser(estSombre());
    }

    static boolean estSombre() {
        return preferences().getBoolean(SOMBRE, false);
    }

    /** Change l'apparence des fenêtres ouvertes, et celle des prochains lancements. */
    static void changer(boolean sombre) {
        preferences().putBoolean(SOMBRE, sombre);
        poser(sombre);
        for (Window fenetre : Window.getWindows()) {
            SwingUtilities.updateComponentTreeUI(fenetre);
        }
    }

    private static Preferences preferences() {
        return Preferences.userRoot().node("lancer");
    }

    private static void poser(boolean sombre) {
        try {
            UIManager.setLookAndFeel("com.formdev.flatlaf." + (sombre ? "FlatDarkLaf" : "FlatLightLaf"));
        } catch (ReflectiveOperationException | UnsupportedLookAndFeelException | LinkageError e) {
            // l'apparence de Java est déjà en place
        }
    }

    /** La couleur {@code nom} de FlatLaf ou, à défaut, la couleur {@code partout}, que toute apparence définit. */
    static Color couleur(String nom, String partout) {
        Color couleur = UIManager.getColor(nom);
        return couleur == null ? UIManager.getColor(partout) : couleur;
    }
}
