package lancer.fenetre;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
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
import lancer.fenetre.figures.Figure;
import lancer.image.ImageMemoire;

/**
 * L'image sur un gris neutre, un de ses pixels par pixel de l'écran. Si la place manque, elle est réduite dans ses
 * proportions. Un écran dense a plusieurs pixels par point : les positions dans ce panneau sont en points.
 */
@SuppressWarnings("serial")
final class PanneauImage extends JPanel {

    private static final Color GRIS = new Color(0x777777);
    private static final int LOUPE_MAX = 16;
    /** Le plus grand écart, en points, entre le début et la fin d'un clic. */
    private static final int TREMBLEMENT = 4;

    final Bandeau bandeau = new Bandeau();
    /** L'image, {@code null} avant la première ; celle d'avant, tant que sa touche est tenue. */
    ImageMemoire montree;
    ImageMemoire tenue;
    /** Dessine ce qui peut être pris, par-dessus l'image. */
    Consumer<Graphics2D> prises = g -> { };
    private Figure dessus;
    private final Runnable siBouge;
    private final Runnable siClique;
    private Point2D souris;
    /** Où la souris s'est appuyée, et ce qu'elle déplace de l'image grossie, ou {@code null}. */
    private Point appui = new Point();
    private Point2D saisi;
    /** Pixel à garder en vue à la loupe, ou {@code null}. */
    private Point suivi;
    /** Grossissement de la loupe, 0 sans loupe ; avec elle, le point de l'image qui est au milieu du panneau. */
    private int loupe;
    private Point2D milieu = new Point2D.Double();

    /** @param siBouge appelé quand la souris ou la loupe bouge @param siClique appelé après un clic sur l'image */
    PanneauImage(Dimension image, Runnable siBouge, Runnable siClique) {
        this.siBouge = siBouge;
        this.siClique = siClique;
        setName("image");
        setBackground(GRIS);
        setFocusable(true);
        getAccessibleContext().setAccessibleName("image");
        add(bandeau);
        setPreferredSize(new Dimension((int) Math.ceil(image.width * getPixel()),
                (int) Math.ceil(image.height * getPixel())));
        Suiveur suiveur = new Suiveur();
        addMouseListener(suiveur);
        addMouseMotionListener(suiveur);
        addMouseWheelListener(suiveur);
    }

    /** Suit la souris. La molette règle la loupe, et un bouton tenu déplace l'image grossie. */
    private final class Suiveur extends MouseAdapter {

        private void placer(MouseEvent e) {
            // le milieu d'un pixel de l'écran, et non son bord
            souris = new Point2D.Double(e.getX() + getPixel() / 2, e.getY() + getPixel() / 2);
        }

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            placer(e);
            appui = e.getPoint();
            saisi = loupe > 0 ? pointDe(souris) : null;
        }

        /** Un clic. AWT n'en signale pas si la souris bouge d'un seul pixel pendant l'appui. */
        @Override
        public void mouseReleased(MouseEvent e) {
            placer(e);
            // le premier clic a pu réduire l'image : le second désignerait un autre pixel
            if (SwingUtilities.isLeftMouseButton(e) && e.getPoint().distance(appui) <= TREMBLEMENT
                    && !e.isShiftDown() && e.getClickCount() <= 1 && estSousLaSouris()) {
                siClique.run();
            }
        }

        @Override
        public void mouseMoved(MouseEvent e) {
            placer(e);
            siBouge.run();
        }

        @Override
        public void mouseExited(MouseEvent e) {
            souris = null;
            siBouge.run();
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            placer(e);
            if (saisi != null && !e.isShiftDown()) {
                amener(saisi, souris);
            }
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            placer(e);
            if (e.getWheelRotation() != 0) {
                grossir(e.getWheelRotation() < 0, souris);
            }
        }
    }

    ImageMemoire getVisible() {
        return tenue != null ? tenue : montree;
    }

    /** Le côté d'un pixel de l'écran, en points. */
    private double getPixel() {
        GraphicsConfiguration ecran = getGraphicsConfiguration();
        return 1 / (ecran != null ? ecran : GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice()
                .getDefaultConfiguration()).getDefaultTransform().getScaleX();
    }

    private Point2D getCentre() {
        return new Point2D.Double(getWidth() / 2.0, getHeight() / 2.0);
    }

    /** Le plus grand rapport auquel une image de cette taille tient dans le panneau. */
    private double getRapport(int largeur, int hauteur) {
        return Math.min(getWidth() / getPixel() / largeur, getHeight() / getPixel() / hauteur);
    }

    /** La plus grande taille de ces proportions qui tient dans le panneau, en pixels. */
    Dimension getTailleMax(int largeur, int hauteur) {
        double rapport = getRapport(largeur, hauteur);
        return new Dimension(Math.max(1, (int) Math.round(rapport * largeur)),
                Math.max(1, (int) Math.round(rapport * hauteur)));
    }

    /** Le rapport de la taille affichée de l'image à sa taille. */
    double getReduction() {
        return loupe > 0 ? loupe : Math.min(1, getRapport(getVisible().largeur, getVisible().hauteur));
    }

    /** La place des points de l'image : au milieu ou, à la loupe, autour du milieu. */
    private AffineTransform getVue() {
        ImageMemoire image = getVisible();
        double pixel = getPixel();
        // d'une image très réduite, il reste une ligne
        double l = pixel * Math.max(getReduction(), 1.0 / image.largeur);
        double h = pixel * Math.max(getReduction(), 1.0 / image.hauteur);
        Point2D vu = getMilieu();
        // le coin de l'image est celui d'un pixel de l'écran
        return new AffineTransform(l, 0, 0, h, pixel * Math.rint((getWidth() / 2.0 - l * vu.getX()) / pixel),
                pixel * Math.rint((getHeight() / 2.0 - h * vu.getY()) / pixel));
    }

    /** Le point de l'image qui est au milieu du panneau, à l'arrondi de la vue près. */
    private Point2D getMilieu() {
        ImageMemoire image = getVisible();
        return loupe == 0 ? new Point2D.Double(image.largeur / 2.0, image.hauteur / 2.0)
                : new Point2D.Double(Math.min(image.largeur, milieu.getX()), Math.min(image.hauteur, milieu.getY()));
    }

    /** La place de ce point de l'image. */
    Point2D placeDe(double xe, double ye) {
        return getVue().transform(new Point2D.Double(xe, ye), null);
    }

    /** Le point de l'image qui est là. */
    Point2D pointDe(Point2D ici) {
        AffineTransform vue = getVue();
        return new Point2D.Double((ici.getX() - vue.getTranslateX()) / vue.getScaleX(),
                (ici.getY() - vue.getTranslateY()) / vue.getScaleY());
    }

    /** Le pixel de l'image qui est là, ou le plus proche. */
    private Point pixelDe(Point2D ici) {
        Point2D point = pointDe(ici);
        return new Point((int) Math.max(0, Math.min(getVisible().largeur - 1, point.getX())),
                (int) Math.max(0, Math.min(getVisible().hauteur - 1, point.getY())));
    }

    private boolean estSousLaSouris() {
        return getVisible() != null && souris != null
                && new Rectangle(getVisible().largeur, getVisible().hauteur).contains(pointDe(souris));
    }

    /** Le pixel de l'image sous la souris ou, à défaut, au milieu ; {@code null} sans image. */
    Point getPixelVise() {
        if (getVisible() == null) {
            return null;
        }
        return pixelDe(estSousLaSouris() ? souris : getCentre());
    }

    /** Le pixel de l'image sous la souris ; {@code null} s'il n'y en a pas, ou s'il n'est pas encore dessiné. */
    Point getPixelSouris() {
        Point pixel = estSousLaSouris() ? pixelDe(souris) : null;
        return pixel == null || getVisible().codes[pixel.y * getVisible().largeur + pixel.x] == 0 ? null : pixel;
    }

    /** Agrandit ou réduit deux fois, comme la molette, autour du pixel suivi ou, à défaut, du milieu. */
    void approcher(boolean plus) {
        grossir(plus, suivi == null ? getCentre() : placeDe(suivi.x + 0.5, suivi.y + 0.5));
    }

    /** Agrandit ou réduit deux fois ; ce qui est là y reste. */
    private void grossir(boolean plus, Point2D ici) {
        if (montree == null) {
            return;
        }
        Point2D vise = pointDe(ici);
        if (loupe > 0) {
            // celui que la vue n'arrondit pas : chaque doublement doublerait son écart
            Point2D vu = getMilieu();
            double fois = loupe * getPixel();
            vise = new Point2D.Double(vu.getX() + (ici.getX() - getCentre().getX()) / fois,
                    vu.getY() + (ici.getY() - getCentre().getY()) / fois);
        }
        // une image réduite passe d'abord à sa taille, un pixel pour un pixel
        int premiere = getRapport(montree.largeur, montree.hauteur) < 1 ? 1 : 2;
        int moins = loupe <= premiere ? 0 : loupe / 2;
        loupe = plus ? Math.max(premiere, Math.min(LOUPE_MAX, 2 * loupe)) : moins;
        amener(vise, ici);
    }

    /** Garde ce pixel de l'image visible à la loupe ; {@code null} pour aucun. */
    void suivre(Point pixel) {
        suivi = pixel;
        if (loupe > 0 && suivi != null && !new Rectangle(getSize()).contains(getVue()
                .createTransformedShape(new Rectangle(suivi.x, suivi.y, 1, 1)).getBounds2D())) {
            amener(suivi, getCentre());
        }
    }

    /** Place là, à la loupe, ce point de l'image. */
    private void amener(Point2D point, Point2D ici) {
        double fois = Math.max(1, loupe) * getPixel();
        milieu = new Point2D.Double(Math.max(0, point.getX() + (getCentre().getX() - ici.getX()) / fois),
                Math.max(0, point.getY() + (getCentre().getY() - ici.getY()) / fois));
        repaint();
        siBouge.run();
    }

    /** Peint cette figure par-dessus l'image ; {@code null} pour aucune. */
    void superposer(Figure figure) {
        dessus = figure;
        repaint();
    }

    /** Une image de Java qui partage ce tableau de codes. @param vides vrai si un code 0 y est transparent */
    static BufferedImage deJava(ImageMemoire image, boolean vides) {
        DirectColorModel couleurs = vides ? new DirectColorModel(32, 0xFF0000, 0xFF00, 0xFF, 0xFF000000)
                : new DirectColorModel(24, 0xFF0000, 0xFF00, 0xFF);
        return new BufferedImage(couleurs, Raster.createPackedRaster(new DataBufferInt(image.codes, image.codes.length),
                image.largeur, image.hauteur, image.largeur, couleurs.getMasks(), null), false, null);
    }

    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        if (getVisible() != null) {
            Graphics2D g2 = (Graphics2D) g.create();
            peindre(g2);
            if (dessus != null && tenue == null) {
                dessus.peindre(g2, getVue());
            }
            prises.accept(g2);
            g2.dispose();
        }
    }

    /** Peint les pixels visibles seulement : AWT ne peut peindre une image entière très agrandie. */
    private void peindre(Graphics2D g) {
        Point de = pixelDe(new Point());
        Point a = pixelDe(new Point(getWidth(), getHeight()));
        AffineTransform vue = getVue();
        vue.translate(de.x, de.y);
        if (getReduction() < 1) {
            g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        }
        g.drawImage(deJava(getVisible(), true).getSubimage(de.x, de.y, a.x - de.x + 1, a.y - de.y + 1), vue, null);
    }

    /** Le bandeau couvre le bas de l'image sans la déplacer ; s'il est trop haut, sa fin est coupée. */
    @Override
    public void doLayout() {
        bandeau.setSize(getWidth(), Short.MAX_VALUE);
        int hauteur = bandeau.getPreferredSize().height;
        bandeau.setBounds(0, Math.max(0, getHeight() - hauteur), getWidth(), hauteur);
    }
}
