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
        super(new BorderLayout(MARGE, MARGE / 2));
        setBorder(BorderFactory.createEmptyBorder(0, MARGE, MARGE / 2, MARGE));
        pixel.setName("pixel");
        resume.setRows(2);
        avancement.setName("avancement");
        avancement.getAccessibleContext().setAccessibleName("avancement du dessin");
        avancement.setBorderPainted(false);
        avancement.setPreferredSize(new Dimension(FILET, FILET));
        add(avancement, BorderLayout.PAGE_START);
        add(pastille, BorderLayout.LINE_START);
        add(pixel, BorderLayout.CENTER);
        add(resume, BorderLayout.PAGE_END);
        // sa taille ne change pas : l'image ne bouge pas quand un texte est long
        setPreferredSize(getPreferredSize());
    }

    /**
     * Dit l'avancement du travail ou, s'il est achevé, ce qu'est l'image ; et le pixel sous la souris.
     *
     * @param geste dit à la place de l'image, ou {@code null}
     */
    void montrer(Etat etat, PanneauImage panneau, String geste) {
        boolean tenue = panneau.tenue != null;
        String texte = etat.travail == null ? "" : etat.travail.getTexte();
        avancement.setValue(etat.enCours ? (int) (POUR_MILLE * etat.travail.getAvancement()) : 0);
        avancement.getAccessibleContext().setAccessibleDescription(texte);
        if (tenue) {
            texte = "avant : " + resumer(etat.montre.avant, panneau.getReduction());
        } else if (etat.montre.entier && !etat.enCours) {
            texte = resumer(etat.montre.dessin, panneau.getReduction());
        }
        panneau.getAccessibleContext().setAccessibleDescription(texte);
        resume.setText(geste == null ? texte : geste);
        montrerPixel(panneau.getPixelSouris(), panneau.getVisible(), !tenue && !etat.montre.entier);
    }

    /** La taille de l'image, son coût, ses réglages, ses fautes. @param reduction rapport à sa taille réelle */
    private static String resumer(Dessin dessin, double reduction) {
        ImageMemoire image = dessin.image;
        String texte = (image.echelle.isEmpty() ? "" : image.echelle + " ; ") + image.largeur + " × " + image.hauteur
                + " pixels";
        if (reduction < 1) {
            texte += " montrés à " + (int) (100 * reduction) + " %";
        } else if (reduction > 1) {
            texte += " à la loupe × " + Math.round(reduction);
        }
        String fautes = dessin.lancer.getAtelier().getFautes().enMots();
        return texte + ", " + dessin.getCout() + ", " + dessin.demande.reglages + (fautes == null ? "" : ", " + fautes);
    }

    /** @param ou le pixel sous la souris, ou {@code null} @param brouillon vrai si sa couleur n'est pas définitive */
    private void montrerPixel(Point ou, ImageMemoire image, boolean brouillon) {
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
