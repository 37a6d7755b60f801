package lancer.fenetre.vue;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.Collections;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Pixel;
import lancer.image.ImageMemoire;
import lancer.image.ImageMemoire.Teinte;

/** Le bas de la fenêtre : l'avancement, le pixel sous la souris, la légende d'une vue, un résumé de l'image. */
@SuppressWarnings("serial")
final class BarreEtat extends JPanel implements Vue {

    private static final int MARGE = 6;
    private static final int FILET = 3;
    private static final int POUR_MILLE = 1000;
    private static final int LIGNES_MAX = 4;
    /** Le plus long texte d'un pixel, qui fixe la largeur de la barre. */
    private static final String PIXEL = "pixel 9999, 9999 : #FFFFFF = 255 255 255 ← 0.000 0.000 0.000";
    /** Un long résumé, à ses réglages près. */
    private static final String RESUME = "9999 × 9999 pixels, 99 999 999 rayons en 99,99 s, ";

    private final Etat premier;
    private final Supplier<Pixel> souris;
    private final JLabel pixel = new JLabel(" ");
    private final Etiquette resume = new Etiquette("resume");
    private final JProgressBar avancement = new JProgressBar(0, POUR_MILLE);
    private final JLabel pastille = new JLabel("    ");
    private final JPanel legende = new JPanel(new FlowLayout(FlowLayout.TRAILING, 0, 0));
    private List<Teinte> teintes = Collections.emptyList();

    /**
     * @param premier le premier état : son image donne sa largeur à la barre, ses réglages leur longueur au résumé
     * @param souris le pixel sous la souris, ou {@code null}
     */
    BarreEtat(Etat premier, Supplier<Pixel> souris) {
        super(new BorderLayout(0, MARGE / 2));
        this.premier = premier;
        this.souris = souris;
        setBorder(BorderFactory.createEmptyBorder(0, MARGE, MARGE / 2, MARGE));
        pixel.setName("pixel");
        legende.setName("legende");
        avancement.setName("avancement");
        avancement.getAccessibleContext().setAccessibleName("avancement du dessin");
        avancement.setBorderPainted(false);
        avancement.setPreferredSize(new Dimension(FILET, FILET));
        // le pixel a sa ligne, quelle que soit la longueur du résumé
        JPanel haut = new JPanel(new BorderLayout(0, MARGE / 2));
        haut.add(avancement, BorderLayout.PAGE_START);
        haut.add(pixel, BorderLayout.LINE_START);
        haut.add(legende, BorderLayout.CENTER);
        haut.add(pastille, BorderLayout.LINE_END);
        add(haut, BorderLayout.PAGE_START);
        add(resume, BorderLayout.CENTER);
    }

    private int largeur(String texte) {
        return getFontMetrics(resume.getFont()).stringWidth(texte);
    }

    /** La place de la barre. À une taille des textes, sa hauteur ne change pas : l'image ne bouge pas. */
    @Override
    public Dimension getPreferredSize() {
        int longueur = largeur(RESUME + (premier.aUneScene() ? premier.demande.reglages : ""));
        int large = Math.min(Math.max(largeur(PIXEL), premier.ecran.loupe.largeur), Dialogues.ecran().width);
        resume.setRows(Math.min(LIGNES_MAX, 1 + longueur / (large - 2 * MARGE)));
        int ligne = getFontMetrics(resume.getFont()).getHeight();
        return new Dimension(largeur(PIXEL) + pastille.getPreferredSize().width + 3 * MARGE,
                super.getPreferredSize().height - resume.getPreferredSize().height + resume.getRows() * ligne);
    }

    /** Dit où en est le travail ou, s'il est achevé, ce qu'est l'image ; et ce qui est sous la souris. */
    @Override
    public void montrer(Etat etat) {
        String texte = etat.getResume();
        avancement.setValue(etat.enCours() ? (int) (POUR_MILLE * etat.travail.getAvancement()) : 0);
        avancement.getAccessibleContext().setAccessibleDescription(texte);
        resume.setText(texte);
        resume.setToolTipText(texte);
        if (etat.getVisible() != null && etat.getVisible().image.teintes != teintes) {
            montrerLaLegende(etat.getVisible().image);
        }
        Pixel ou = souris.get();
        ImageMemoire image = ou == null ? null : etat.getVisible().image;
        int k = ou == null ? 0 : ou.y * image.largeur + ou.x;
        // 0 sans pixel, ou s'il n'est pas encore dessiné
        int code = ou == null ? 0 : image.codes[k];
        Color c = new Color(code);
        pastille.setOpaque(code != 0);
        pastille.setBackground(c);
        pastille.repaint();
        pixel.setText(code == 0 ? " " : String.format("pixel %d, %d%s : #%06X = %d %d %d %s", ou.x, ou.y,
                etat.estUnBrouillon() ? " (brouillon)" : "", code & 0xFFFFFF, c.getRed(), c.getGreen(), c.getBlue(),
                etat.direLePixel(k)));
    }

    private void montrerLaLegende(ImageMemoire image) {
        teintes = image.teintes;
        legende.removeAll();
        teintes.forEach(teinte -> {
            JLabel mot = new JLabel(" " + teinte.mot + " ");
            mot.setOpaque(true);
            mot.setBackground(new Color(teinte.couleur.getCode()));
            boolean claire = 0.3 * teinte.couleur.r + 0.6 * teinte.couleur.v + 0.1 * teinte.couleur.b > 0.5;
            mot.setForeground(claire ? Color.BLACK : Color.WHITE);
            legende.add(mot);
        });
        legende.setToolTipText(image.echelle);
        legende.getAccessibleContext().setAccessibleDescription(image.echelle);
        legende.revalidate();
        legende.repaint();
    }
}
