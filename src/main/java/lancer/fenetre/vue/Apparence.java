package lancer.fenetre.vue;

import java.awt.Font;
import java.awt.Toolkit;
import java.util.ArrayList;
import java.util.Locale;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.plaf.FontUIResource;
import javax.swing.plaf.InputMapUIResource;

/** L'apparence des fenêtres : FlatLaf, sombre si le bureau l'est, ou l'apparence de Java si FlatLaf est absent. */
public final class Apparence {

    /** La taille ordinaire des textes, en points. */
    private static int ordinaire;

    private Apparence() {
    }

    /**
     * À appeler avant de créer le premier composant.
     *
     * @return la taille ordinaire des textes, en points
     * @throws Error sans polices, ou sans fontconfig
     */
    public static int preparer() {
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
        ordinaire = UIManager.getFont("Label.font").getSize();
        return ordinaire;
    }

    static int getOrdinaire() {
        return ordinaire;
    }

    /** Donne cette taille, en points, aux textes de tous les composants à venir. */
    public static void donnerAuxTextes(int taille) {
        FontUIResource police = new FontUIResource(UIManager.getFont("Label.font").deriveFont((float) taille));
        new ArrayList<>(UIManager.getLookAndFeelDefaults().keySet()).stream()
                .filter(cle -> cle.toString().endsWith("ont") && UIManager.getFont(cle) != null)
                .forEach(cle -> UIManager.put(cle, police));
    }

    /** Dit si le bureau a un thème sombre, quand Java le sait. */
    private static boolean estSombre() {
        Object theme = Toolkit.getDefaultToolkit().getDesktopProperty("gnome.Net/ThemeName");
        return theme != null && theme.toString().toLowerCase(Locale.ROOT).contains("dark");
    }
}
