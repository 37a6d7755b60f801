package lancer.fenetre;

import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.InputMap;
import javax.swing.JColorChooser;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JScrollPane;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.filechooser.FileFilter;
import javax.swing.filechooser.FileNameExtensionFilter;
import lancer.texte.Texte;

/** Les dialogues, en français même là où Java ne l'est pas, les fenêtres d'à côté, et l'apparence du système. */
final class Dialogues {

    private static final String TITRE_IMAGE = "Enregistrer l'image";

    /** Place qu'un dialogue laisse, sur un petit écran, à son propre cadre. */
    private static final int BORDS = 40;

    /** Vrai tant qu'un choix de fichier est à l'écran : une touche qui se répète en ouvrirait un autre par-dessus. */
    private static boolean ouvert;

    private Dialogues() {
    }

    /** Pose l'apparence et la langue ; à appeler avant de créer le premier composant. */
    static void preparer() {
        // l'apparence de secours, Metal, mettrait tout en gras, et l'avancement en blanc sur bleu pâle
        UIManager.put("swing.boldMetal", false);
        UIManager.put("MenuItem.acceleratorDelimiter", "+");
        UIManager.put("ProgressBar.selectionForeground", Color.BLACK);
        UIManager.put("ProgressBar.selectionBackground", Color.BLACK);
        try {
            UIManager.setLookAndFeel(UIManager.getSystemLookAndFeelClassName());
        } catch (ReflectiveOperationException | UnsupportedLookAndFeelException | LinkageError e) {
            // celle de Java, déjà en place
        }
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

    /** Le tableau des touches, qui reste ouvert à côté pendant qu'on les essaie. */
    static Window touches(JFrame cadre) {
        int largeur = Math.min(540, ecran().width - BORDS);
        JLabel table = new JLabel("<html><table width=" + largeur + ">" + Arrays.stream(lire("touches.txt"))
                .map(ligne -> "<tr><td>" + ligne[0] + "<td>" + ligne[1]).collect(Collectors.joining()));
        table.setName("table");
        JDialog touches = new JDialog(cadre, "Touches");
        JScrollPane ascenseur = new JScrollPane(table);
        touches.add(ascenseur);
        touches.pack();
        if (touches.getHeight() > ecran().height) {
            int barre = ascenseur.getVerticalScrollBar().getPreferredSize().width;
            touches.setSize(touches.getWidth() + barre, touches.getHeight());
            InputMap defilement = ascenseur.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW);
            defilement.put(Menus.touche(KeyEvent.VK_PAGE_DOWN), "scrollDown");
            defilement.put(Menus.touche(KeyEvent.VK_PAGE_UP), "scrollUp");
        }
        return touches;
    }

    /** Action qui fait cette fenêtre, une seule fois, et la montre à côté. */
    static Runnable aLaDemande(Supplier<Window> fenetre) {
        Window[] faite = new Window[1];
        return () -> {
            faite[0] = faite[0] == null ? fenetre.get() : faite[0];
            aCote(faite[0]);
        };
    }

    /** Montre cette fenêtre à côté de celle dont elle dépend, qui laisse la place qu'elle peut, et des autres. */
    static void aCote(Window fenetre) {
        if (!fenetre.isVisible()) {
            Window cadre = fenetre.getOwner();
            Rectangle ecran = ecran();
            fenetre.setSize(Math.min(fenetre.getWidth(), ecran.width), Math.min(fenetre.getHeight(), ecran.height));
            int depasse = cadre.getX() + cadre.getWidth() + fenetre.getWidth() - ecran.x - ecran.width;
            if (depasse > 0 && cadre.getX() > ecran.x) {
                cadre.setLocation(Math.max(ecran.x, cadre.getX() - depasse), cadre.getY());
            }
            List<Rectangle> prises = Arrays.stream(cadre.getOwnedWindows()).filter(Window::isVisible)
                    .map(Window::getBounds).collect(Collectors.toList());
            fenetre.setLocation(place(fenetre.getSize(), ecran, cadre.getBounds(), prises));
        }
        fenetre.setVisible(true);
    }

    /** La place d'une fenêtre dans l'écran : où elle cache le moins les autres, puis le cadre ; plutôt à droite. */
    static Point place(Dimension taille, Rectangle ecran, Rectangle cadre, List<Rectangle> prises) {
        List<Integer> xs = new ArrayList<>(Arrays.asList(cadre.x + cadre.width, ecran.x + ecran.width - taille.width,
                ecran.x));
        List<Integer> ys = new ArrayList<>(Arrays.asList(cadre.y, ecran.y, ecran.y + ecran.height - taille.height));
        for (Rectangle prise : prises) {
            xs.addAll(Arrays.asList(prise.x, prise.x - taille.width, prise.x + prise.width));
            ys.addAll(Arrays.asList(prise.y + prise.height, prise.y - taille.height));
        }
        return xs.stream().flatMap(x -> ys.stream().map(y -> new Rectangle(new Point(x, y), taille)))
                .filter(ecran::contains).min(Comparator.comparingDouble(place -> cache(place, cadre)
                + (double) ecran.width * ecran.height * prises.stream().mapToDouble(p -> cache(place, p)).sum()))
                .map(Rectangle::getLocation).orElse(ecran.getLocation());
    }

    private static double cache(Rectangle place, Rectangle autre) {
        Rectangle commun = place.intersection(autre);
        return commun.isEmpty() ? 0 : (double) commun.width * commun.height;
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

    /** Demande une couleur, {@code null} pour garder celle-ci ; par ses trois composantes, comme dans la scène. */
    static Color choisirCouleur(Component parent, Color actuelle) {
        traduire();
        JColorChooser choix = new JColorChooser(actuelle);
        Arrays.stream(choix.getChooserPanels()).filter(panneau -> choix.getChooserPanels().length > 1
                && !panneau.getDisplayName().matches("R[GV]B")).forEach(choix::removeChooserPanel);
        Color[] choisie = new Color[1];
        JColorChooser.createDialog(parent, "Couleur", true, choix, e -> choisie[0] = choix.getColor(), null)
                .setVisible(true);
        return choisie[0];
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
