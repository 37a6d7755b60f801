package lancer.fenetre;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.DataBufferInt;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import javax.swing.JPanel;
import lancer.sortie.ImageMemoire;

/** L'image, un de ses pixels sur chaque pixel de l'écran, sur un gris neutre qui ne fausse pas les couleurs. */
final class PanneauImage extends JPanel {

    private static final long serialVersionUID = 1;

    private static final Color GRIS = new Color(0x777777);
    private static final DirectColorModel OPAQUE = new DirectColorModel(24, 0xFF0000, 0xFF00, 0xFF);

    private final Bandeau bandeau = new Bandeau();
    /** L'image montrée, et celle qui se dessine par-dessus tant que son brouillon n'est pas complet. */
    private transient ImageMemoire montree;
    private transient BufferedImage fond;
    private transient ImageMemoire naissante;
    private transient BufferedImage calque;
    private String invite;
    private Point souris;

    PanneauImage() {
        setName("image");
        setBackground(GRIS);
        add(bandeau);
    }

    Bandeau getBandeau() {
        return bandeau;
    }

    /** Ce qu'on lit tant qu'il n'y a pas d'image ; {@code null} pour rien. */
    void setInvite(String invite) {
        this.invite = invite;
        repaint();
    }

    /** L'image montrée, {@code null} avant la première. */
    ImageMemoire getImage() {
        return montree;
    }

    /** La taille du panneau, en pixels de l'écran ; un écran dense en a plusieurs par point. */
    Dimension getTaillePixels() {
        AffineTransform echelle = echelle();
        return new Dimension((int) Math.round(getWidth() * echelle.getScaleX()),
                (int) Math.round(getHeight() * echelle.getScaleY()));
    }

    private AffineTransform echelle() {
        return getGraphicsConfiguration() == null ? new AffineTransform()
                : getGraphicsConfiguration().getDefaultTransform();
    }

    /**
     * Montre l'image telle qu'elle est maintenant.
     *
     * @param entiere vrai si chacun de ses pixels a une couleur : elle remplace alors la précédente
     * @param parMorceaux sinon, vrai pour en montrer déjà ce qui est dessiné
     */
    void montrer(ImageMemoire image, boolean entiere, boolean parMorceaux) {
        if (entiere && image != montree) {
            montree = image;
            fond = surCodes(image, OPAQUE);
        }
        if (entiere || fond != null && !parMorceaux) {
            naissante = null;
            calque = null;
        } else if (image != naissante) {
            if (fond == null) {
                // pas encore de brouillon complet : ce qu'on en voit vaut mieux que du gris
                montree = naissante;
                fond = calque;
            }
            naissante = image;
            calque = surCodes(image, (DirectColorModel) ColorModel.getRGBdefault());
        }
        repaint();
    }

    /** Une image AWT sur le tableau même des codes : rien n'est copié. */
    private static BufferedImage surCodes(ImageMemoire image, DirectColorModel couleurs) {
        int[] codes = image.getCodes();
        WritableRaster raster = Raster.createPackedRaster(new DataBufferInt(codes, codes.length),
                image.getLargeur(), image.getHauteur(), image.getLargeur(), couleurs.getMasks(), null);
        return new BufferedImage(couleurs, raster, false, null);
    }

    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        Graphics2D g2 = (Graphics2D) g.create();
        try {
            // défait l'agrandissement d'un écran dense : l'image a déjà ses pixels
            AffineTransform t = g2.getTransform();
            g2.setTransform(AffineTransform.getTranslateInstance(Math.round(t.getTranslateX()),
                    Math.round(t.getTranslateY())));
            peindre(g2, fond);
            peindre(g2, calque);
        } finally {
            g2.dispose();
        }
        if (invite != null && fond == null) {
            g.setColor(Color.WHITE);
            FontMetrics m = g.getFontMetrics();
            g.drawString(invite, Math.max(0, (getWidth() - m.stringWidth(invite)) / 2), getHeight() / 2);
        }
    }

    private void peindre(Graphics2D g, BufferedImage image) {
        if (image == null) {
            return;
        }
        Dimension taille = getTaillePixels();
        if (image.getWidth() == taille.width && image.getHeight() == taille.height) {
            g.drawImage(image, 0, 0, null);
        } else {
            // le temps que la nouvelle taille se dessine
            g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
            g.drawImage(image, 0, 0, taille.width, taille.height, null);
        }
    }

    /** Le bandeau recouvre le bas de l'image, sans la pousser : un message ne doit pas la faire redessiner. */
    @Override
    public void doLayout() {
        bandeau.setSize(getWidth(), Short.MAX_VALUE);
        int hauteur = bandeau.getPreferredSize().height;
        bandeau.setBounds(0, getHeight() - hauteur, getWidth(), hauteur);
    }

    void suivreSouris(Runnable siBouge) {
        MouseAdapter suiveur = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                souris = e.getPoint();
                siBouge.run();
            }

            @Override
            public void mouseDragged(MouseEvent e) {
                mouseMoved(e);
            }

            @Override
            public void mouseExited(MouseEvent e) {
                souris = null;
                siBouge.run();
            }
        };
        addMouseListener(suiveur);
        addMouseMotionListener(suiveur);
    }

    /** Le pixel de l'image montrée qui est sous la souris, {@code null} s'il n'y en a pas. */
    Point getPixelSouris() {
        Dimension taille = getTaillePixels();
        if (souris == null || montree == null || taille.width < 1 || taille.height < 1) {
            return null;
        }
        AffineTransform echelle = echelle();
        int x = (int) (souris.x * echelle.getScaleX() * montree.getLargeur() / taille.width);
        int y = (int) (souris.y * echelle.getScaleY() * montree.getHauteur() / taille.height);
        boolean dedans = x >= 0 && x < montree.getLargeur() && y >= 0 && y < montree.getHauteur();
        return dedans ? new Point(x, y) : null;
    }
}
