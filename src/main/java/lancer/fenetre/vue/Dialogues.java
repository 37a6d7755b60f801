package lancer.fenetre.vue;

import java.awt.Dialog;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.image.BufferedImage;
import java.io.File;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import lancer.fenetre.etat.Dialogue;
import lancer.fenetre.etat.Suite;
import lancer.image.ImageMemoire;
import lancer.texte.Texte;

/** Les dialogues, en français quelle que soit la langue de Java, et le presse-papiers. */
final class Dialogues implements Dialogue {

    /** Ce qu'un dialogue ajoute à la table des touches : une barre, son cadre, un bouton. */
    private static final int MARGE_H = 30;
    private static final int MARGE_V = 120;
    private static final int LARGEUR = 500;

    private final JComponent image;
    private final Consumer<Suite.Evenement> recevoir;
    /** Le dossier que propose le prochain dialogue d'une image. */
    private File dossier = new File("").getAbsoluteFile();

    /** @param image celle à qui chaque dialogue rend le clavier */
    Dialogues(JComponent image, Consumer<Suite.Evenement> recevoir) {
        this.image = image;
        this.recevoir = recevoir;
    }

    static Rectangle ecran() {
        return GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
    }

    /** Le dossier de cette scène ou, à défaut, celui des scènes du programme. */
    static File dossierDesScenes(String actuelle) {
        return actuelle != null ? new File(actuelle).getAbsoluteFile().getParentFile()
                // depuis la racine, ou depuis le dossier d'une variante
                : Stream.of("scenes", "../scenes").map(nom -> new File(nom).getAbsoluteFile())
                .filter(File::isDirectory).findFirst().orElse(new File("").getAbsoluteFile());
    }

    /** Le tableau des touches. @param lignes touche, puis effet, en lignes d'un tableau HTML */
    void direTouches(String lignes) {
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
        JOptionPane.showMessageDialog(image, deroulant, "Touches", JOptionPane.PLAIN_MESSAGE);
    }

    @Override
    public void choisirUneScene(String actuelle) {
        File choisie = choisir(new JFileChooser(dossierDesScenes(actuelle)), "Ouvrir une scène", "ini");
        if (choisie != null) {
            recevoir.accept(suite -> suite.ouvrir(choisie.getPath()));
        }
    }

    @Override
    public void demanderDEcrire(String scene) {
        int reponse = demander("Changement non écrit", "Ce qui est changé dans « " + scene + " » n'y est pas écrit.",
                "Écrire", "Oublier", "Rester");
        Suite.Evenement sansEcrire = reponse == 1 ? Suite::oublier : Suite::rester;
        recevoir.accept(reponse == 0 ? Suite::accepterDEcrire : sansEcrire);
    }

    @Override
    public void proposerEcrireSous(String pourquoi, String fichier) {
        boolean voulu = pourquoi == null || demander("Scène non écrite", new Etiquette("pourquoi").dire(pourquoi),
                "Écrire sous…", "Rester") == 0;
        File cible = voulu ? choisirOuEcrire(new File(fichier).getAbsoluteFile(), "Écrire la scène sous…", "ini")
                : null;
        recevoir.accept(cible == null ? Suite::rester : suite -> suite.ecrireSous(cible.getPath()));
    }

    @Override
    public void demanderOuEnregistrer(ImageMemoire celle, String scene) {
        String png = new File(scene).getName().replaceFirst("\\.[^.]*$", "") + ".png";
        File cible = choisirOuEcrire(new File(dossier, png), "Enregistrer l'image", "png");
        if (cible != null) {
            dossier = cible.getParentFile();
            recevoir.accept(suite -> suite.enregistrerSous(celle, cible, scene));
        }
    }

    /** Le fichier où écrire, remplacement confirmé, ou {@code null}. @param fin celle de son nom, sans point */
    private File choisirOuEcrire(File propose, String titre, String fin) {
        JFileChooser choix = new JFileChooser(propose.getParentFile());
        choix.setDialogType(JFileChooser.SAVE_DIALOG);
        choix.setSelectedFile(propose);
        File cible = choisir(choix, titre, fin);
        boolean libre = cible == null || !cible.isFile() || demander(titre, "Le fichier « "
                + Texte.echappe(cible.getName()) + " » existe déjà. Le remplacer ?", "Remplacer", "Annuler") == 0;
        return libre ? cible : null;
    }

    private File choisir(JFileChooser choix, String titre, String fin) {
        if (Stream.of(Window.getWindows()).anyMatch(autre -> autre instanceof Dialog && autre.isVisible())) {
            // une touche répétée n'en ouvre pas un deuxième
            return null;
        }
        choix.setDialogTitle(titre);
        choix.setFileFilter(new FileNameExtensionFilter("*." + fin, fin));
        int reponse = choix.showDialog(image, null);
        // certains bureaux ne rendent pas le clavier à la fenêtre après un dialogue
        image.requestFocus();
        File choisi = reponse == JFileChooser.APPROVE_OPTION ? choix.getSelectedFile() : null;
        boolean complet = choisi == null || Texte.minuscules(choisi.getName()).endsWith("." + fin)
                || choix.getDialogType() == JFileChooser.OPEN_DIALOG && choisi.exists();
        return complet ? choisi : new File(choisi.getPath() + "." + fin);
    }

    /** Le rang de la réponse choisie, la dernière étant proposée ; négatif si le dialogue est fermé. */
    private int demander(String titre, Object question, String... reponses) {
        int reponse = JOptionPane.showOptionDialog(image, question, titre, JOptionPane.DEFAULT_OPTION,
                JOptionPane.WARNING_MESSAGE, null, reponses, reponses[reponses.length - 1]);
        image.requestFocus();
        return reponse;
    }

    @Override
    public void copier(String texte) {
        image.getToolkit().getSystemClipboard().setContents(new StringSelection(texte), null);
    }

    @Override
    public void copier(ImageMemoire celle) {
        // l'image partage le tableau des codes, qui ne change plus : copier une grande image serait long
        BufferedImage copie = PanneauImage.deJava(celle, celle.codes, false);
        image.getToolkit().getSystemClipboard().setContents(new Transferable() {
            @Override
            public DataFlavor[] getTransferDataFlavors() {
                return new DataFlavor[] {DataFlavor.imageFlavor};
            }

            @Override
            public boolean isDataFlavorSupported(DataFlavor sorte) {
                return sorte.equals(DataFlavor.imageFlavor);
            }

            @Override
            public Object getTransferData(DataFlavor sorte) {
                return copie;
            }
        }, null);
    }

    @Override
    public void fermer() {
        SwingUtilities.getWindowAncestor(image).dispose();
    }
}
