package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Point;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JTextArea;
import lancer.image.ImageMemoire;

/** Le bas de la fenêtre : le pixel sous la souris, l'image, l'avancement, et un bouton pour arrêter ou reprendre. */
@SuppressWarnings("serial")
final class BarreEtat extends JPanel {

    private static final int MARGE = 6;
    private static final int INTERLIGNE = 4;
    private static final int POUR_MILLE = 1000;
    /** Largeur du résumé en chiffres, et ce que chaque variante y ajoute. */
    private static final int LETTRES = 60;
    private static final int LETTRES_VARIANTE = 36;

    /** Le plus long texte d'un pixel achevé fait la moindre largeur de la fenêtre. */
    private final JLabel pixel = new JLabel("pixel 9999, 9999 : #FFFFFF = 255 255 255 ← 0.000 0.000 0.000");
    private final JTextArea resume = Bandeau.etiquette("resume");
    private final JProgressBar avancement = new JProgressBar(0, POUR_MILLE);
    private final JButton bouton = new JButton("Redessiner");
    private final JLabel pastille = new JLabel("    ");
    private final int largeurMin;
    /** La largeur de la fenêtre, et la hauteur qu'il y a fallu. */
    private int largeur;
    private int hauteur;

    /** @param image sa largeur @param variantes combien le résumé peut avoir à en dire */
    BarreEtat(Runnable siPresse, int image, int variantes) {
        super(new BorderLayout(MARGE, INTERLIGNE));
        setBorder(BorderFactory.createEmptyBorder(INTERLIGNE, MARGE, INTERLIGNE, MARGE));
        pixel.setName("pixel");
        avancement.setName("avancement");
        bouton.setName("bouton");
        avancement.setStringPainted(true);
        avancement.setString("");
        // par Tab ; d'un clic, le clavier reste à l'image
        bouton.setRequestFocusEnabled(false);
        avancement.getAccessibleContext().setAccessibleName("avancement du dessin");
        bouton.addActionListener(e -> siPresse.run());
        // la largeur du plus long de ses deux textes, pour que la barre ne bouge pas
        bouton.setPreferredSize(bouton.getPreferredSize());
        JPanel textes = new JPanel(new BorderLayout(MARGE, 0));
        textes.add(resume, BorderLayout.PAGE_START);
        textes.add(pastille, BorderLayout.LINE_START);
        textes.add(pixel, BorderLayout.CENTER);
        add(textes, BorderLayout.PAGE_START);
        add(avancement, BorderLayout.CENTER);
        add(bouton, BorderLayout.LINE_END);
        largeurMin = super.getPreferredSize().width;
        pixel.setText(" ");
        resume.setRows(1 + (LETTRES + variantes * LETTRES_VARIANTE)
                * resume.getFontMetrics(resume.getFont()).charWidth('0') / Math.max(largeurMin, image));
    }

    /** Taille où se lit tout le résumé, et qui ne rapetisse qu'avec la fenêtre : l'image se redessinerait sans fin. */
    @Override
    public Dimension getPreferredSize() {
        if (getParent().getWidth() != largeur) {
            largeur = getParent().getWidth();
            hauteur = 0;
            resume.setSize(largeur - 2 * MARGE, Short.MAX_VALUE);
        }
        hauteur = Math.max(hauteur, super.getPreferredSize().height);
        return new Dimension(largeurMin, hauteur);
    }

    void avancer(Tracage tracage) {
        avancement.setValue(tracage.isAcheve() ? POUR_MILLE : (int) (POUR_MILLE * tracage.getAvancement()));
        avancement.setString(tracage.getEtat());
        bouton.setText(tracage.isDone() ? "Redessiner" : "Arrêter");
    }

    /** Résumé de l'image montrée, {@code null} si elle n'est pas achevée, et de ce qu'elle a coûté. */
    String resumer(ImageMemoire image, double reduction, String cout) {
        String reduite = reduction < 0.01 ? " montrés réduits à moins de 1 %"
                : reduction < 1 ? " montrés à " + (int) (100 * reduction) + " %"
                : reduction > 1 ? " à la loupe × " + Math.round(reduction) : "";
        resume.setText(image == null ? " " : image.largeur + " × " + image.hauteur + " pixels" + reduite + ", " + cout);
        return resume.getText();
    }

    /** @param ou le pixel sous la souris, ou {@code null} @param brouillon vrai si ce n'est peut-être pas sa couleur */
    void montrerPixel(Point ou, ImageMemoire image, boolean brouillon) {
        pastille.setOpaque(ou != null);
        pastille.repaint();
        if (ou == null) {
            pixel.setText(" ");
            return;
        }
        int k = ou.y * image.largeur + ou.x;
        int code = image.codes[k];
        pastille.setBackground(new Color(code));
        String texte = String.format("pixel %d, %d%s : #%06X = %d %d %d", ou.x, ou.y, brouillon ? " (brouillon)" : "",
                code & 0xFFFFFF, code >> 16 & 0xFF, code >> 8 & 0xFF, code & 0xFF);
        float[] lineaire = image.lineaire;
        if (lineaire != null) {
            // avec un point, comme dans les fichiers de scène
            texte += String.format(Locale.ROOT, " ← %.3f %.3f %.3f", lineaire[3 * k], lineaire[3 * k + 1],
                    lineaire[3 * k + 2]);
        }
        pixel.setText(texte);
    }
}
