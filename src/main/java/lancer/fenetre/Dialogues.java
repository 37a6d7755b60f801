package lancer.fenetre;

import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.io.File;
import java.util.Locale;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.filechooser.FileFilter;
import javax.swing.filechooser.FileNameExtensionFilter;
import lancer.texte.Texte;

/** Les dialogues, en français même là où Java ne l'est pas, et l'apparence du système. */
final class Dialogues {

    /** Un texte, et les clés de {@code FileChooser} qui le montrent : selon Java, ses traductions manquent. */
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
        {"Annuler", "cancelButtonText"},
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
                UIManager.put("FileChooser." + texte[k], texte[0]);
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

    static void montrerTouches(Component parent) {
        JOptionPane.showMessageDialog(parent, "Ctrl+O   ouvrir une scène ; ou déposer son fichier sur la fenêtre\n"
                + "Page suivante, page précédente   les autres scènes du dossier\n"
                + "Ctrl+S, Ctrl+C   enregistrer, copier l'image\n"
                + "+ et −   plus ou moins de réflexions\n"
                + "F2   les paramètres des variantes\n"
                + "Espace, tenue   l'image d'avant\n"
                + "Ctrl+Maj+C   copier les réglages\n"
                + "Ctrl+1, Ctrl+0, F11   taille demandée, remplir la fenêtre, plein écran\n"
                + "molette, Ctrl+Haut, Ctrl+Bas   loupe ; la tirer la déplace\n"
                + "un clic, Entrée   les rayons du pixel ; flèches   le pixel voisin, Maj   de dix en dix\n"
                + "Ctrl+page suivante, Ctrl+page précédente   un autre échantillon du pixel\n"
                + "F5   relire la scène et redessiner ; l'enregistrer dans un éditeur le fait aussi\n"
                + "F3   vitesse ou précision : les réglages possibles, à dessiner d'un clic\n"
                + "Échap   arrêter le dessin ; sinon, fermer ce qui est à côté, ou le plein écran\n"
                + "Ctrl+Q   quitter\n"
                + "F1   ces touches", "Touches", JOptionPane.PLAIN_MESSAGE);
        parent.requestFocus();
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
