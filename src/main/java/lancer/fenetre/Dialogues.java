package lancer.fenetre;

import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.io.File;
import java.util.Arrays;
import java.util.Locale;
import javax.swing.JColorChooser;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.colorchooser.AbstractColorChooserPanel;
import javax.swing.filechooser.FileFilter;
import javax.swing.filechooser.FileNameExtensionFilter;
import lancer.Couleur;
import lancer.texte.Nombre;
import lancer.texte.Texte;

/** Les dialogues, en français même là où Java ne l'est pas, et l'apparence du système. */
final class Dialogues {

    /** Un texte, et les clés, de {@code FileChooser} à défaut, qui le montrent : selon Java, il en manque. */
    private static final String[][] TEXTES = {
        {"Dossier :", "lookInLabelText", "saveInLabelText"},
        {"Nom du fichier :", "fileNameLabelText"},
        {"Nom du dossier :", "folderNameLabelText"},
        {"Type de fichiers :", "filesOfTypeLabelText"},
        {"Dossier parent", "upFolderToolTipText", "upFolderAccessibleName"},
        {"Dossier personnel", "homeFolderToolTipText", "homeFolderAccessibleName"},
        {"Nouveau dossier", "newFolderToolTipText", "newFolderAccessibleName", "newFolderActionLabelText"},
        {"Liste", "listViewButtonToolTipText", "listViewButtonAccessibleName", "listViewActionLabelText"},
        {"Détails", "detailsViewButtonToolTipText", "detailsViewButtonAccessibleName", "detailsViewActionLabelText"},
        {"Affichage", "viewMenuLabelText"},
        {"Actualiser", "refreshActionLabelText"},
        {"Nom", "fileNameHeaderText"},
        {"Taille", "fileSizeHeaderText"},
        {"Type", "fileTypeHeaderText"},
        {"Modifié", "fileDateHeaderText"},
        {"Tous les fichiers", "acceptAllFileFilterText"},
        {"Ouvrir", "openButtonText", "directoryOpenButtonText"},
        {"Ouvrir le fichier choisi", "openButtonToolTipText"},
        {"Ouvrir le dossier choisi", "directoryOpenButtonToolTipText"},
        {"Enregistrer", "saveButtonText"},
        {"Enregistrer sous ce nom", "saveButtonToolTipText"},
        {"Annuler", "cancelButtonText", "ColorChooser.cancelText"},
        {"Choisir", "ColorChooser.okText"},
        {"Revenir", "ColorChooser.resetText"},
        {"Rouge", "ColorChooser.rgbRedText"},
        {"Vert", "ColorChooser.rgbGreenText"},
        {"Bleu", "ColorChooser.rgbBlueText"},
        {"Aperçu", "ColorChooser.previewText"},
        {"Fermer sans rien choisir", "cancelButtonToolTipText"},
    };

    private static final String TITRE_IMAGE = "Enregistrer l'image";

    /** Ce qu'un dialogue laisse d'un petit écran à son propre cadre. */
    private static final int BORDS = 40;

    /** Vrai tant qu'un choix de fichier est à l'écran : une touche qui se répète en ouvrirait un autre par-dessus. */
    private static boolean ouvert;

    private Dialogues() {
    }

    /** Pose l'apparence et la langue ; à appeler avant de créer le premier composant. */
    static void preparer() {
        // l'apparence de secours, Metal, mettrait tout en gras, et l'avancement en blanc sur bleu pâle
        UIManager.put("swing.boldMetal", false);
        UIManager.put("ProgressBar.selectionForeground", Color.BLACK);
        UIManager.put("ProgressBar.selectionBackground", Color.BLACK);
        try {
            UIManager.setLookAndFeel(UIManager.getSystemLookAndFeelClassName());
        } catch (ReflectiveOperationException | UnsupportedLookAndFeelException | LinkageError e) {
            // celle de Java, déjà en place
        }
        JComponent.setDefaultLocale(Locale.FRANCE);
        for (String[] texte : TEXTES) {
            for (int k = 1; k < texte.length; k++) {
                UIManager.put(texte[k].indexOf('.') < 0 ? "FileChooser." + texte[k] : texte[k], texte[0]);
            }
        }
    }

    /** @param actuelle la scène déjà ouverte, dont le dossier est proposé, ou {@code null} */
    static File choisirScene(Component parent, String actuelle) {
        JFileChooser choix = new JFileChooser(dossierDesScenes(actuelle));
        File choisi = choisir(parent, choix, "Ouvrir une scène", new FileNameExtensionFilter("Scènes (*.ini)", "ini"));
        File complet = choisi == null ? null : new File(choisi.getPath() + ".ini");
        return choisi != null && !choisi.exists() && complet.exists() ? complet : choisi;
    }

    private static File dossierDesScenes(String actuelle) {
        if (actuelle != null) {
            return new File(actuelle).getAbsoluteFile().getParentFile();
        }
        // depuis la racine, ou depuis le dossier d'une variante
        File ici = new File("scenes").getAbsoluteFile();
        File plusHaut = new File("../scenes").getAbsoluteFile();
        return ici.isDirectory() ? ici : plusHaut.isDirectory() ? plusHaut : new File("").getAbsoluteFile();
    }

    static File choisirImage(Component parent, File proposee) {
        JFileChooser choix = new JFileChooser(proposee.getParentFile());
        choix.setDialogType(JFileChooser.SAVE_DIALOG);
        choix.setSelectedFile(proposee);
        return choisir(parent, choix, TITRE_IMAGE, new FileNameExtensionFilter("Images PNG (*.png)", "png"));
    }

    /** Demande une couleur, {@code null} pour garder celle-ci ; par ses trois composantes, comme dans la scène. */
    static Color choisirCouleur(Component parent, Color actuelle) {
        JColorChooser choix = new JColorChooser(actuelle);
        for (AbstractColorChooserPanel panneau : choix.getChooserPanels()) {
            if (choix.getChooserPanels().length > 1 && !panneau.getDisplayName().matches("R[GV]B")) {
                choix.removeChooserPanel(panneau);
            }
        }
        Color[] choisie = new Color[1];
        JColorChooser.createDialog(parent, "Couleur", true, choix, e -> choisie[0] = choix.getColor(), null)
                .setVisible(true);
        return choisie[0];
    }

    /** La couleur que dit un fichier de scène, composantes limitées à 1. */
    static Color couleur(String valeur) {
        double[] rvb = Arrays.stream(valeur.trim().split("\\s+")).mapToDouble(Nombre::lire).toArray();
        return new Color(new Couleur(rvb[0], rvb[1], rvb[2]).getCode());
    }

    /** Ce qu'en écrirait un fichier de scène. */
    static String ecrire(Color couleur) {
        float[] rvb = couleur.getRGBColorComponents(null);
        return String.format(Locale.ROOT, "%.3f %.3f %.3f", rvb[0], rvb[1], rvb[2]);
    }

    static boolean confirmerRemplacement(Component parent, File fichier) {
        String[] reponses = {"Remplacer", "Annuler"};
        int reponse = JOptionPane.showOptionDialog(parent,
                "Le fichier « " + Texte.echappe(fichier.getName()) + " » existe déjà. Le remplacer ?",
                TITRE_IMAGE,
                JOptionPane.DEFAULT_OPTION, JOptionPane.WARNING_MESSAGE, null, reponses, reponses[1]);
        parent.requestFocus();
        return reponse == 0;
    }

    private static File choisir(Component parent, JFileChooser choix, String titre, FileFilter filtre) {
        if (ouvert) {
            return null;
        }
        ouvert = true;
        choix.setDialogTitle(titre);
        choix.setFileFilter(filtre);
        Rectangle ecran = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        Dimension voulue = choix.getPreferredSize();
        choix.setPreferredSize(new Dimension(Math.min(voulue.width, ecran.width - BORDS),
                Math.min(voulue.height, ecran.height - BORDS)));
        try {
            int reponse = choix.showDialog(parent, null);
            return reponse == JFileChooser.APPROVE_OPTION ? choix.getSelectedFile() : null;
        } finally {
            ouvert = false;
            // certains bureaux ne rendent pas le clavier à la fenêtre quand un dialogue se ferme
            parent.requestFocus();
        }
    }
}
