package lancer.fenetre;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Point;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JTextArea;
import lancer.dessin.Dessin;
import lancer.image.ImageMemoire;

/** Le bas de la fenêtre : l'avancement du dessin, le pixel sous la souris, un résumé de l'image. */
@SuppressWarnings("serial")
final class BarreEtat extends JPanel {

    private static final int MARGE = 6;
    private static final int FILET = 3;
    private static final int POUR_MILLE = 1000;

    /** Le plus long texte possible, qui fixe la largeur de la barre. */
    private final JLabel pixel = new JLabel("pixel 9999, 9999 : #FFFFFF = 255 255 255 ← 0.000 0.000 0.000");
    /** Deux lignes : la légende d'une vue est longue, et un écran parfois étroit. */
    private final JTextArea resume = Bandeau.etiquette("resume");
    private final JProgressBar avancement = new JProgressBar(0, POUR_MILLE);
    private final JLabel pastille = new JLabel("    ");

    BarreEtat() {
        super(new BorderLayout(MARGE, 0));
        pixel.setName("pixel");
        resume.setRows(2);
        avancement.setName("avancement");
        avancement.getAccessibleContext().setAccessibleName("avancement du dessin");
        avancement.setBorderPainted(false);
        avancement.setPreferredSize(new Dimension(FILET, FILET));
        JPanel textes = new JPanel(new BorderLayout(MARGE, 0));
        textes.setBorder(BorderFactory.createEmptyBorder(MARGE / 2, MARGE, MARGE / 2, MARGE));
        textes.add(pastille, BorderLayout.LINE_START);
        textes.add(pixel, BorderLayout.CENTER);
        textes.add(resume, BorderLayout.PAGE_END);
        add(avancement, BorderLayout.PAGE_START);
        add(textes, BorderLayout.CENTER);
        // sa taille ne change pas : l'image ne bouge pas quand un texte est long
        setPreferredSize(getPreferredSize());
        pixel.setText(" ");
    }

    /** @param part la part faite du travail en cours, de 0 à 1 @param texte ce travail, vide s'il n'y en a pas */
    void avancer(double part, String texte) {
        avancement.setValue((int) (POUR_MILLE * part));
        avancement.getAccessibleContext().setAccessibleDescription(texte);
    }

    void resumer(String texte) {
        if (!texte.equals(resume.getText())) {
            resume.setText(texte);
        }
    }

    /** La taille de l'image, son coût, ses réglages, ses fautes. @param reduction rapport à sa taille réelle */
    static String resume(Dessin dessin, double reduction) {
        String fautes = dessin.lancer.getAtelier().getFautes().enMots();
        return resume(dessin.image, reduction) + ", " + dessin.getCout() + ", " + dessin.demande.reglages
                + (fautes == null ? "" : ", " + fautes);
    }

    private static String resume(ImageMemoire image, double reduction) {
        String taille = (image.echelle.isEmpty() ? "" : image.echelle + " ; ") + image.largeur + " × " + image.hauteur
                + " pixels";
        if (reduction < 1) {
            return taille + " montrés à " + (int) (100 * reduction) + " %";
        }
        return reduction > 1 ? taille + " à la loupe × " + Math.round(reduction) : taille;
    }

    /** @param ou le pixel sous la souris, ou {@code null} @param brouillon vrai si sa couleur n'est pas définitive */
    void montrerPixel(Point ou, ImageMemoire image, boolean brouillon) {
        pastille.setOpaque(ou != null);
        pixel.setText("");
        if (ou != null) {
            int k = ou.y * image.largeur + ou.x;
            Color c = new Color(image.codes[k]);
            pastille.setBackground(c);
            pixel.setText(String.format("pixel %d, %d%s : #%06X = %d %d %d %s", ou.x, ou.y,
                    brouillon ? " (brouillon)" : "", c.getRGB() & 0xFFFFFF, c.getRed(), c.getGreen(), c.getBlue(),
                    image.dire(k)));
        }
        pastille.repaint();
    }
}
