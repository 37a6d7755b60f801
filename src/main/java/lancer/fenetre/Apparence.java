package lancer.fenetre;

import java.awt.Color;
import java.awt.Window;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.Preferences;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;

/** L'apparence de toutes les fenêtres : celle de FlatLaf, claire ou sombre ; celle de Java si FlatLaf est absent. */
final class Apparence {

    private static final String SOMBRE = "sombre";

    /** Java écrit sur l'erreur standard s'il ne peut garder une préférence : cela n'empêche rien. */
    private static final Logger MUET = Logger.getLogger("java.util.prefs");

    private Apparence() {
    }

    /** Pose l'apparence choisie la dernière fois ; à appeler avant de créer le premier composant. */
    static void preparer() {
        MUET.setLevel(Level.OFF);
        // FlatLaf chercherait sinon une bibliothèque du système, que l'archive n'a pas
        System.setProperty("flatlaf.useNativeLibrary", "false");
        UIManager.put("swing.boldMetal", false);
        UIManager.put("MenuItem.acceleratorDelimiter", "+");
        poser(estSombre());
    }

    static boolean estSombre() {
        return preferences().getBoolean(SOMBRE, false);
    }

    /** Change l'apparence des fenêtres ouvertes, et de celles des prochaines fois. */
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
            // celle de Java, déjà en place
        }
    }

    /** La couleur de ce nom dans FlatLaf, sinon celle-ci, que toutes les apparences ont. */
    static Color couleur(String nom, String partout) {
        Color couleur = UIManager.getColor(nom);
        return couleur == null ? UIManager.getColor(partout) : couleur;
    }
}
