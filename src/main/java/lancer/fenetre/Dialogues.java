package lancer.fenetre;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JScrollPane;
import javax.swing.UIManager;
import javax.swing.filechooser.FileFilter;
import javax.swing.filechooser.FileNameExtensionFilter;
import lancer.texte.Texte;

/** Les dialogues, en français même là où Java ne l'est pas, et le tableau des touches. */
final class Dialogues {

    private static final String TITRE_IMAGE = "Enregistrer l'image";

    /** Place qu'un dialogue laisse, sur un petit écran, à son propre cadre. */
    private static final int BORDS = 40;

    /** Vrai tant qu'un choix de fichier est à l'écran : une touche qui se répète en ouvrirait un autre par-dessus. */
    private static boolean ouvert;

    private Dialogues() {
    }

    /** Pose, avant le premier dialogue, ses textes : selon Java, il en manque en français. */
    private static void traduire() {
        for (String[] texte : lire("dialogues.txt")) {
            UIManager.getLookAndFeelDefaults().put(texte[0], texte[1]);
        }
    }

    /** Les lignes d'un fichier de textes, chacune deux colonnes que sépare une tabulation. */
    private static String[][] lire(String fichier) {
        try (BufferedReader texte = new BufferedReader(new InputStreamReader(
                Dialogues.class.getResourceAsStream(fichier), StandardCharsets.UTF_8))) {
            return texte.lines().map(ligne -> ligne.split("\t")).toArray(String[][]::new);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static Rectangle ecran() {
        return GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
    }

    /** Le tableau des touches : il reste ouvert pendant qu'on les essaie, et laisse donc le clavier au cadre. */
    static JDialog touches(JFrame cadre) {
        JLabel table = new JLabel("<html><table>" + Arrays.stream(lire("touches.txt"))
                .map(ligne -> "<tr><td>" + ligne[0] + "<td>" + ligne[1]).collect(Collectors.joining()));
        table.setName("table");
        JDialog touches = new JDialog(cadre, "Touches");
        JScrollPane ascenseur = new JScrollPane(table);
        touches.add(ascenseur);
        touches.setFocusableWindowState(false);
        touches.pack();
        Rectangle ecran = ecran();
        int barre = ascenseur.getVerticalScrollBar().getPreferredSize().width;
        touches.setSize(Math.min(touches.getWidth() + barre, ecran.width), Math.min(touches.getHeight(), ecran.height));
        touches.setLocation(ecran.x + ecran.width - touches.getWidth(), ecran.y);
        return touches;
    }

    /** @param actuelle la scène déjà ouverte, dont le dossier est proposé, ou {@code null} */
    static File choisirScene(Component parent, String actuelle) {
        traduire();
        JFileChooser choix = new JFileChooser(dossierDesScenes(actuelle));
        File choisi = choisir(parent, choix, "Ouvrir une scène", new FileNameExtensionFilter("Scènes (*.ini)", "ini"));
        File complet = choisi == null ? null : new File(choisi.getPath() + ".ini");
        return choisi != null && !choisi.exists() && complet.exists() ? complet : choisi;
    }

    private static File dossierDesScenes(String actuelle) {
        return actuelle != null ? new File(actuelle).getAbsoluteFile().getParentFile()
                // depuis la racine, ou depuis le dossier d'une variante
                : Stream.of("scenes", "../scenes").map(nom -> new File(nom).getAbsoluteFile())
                .filter(File::isDirectory).findFirst().orElse(new File("").getAbsoluteFile());
    }

    /** Le fichier où enregistrer l'image, qui finit par .png et peut être remplacé ; {@code null} : aucun. */
    static File choisirImage(Component parent, File proposee) {
        traduire();
        JFileChooser choix = new JFileChooser(proposee.getParentFile());
        choix.setDialogType(JFileChooser.SAVE_DIALOG);
        choix.setSelectedFile(proposee);
        File choisi = choisir(parent, choix, TITRE_IMAGE, new FileNameExtensionFilter("Images PNG (*.png)", "png"));
        File cible = choisi == null || Texte.minuscules(choisi.getName()).endsWith(".png") ? choisi
                : new File(choisi.getPath() + ".png");
        return cible == null || cible.isFile() && !confirmerRemplacement(parent, cible) ? null : cible;
    }

    private static boolean confirmerRemplacement(Component parent, File fichier) {
        String[] reponses = {"Remplacer", "Annuler"};
        int reponse = JOptionPane.showOptionDialog(parent,
                "Le fichier « " + Texte.echappe(fichier.getName()) + " » existe déjà. Le remplacer ?",
                TITRE_IMAGE, JOptionPane.DEFAULT_OPTION, JOptionPane.WARNING_MESSAGE, null, reponses, reponses[1]);
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
        Dimension voulue = choix.getPreferredSize();
        choix.setPreferredSize(new Dimension(Math.min(voulue.width, ecran().width - BORDS),
                Math.min(voulue.height, ecran().height - BORDS)));
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
