package lancer.fenetre.vue;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Polygon;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import lancer.Lampe;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Loupe;
import lancer.fenetre.etat.Onglet;
import lancer.fenetre.etat.Pixel;
import lancer.fenetre.etat.Prise;
import lancer.fenetre.etat.Suite;
import lancer.fenetre.vue.figures.Figure;
import lancer.image.ImageMemoire;

/**
 * L'image sur un gris neutre, un de ses pixels par pixel de l'écran. Si la place manque, elle est réduite dans ses
 * proportions. Un écran dense a plusieurs pixels par point : AWT compte en points, et l'état en pixels de l'écran.
 */
@SuppressWarnings("serial")
final class PanneauImage extends JPanel implements Vue {

    /** La propriété qui change quand la souris bouge. */
    static final String SOURIS = "souris";

    private static final Color GRIS = new Color(0x777777);
    /** Le plus grand écart, en points, entre le début et la fin d'un clic. */
    private static final int TREMBLEMENT = 4;
    private static final int RAYON_ETOILE = 9;
    private static final Shape ETOILE = new Polygon(new int[] {0, 2, 9, 2, 0, -2, -9, -2},
            new int[] {-9, -2, 0, 2, 9, 2, 0, -2}, 8);

    private final Bandeau bandeau;
    private final Consumer<Suite.Evenement> recevoir;
    private Etat etat;
    /** Ce que la souris a fait en dernier dans le panneau, {@code null} si elle en est sortie. */
    private MouseEvent souris;
    /** Où son bouton a été enfoncé. */
    private Point appui = new Point();

    PanneauImage(Etat etat, Consumer<Suite.Evenement> recevoir) {
        this.etat = etat;
        this.recevoir = recevoir;
        bandeau = new Bandeau(recevoir);
        setName("image");
        setBackground(GRIS);
        setFocusable(true);
        getAccessibleContext().setAccessibleName("image");
        add(bandeau);
        Suiveur suiveur = new Suiveur();
        addMouseListener(suiveur);
        addMouseMotionListener(suiveur);
        addMouseWheelListener(suiveur);
    }

    /** Dit ce que fait la souris. La molette règle la loupe ; un bouton tenu tire l'image ou, avec Maj, une boule. */
    private final class Suiveur extends MouseAdapter {

        private void placer(MouseEvent e) {
            boolean etoiles = montreLesEtoiles();
            MouseEvent avant = souris;
            souris = e;
            if (etoiles != montreLesEtoiles()) {
                repaint();
            }
            firePropertyChange(SOURIS, avant, e);
        }

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            placer(e);
            appui = e.getPoint();
            if (getImage() != null && SwingUtilities.isLeftMouseButton(e) && e.isShiftDown()) {
                lancer.Point point = pointSous(e);
                double portee = RAYON_ETOILE / getPixel() / getLoupe().getReduction(getImage());
                recevoir.accept(suite -> suite.saisir(point.x, point.y, portee));
            }
        }

        /** Un clic. AWT n'en signale pas si la souris bouge d'un seul pixel pendant l'appui. */
        @Override
        public void mouseReleased(MouseEvent e) {
            placer(e);
            if (SwingUtilities.isLeftMouseButton(e) && etat.geste != null) {
                recevoir.accept(Suite::lacher);
            } else if (SwingUtilities.isLeftMouseButton(e) && e.getPoint().distance(appui) <= TREMBLEMENT
                    && !e.isShiftDown() && e.getClickCount() <= 1 && getPixelSouris() != null) {
                // le premier clic a pu réduire l'image : le second désignerait un autre pixel
                expliquer();
            }
        }

        @Override
        public void mouseMoved(MouseEvent e) {
            placer(e);
        }

        @Override
        public void mouseExited(MouseEvent e) {
            placer(null);
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            if (etat.geste != null) {
                lancer.Point point = pointSous(e);
                recevoir.accept(suite -> suite.tirer(point.x, point.y));
            } else if (getImage() != null && souris != null && !e.isShiftDown()) {
                lancer.Point point = pointSous(souris);
                recevoir.accept(suite -> suite.amener(point, enPixels(e.getX()), enPixels(e.getY())));
            }
            placer(e);
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            placer(e);
            if (e.getWheelRotation() != 0) {
                recevoir.accept(suite -> suite.grossir(e.getWheelRotation() < 0, enPixels(e.getX()),
                        enPixels(e.getY())));
            }
        }
    }

    @Override
    public void montrer(Etat nouveau) {
        etat = nouveau;
        bandeau.montrer(nouveau);
        getAccessibleContext().setAccessibleDescription(nouveau.getResume());
        repaint();
    }

    private ImageMemoire getImage() {
        return etat.getVisible() == null ? null : etat.getVisible().image;
    }

    /** Le côté d'un pixel de l'écran, en points. */
    private double getPixel() {
        return 1 / getGraphicsConfiguration().getDefaultTransform().getScaleX();
    }

    /** Le milieu du pixel de l'écran qui est à cette abscisse, ou à cette ordonnée. */
    private double enPixels(int points) {
        return points / getPixel() + 0.5;
    }

    /** La loupe, à la place que l'image a ici : l'état l'apprend un instant plus tard. */
    private Loupe getLoupe() {
        return etat.ecran.loupe.dans((int) Math.max(1, Math.round(getWidth() / getPixel())),
                (int) Math.max(1, Math.round(getHeight() / getPixel())));
    }

    /** Le point de l'image où la souris a fait cela. */
    private lancer.Point pointSous(MouseEvent e) {
        return getLoupe().pointDe(getImage(), enPixels(e.getX()), enPixels(e.getY()));
    }

    private boolean montreLesEtoiles() {
        return souris != null && souris.isShiftDown();
    }

    /** Le pixel de l'image sous la souris ; {@code null} s'il n'y en a pas. */
    Pixel getPixelSouris() {
        if (getImage() == null || souris == null) {
            return null;
        }
        double x = enPixels(souris.getX());
        double y = enPixels(souris.getY());
        return getLoupe().contient(getImage(), x, y) ? getLoupe().pixelDe(getImage(), x, y) : null;
    }

    /** Montre les rayons du pixel sous la souris ou, à défaut, au milieu. */
    void expliquer() {
        if (getImage() != null) {
            Loupe loupe = getLoupe();
            Pixel milieu = loupe.pixelDe(getImage(), loupe.largeur / 2.0, loupe.hauteur / 2.0);
            Pixel vise = getPixelSouris() == null ? milieu : getPixelSouris();
            recevoir.accept(suite -> suite.expliquer(vise));
        }
    }

    /** Une image de Java qui partage ce tableau de codes. @param vides vrai si un code 0 y est transparent */
    static BufferedImage deJava(ImageMemoire image, int[] codes, boolean vides) {
        DirectColorModel couleurs = vides ? new DirectColorModel(32, 0xFF0000, 0xFF00, 0xFF, 0xFF000000)
                : new DirectColorModel(24, 0xFF0000, 0xFF00, 0xFF);
        return new BufferedImage(couleurs, Raster.createPackedRaster(new DataBufferInt(codes, codes.length),
                image.largeur, image.hauteur, image.largeur, couleurs.getMasks(), null), false, null);
    }

    /** La place des points de l'image, en points de l'écran. */
    private AffineTransform getVue() {
        Loupe loupe = getLoupe();
        lancer.Point coin = loupe.getCoin(getImage());
        AffineTransform vue = AffineTransform.getScaleInstance(getPixel(), getPixel());
        vue.translate(coin.x, coin.y);
        vue.scale(loupe.getLargeurDUnPixel(getImage()), loupe.getHauteurDUnPixel(getImage()));
        return vue;
    }

    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        if (getImage() != null) {
            Graphics2D g2 = (Graphics2D) g.create();
            peindre(g2);
            if (etat.ecran.onglet == Onglet.PIXEL && !etat.montre.tenue && etat.explication.faite != null
                    && etat.explication.faite.inspection != null) {
                Figure.peindre(g2, etat.explication.faite.inspection, getVue());
            }
            if (montreLesEtoiles() && etat.montre.dessin != null) {
                etat.demande.lue.lampes.forEach(lampe -> peindreLEtoile(g2, lampe));
            }
            g2.dispose();
        }
    }

    /** Peint les pixels visibles seulement : AWT ne peut peindre une image entière très agrandie. */
    private void peindre(Graphics2D g) {
        ImageMemoire image = getImage();
        Pixel de = getLoupe().pixelDe(image, 0, 0);
        Pixel a = getLoupe().pixelDe(image, getLoupe().largeur, getLoupe().hauteur);
        AffineTransform vue = getVue();
        vue.translate(de.x, de.y);
        if (getLoupe().getReduction(image) < 1) {
            g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        }
        g.drawImage(deJava(image, image.aLEcran == null ? image.codes : image.aLEcran, true)
                .getSubimage(de.x, de.y, a.x - de.x + 1, a.y - de.y + 1), vue, null);
    }

    /** Peint l'étoile de cette lampe, si elle est devant l'œil. */
    private void peindreLEtoile(Graphics2D g, Lampe lampe) {
        lancer.Point vue = Prise.etoile(etat.montre.dessin.lancer.getCamera(), lampe);
        if (vue != null) {
            Point2D ou = getVue().transform(new Point2D.Double(vue.x, vue.y), null);
            Figure.tracer(g, AffineTransform.getTranslateInstance(ou.getX(), ou.getY())
                    .createTransformedShape(ETOILE), Figure.LAMPE);
        }
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension((int) Math.ceil(etat.ecran.loupe.largeur * getPixel()),
                (int) Math.ceil(etat.ecran.loupe.hauteur * getPixel()));
    }

    /** L'image a une place. Le bandeau en couvre le bas sans la déplacer ; s'il est trop haut, sa fin est coupée. */
    @Override
    public void doLayout() {
        Loupe placee = getLoupe();
        EventQueue.invokeLater(() -> recevoir.accept(suite -> suite.placer(placee.largeur, placee.hauteur)));
        bandeau.setSize(getWidth(), Short.MAX_VALUE);
        int hauteur = bandeau.getPreferredSize().height;
        bandeau.setBounds(0, Math.max(0, getHeight() - hauteur), getWidth(), hauteur);
    }
}
