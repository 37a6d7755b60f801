package lancer.fenetre;

import java.awt.Color;
import java.awt.Component;
import java.io.File;
import java.util.Locale;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.filechooser.FileNameExtensionFilter;
import lancer.texte.Texte;

/** Les dialogues, en français même là où Java ne l'est pas, et l'apparence du système. */
final class Dialogues {

    /** Ce que dit Swing, en français : selon les versions de Java, ses traductions manquent. */
    private static final String[][] TEXTES = {
        {"FileChooser.lookInLabelText", "Dossier :"},
        {"FileChooser.saveInLabelText", "Dossier :"},
        {"FileChooser.fileNameLabelText", "Nom du fichier :"},
        {"FileChooser.folderNameLabelText", "Nom du dossier :"},
        {"FileChooser.filesOfTypeLabelText", "Type de fichiers :"},
        {"FileChooser.upFolderToolTipText", "Dossier parent"},
        {"FileChooser.upFolderAccessibleName", "Dossier parent"},
        {"FileChooser.homeFolderToolTipText", "Dossier personnel"},
        {"FileChooser.homeFolderAccessibleName", "Dossier personnel"},
        {"FileChooser.newFolderToolTipText", "Nouveau dossier"},
        {"FileChooser.newFolderAccessibleName", "Nouveau dossier"},
        {"FileChooser.newFolderActionLabelText", "Nouveau dossier"},
        {"FileChooser.listViewButtonToolTipText", "Liste"},
        {"FileChooser.listViewButtonAccessibleName", "Liste"},
        {"FileChooser.listViewActionLabelText", "Liste"},
        {"FileChooser.detailsViewButtonToolTipText", "Détails"},
        {"FileChooser.detailsViewButtonAccessibleName", "Détails"},
        {"FileChooser.detailsViewActionLabelText", "Détails"},
        {"FileChooser.viewMenuLabelText", "Affichage"},
        {"FileChooser.refreshActionLabelText", "Actualiser"},
        {"FileChooser.fileNameHeaderText", "Nom"},
        {"FileChooser.fileSizeHeaderText", "Taille"},
        {"FileChooser.fileTypeHeaderText", "Type"},
        {"FileChooser.fileDateHeaderText", "Modifié"},
        {"FileChooser.acceptAllFileFilterText", "Tous les fichiers"},
        {"FileChooser.openButtonText", "Ouvrir"},
        {"FileChooser.openButtonToolTipText", "Ouvrir le fichier choisi"},
        {"FileChooser.saveButtonText", "Enregistrer"},
        {"FileChooser.saveButtonToolTipText", "Enregistrer sous ce nom"},
        {"FileChooser.directoryOpenButtonText", "Ouvrir"},
        {"FileChooser.directoryOpenButtonToolTipText", "Ouvrir le dossier choisi"},
        {"FileChooser.cancelButtonText", "Annuler"},
        {"FileChooser.cancelButtonToolTipText", "Fermer sans rien choisir"},
    };

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
            UIManager.put(texte[0], texte[1]);
        }
    }

    /** @param actuelle la scène déjà ouverte, dont le dossier est proposé, ou {@code null} */
    static File choisirScene(Component parent, String actuelle) {
        if (ouvert) {
            return null;
        }
        JFileChooser choix = new JFileChooser(dossierDesScenes(actuelle));
        choix.setDialogTitle("Ouvrir une scène");
        choix.setFileFilter(new FileNameExtensionFilter("Scènes (*.ini)", "ini"));
        return choisir(parent, choix, JFileChooser.OPEN_DIALOG);
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

    /** @param dossier celui du dernier enregistrement, ou {@code null} */
    static File choisirImage(Component parent, File dossier, String nom) {
        if (ouvert) {
            return null;
        }
        File propose = dossier != null ? dossier : new File("").getAbsoluteFile();
        JFileChooser choix = new JFileChooser(propose);
        choix.setDialogTitle("Enregistrer l'image");
        choix.setFileFilter(new FileNameExtensionFilter("Images PNG (*.png)", "png"));
        choix.setSelectedFile(new File(propose, nom));
        return choisir(parent, choix, JFileChooser.SAVE_DIALOG);
    }

    static boolean confirmerRemplacement(Component parent, File fichier) {
        String[] reponses = {"Remplacer", "Annuler"};
        int reponse = JOptionPane.showOptionDialog(parent,
                "Le fichier « " + Texte.echappe(fichier.getName()) + " » existe déjà. Le remplacer ?",
                "Enregistrer l'image",
                JOptionPane.DEFAULT_OPTION, JOptionPane.WARNING_MESSAGE, null, reponses, reponses[1]);
        parent.requestFocus();
        return reponse == 0;
    }

    private static File choisir(Component parent, JFileChooser choix, int genre) {
        ouvert = true;
        try {
            int reponse = genre == JFileChooser.SAVE_DIALOG ? choix.showSaveDialog(parent)
                    : choix.showOpenDialog(parent);
            return reponse == JFileChooser.APPROVE_OPTION ? choix.getSelectedFile() : null;
        } finally {
            ouvert = false;
            // certains bureaux ne rendent pas le clavier à la fenêtre quand un dialogue se ferme
            parent.requestFocus();
        }
    }
}
