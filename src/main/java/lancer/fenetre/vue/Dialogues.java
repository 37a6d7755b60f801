package lancer.fenetre.vue;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.io.File;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.filechooser.FileNameExtensionFilter;
import lancer.fenetre.etat.Suite;
import lancer.texte.Texte;

/** Les dialogues, en français quelle que soit la langue de Java. */
final class Dialogues {

    /** Ce qu'un dialogue ajoute à la table des touches : une barre, son cadre, un bouton. */
    private static final int MARGE_H = 30;
    private static final int MARGE_V = 120;
    private static final int LARGEUR = 500;

    /** Vrai pendant le choix d'un fichier : une touche répétée ne doit pas en ouvrir un deuxième. */
    private static boolean ouvert;

    private Dialogues() {
    }

    static Rectangle ecran() {
        return GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
    }

    /** Le tableau des touches. @param lignes touche, puis effet, en lignes d'un tableau HTML */
    static void direTouches(Component parent, String lignes) {
        JLabel table = new JLabel("<html><table cellspacing=2 cellpadding=0 width="
                + Math.min(LARGEUR, ecran().width - 4 * MARGE_H) + ">" + lignes);
        table.setName("table");
        JScrollPane deroulant = new JScrollPane(table);
        deroulant.setBorder(null);
        // un petit écran, ou un écran dense, ne contient pas la table : les flèches la déroulent
        Stream.of("UP unitScrollUp", "DOWN unitScrollDown", "PAGE_UP scrollUp", "PAGE_DOWN scrollDown")
                .map(touche -> touche.split(" ")).forEach(touche -> deroulant.getInputMap(
                        JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(touche[0]), touche[1]));
        Dimension place = deroulant.getPreferredSize();
        deroulant.setPreferredSize(new Dimension(Math.min(place.width + MARGE_H, ecran().width - 2 * MARGE_H),
                Math.min(place.height, ecran().height - MARGE_V)));
        JOptionPane.showMessageDialog(parent, deroulant, "Touches", JOptionPane.PLAIN_MESSAGE);
    }

    /** La scène à ouvrir, ou {@code null}. @param actuelle celle dont le dossier est proposé, ou {@code null} */
    static File choisirScene(Component parent, String actuelle) {
        return choisir(parent, new JFileChooser(dossierDesScenes(actuelle)), "Ouvrir une scène", "ini");
    }

    /** Le dossier de cette scène ou, à défaut, celui des scènes du programme. */
    static File dossierDesScenes(String actuelle) {
        return actuelle != null ? new File(actuelle).getAbsoluteFile().getParentFile()
                // depuis la racine, ou depuis le dossier d'une variante
                : Stream.of("scenes", "../scenes").map(nom -> new File(nom).getAbsoluteFile())
                .filter(File::isDirectory).findFirst().orElse(new File("").getAbsoluteFile());
    }

    /** Le fichier où écrire, remplacement confirmé, ou {@code null}. @param fin celle de son nom, sans point */
    static File choisirOuEcrire(Component parent, File propose, String titre, String fin) {
        JFileChooser choix = new JFileChooser(propose.getParentFile());
        choix.setDialogType(JFileChooser.SAVE_DIALOG);
        choix.setSelectedFile(propose);
        File cible = choisir(parent, choix, titre, fin);
        boolean libre = cible == null || !cible.isFile() || demander(parent, titre, "Le fichier « "
                + Texte.echappe(cible.getName()) + " » existe déjà. Le remplacer ?", "Remplacer", "Annuler") == 0;
        return libre ? cible : null;
    }

    private static File choisir(Component parent, JFileChooser choix, String titre, String fin) {
        if (ouvert) {
            return null;
        }
        ouvert = true;
        choix.setDialogTitle(titre);
        choix.setFileFilter(new FileNameExtensionFilter("*." + fin, fin));
        int reponse = choix.showDialog(parent, null);
        ouvert = false;
        // certains bureaux ne rendent pas le clavier à la fenêtre après un dialogue
        parent.requestFocus();
        File choisi = reponse == JFileChooser.APPROVE_OPTION ? choix.getSelectedFile() : null;
        boolean complet = choisi == null || Texte.minuscules(choisi.getName()).endsWith("." + fin)
                || choix.getDialogType() == JFileChooser.OPEN_DIALOG && choisi.exists();
        return complet ? choisi : new File(choisi.getPath() + "." + fin);
    }

    /** Propose d'écrire la scène ailleurs. @param pourquoi ce qui a empêché de l'écrire dans son fichier */
    static boolean proposer(Component parent, String pourquoi) {
        return demander(parent, "Scène non écrite", new Etiquette("pourquoi").dire(pourquoi), "Écrire sous…", "Rester")
                == 0;
    }

    /** Demande que faire des changements de cette scène, qui ne sont pas écrits. */
    static Suite.Evenement demanderDEcrire(Component parent, String scene) {
        int reponse = demander(parent, "Changement non écrit",
                "Ce qui est changé dans « " + scene + " » n'y est pas écrit.", "Écrire", "Oublier", "Rester");
        if (reponse == 0) {
            return Suite::accepterDEcrire;
        }
        return reponse == 1 ? Suite::oublier : Suite::rester;
    }

    /** Le rang de la réponse choisie, la dernière étant proposée ; négatif si le dialogue est fermé. */
    private static int demander(Component parent, String titre, Object question, String... reponses) {
        int reponse = JOptionPane.showOptionDialog(parent, question, titre, JOptionPane.DEFAULT_OPTION,
                JOptionPane.WARNING_MESSAGE, null, reponses, reponses[reponses.length - 1]);
        parent.requestFocus();
        return reponse;
    }
}
