package lancer.fenetre;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
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
 * L'image sur un gris neutre. Si la place manque, elle est réduite dans ses proportions. Les positions sont en pixels
 * de l'écran, et non en points : un écran dense a plusieurs pixels par point.
 */
@SuppressWarnings("serial")
final class PanneauImage extends JPanel {

    private static final Color GRIS = new Color(0x777777);
    private static final int LOUPE_MAX = 16;
    /** Le plus grand écart, en points, entre le début et la fin d'un clic. */
    private static final int TREMBLEMENT = 4;

    final Bandeau bandeau = new Bandeau();
    /** L'image montrée, {@code null} avant la première ; l'image « avant », tant que sa touche est tenue. */
    ImageMemoire montree;
    ImageMemoire tenue;
    /** Dessine ce qui peut être pris, par-dessus l'image. */
    Consumer<Graphics2D> prises = g -> { };
    private Figure dessus;
    private final Runnable siBouge;
    private final Runnable siClique;
    private Point souris;
    private Point appui = new Point();
    /** Pixel à garder en vue à la loupe, ou {@code null}. */
    private Point suivi;

    /** Grossissement de la loupe, 0 sans loupe ; la place voulue du coin de l'image grossie. */
    private int loupe;
    private Point coin = new Point();

    /** @param siBouge appelé quand la souris ou la loupe bouge @param siClique appelé après un clic sur l'image */
    PanneauImage(Dimension image, Runnable siBouge, Runnable siClique) {
        this.siBouge = siBouge;
        this.siClique = siClique;
        setName("image");
        setBackground(GRIS);
        setFocusable(true);
        getAccessibleContext().setAccessibleName("image");
        add(bandeau);
        AffineTransform ecran = getEchelle();
        setPreferredSize(new Dimension((int) Math.ceil(image.width / ecran.getScaleX()),
                (int) Math.ceil(image.height / ecran.getScaleY())));
        Suiveur suiveur = new Suiveur();
        addMouseListener(suiveur);
        addMouseMotionListener(suiveur);
        addMouseWheelListener(suiveur);
    }

    /** Suit la souris. La molette règle la loupe, et un bouton tenu la déplace. */
    private final class Suiveur extends MouseAdapter {

        private void placer(MouseEvent e) {
            souris = new Point();
            getEchelle().transform(e.getPoint(), souris);
        }

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            appui = e.getPoint();
        }

        /** Un clic. AWT n'en signale pas si la souris bouge d'un seul pixel pendant l'appui. */
        @Override
        public void mouseReleased(MouseEvent e) {
            placer(e);
            // le premier clic a pu réduire l'image : le second désignerait un autre pixel
            if (SwingUtilities.isLeftMouseButton(e) && e.getPoint().distance(appui) <= TREMBLEMENT
                    && !e.isShiftDown() && e.getClickCount() <= 1
                    && montree != null && getPlace(montree).contains(souris)) {
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
            if (loupe > 0 && souris != null && !e.isShiftDown()) {
                Point avant = souris;
                placer(e);
                Rectangle place = getPlace(montree);
                poser(place.x + souris.x - avant.x, place.y + souris.y - avant.y);
            }
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            placer(e);
            if (e.getWheelRotation() != 0) {
                grossir(e.getWheelRotation() < 0);
            }
        }
    }

    ImageMemoire getVisible() {
        return tenue != null ? tenue : montree;
    }

    private AffineTransform getEchelle() {
        return (getGraphicsConfiguration() != null ? getGraphicsConfiguration()
                : GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice().getDefaultConfiguration())
                .getDefaultTransform();
    }

    private Dimension getLibre() {
        AffineTransform ecran = getEchelle();
        return new Dimension((int) (getWidth() * ecran.getScaleX()), (int) (getHeight() * ecran.getScaleY()));
    }

    /** La plus grande taille de ces proportions qui tient dans le panneau. */
    Dimension getTailleMax(int largeur, int hauteur) {
        Dimension libre = getLibre();
        double rapport = Math.min((double) libre.width / largeur, (double) libre.height / hauteur);
        return new Dimension(Math.max(1, (int) Math.round(rapport * largeur)),
                Math.max(1, (int) Math.round(rapport * hauteur)));
    }

    /** Position de l'image à l'écran : au milieu ou, à la loupe, autour du milieu. */
    private Rectangle getPlace(ImageMemoire image) {
        Dimension libre = getLibre();
        if (loupe > 0) {
            int l = loupe * image.largeur;
            int h = loupe * image.hauteur;
            return new Rectangle(Math.max(libre.width / 2 - l, Math.min(libre.width / 2, coin.x)),
                    Math.max(libre.height / 2 - h, Math.min(libre.height / 2, coin.y)), l, h);
        }
        Dimension max = getTailleMax(image.largeur, image.hauteur);
        int l = Math.min(image.largeur, max.width);
        int h = Math.min(image.hauteur, max.height);
        return new Rectangle((libre.width - l) / 2, (libre.height - h) / 2, l, h);
    }

    /** Le rapport de la taille affichée de l'image à sa taille, le plus petit des deux côtés. */
    double getReduction(ImageMemoire image) {
        Rectangle place = getPlace(image);
        return Math.min((double) place.width / image.largeur, (double) place.height / image.hauteur);
    }

    /** Agrandit ou réduit deux fois, comme la molette, en gardant visible le pixel suivi. */
    void approcher(boolean plus) {
        grossir(plus);
        suivre(suivi);
    }

    private void grossir(boolean plus) {
        if (montree == null) {
            return;
        }
        // une image réduite passe d'abord à sa taille, un pixel pour un pixel
        Dimension max = getTailleMax(montree.largeur, montree.hauteur);
        int premiere = montree.largeur > max.width || montree.hauteur > max.height ? 1 : 2;
        int moins = loupe <= premiere ? 0 : loupe / 2;
        int autre = plus ? Math.max(premiere, Math.min(LOUPE_MAX, 2 * loupe)) : moins;
        Dimension libre = getLibre();
        Point ici = souris == null ? new Point(libre.width / 2, libre.height / 2) : souris;
        Rectangle place = getPlace(montree);
        loupe = autre;
        // le pixel sous la souris y reste
        poser(ici.x - (int) Math.round((ici.x - place.x) * (double) loupe * montree.largeur / place.width),
                ici.y - (int) Math.round((ici.y - place.y) * (double) loupe * montree.hauteur / place.height));
    }

    /** Garde ce pixel de l'image visible à la loupe ; {@code null} pour aucun. */
    void suivre(Point pixel) {
        suivi = pixel;
        if (loupe > 0 && suivi != null) {
            Rectangle place = getPlace(montree);
            Rectangle carre = new Rectangle(place.x + loupe * suivi.x, place.y + loupe * suivi.y, loupe, loupe);
            if (!new Rectangle(getLibre()).contains(carre)) {
                poser(getLibre().width / 2 - loupe * suivi.x, getLibre().height / 2 - loupe * suivi.y);
            }
        }
    }

    private void poser(int x, int y) {
        coin = new Point(x, y);
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
        DirectColorModel couleurs = new DirectColorModel(vides ? 32 : 24, 0xFF0000, 0xFF00, 0xFF,
                vides ? 0xFF000000 : 0);
        return new BufferedImage(couleurs, Raster.createPackedRaster(new DataBufferInt(image.codes, image.codes.length),
                image.largeur, image.hauteur, image.largeur, couleurs.getMasks(), null), false, null);
    }

    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        Graphics2D g2 = (Graphics2D) g.create();
        // annule l'agrandissement d'un écran dense : l'image est déjà en pixels
        AffineTransform t = g2.getTransform();
        g2.setTransform(AffineTransform.getTranslateInstance(Math.round(t.getTranslateX()),
                Math.round(t.getTranslateY())));
        if (getVisible() != null) {
            peindre(g2, getVisible());
        }
        g2.setFont(getFont().deriveFont((float) (getFont().getSize2D() * t.getScaleX())));
        if (dessus != null && montree != null && tenue == null) {
            dessus.peindre(g2, getPlace(montree), getLibre());
        }
        prises.accept(g2);
        g2.dispose();
    }

    /** Peint les pixels visibles seulement : AWT ne peut peindre une image entière très agrandie. */
    private void peindre(Graphics2D g, ImageMemoire image) {
        Rectangle place = getPlace(image);
        Point de = getPixel(image, new Point());
        Point a = getPixel(image, new Point(getLibre().width, getLibre().height));
        double l = (double) place.width / image.largeur;
        double h = (double) place.height / image.hauteur;
        if (l < 1) {
            g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        }
        g.drawImage(deJava(image, true), (int) Math.round(place.x + l * de.x), (int) Math.round(place.y + h * de.y),
                (int) Math.round(place.x + l * (a.x + 1)), (int) Math.round(place.y + h * (a.y + 1)),
                de.x, de.y, a.x + 1, a.y + 1, null);
    }

    /** Le bandeau couvre le bas de l'image sans la déplacer ; s'il est trop haut, sa fin est coupée. */
    @Override
    public void doLayout() {
        bandeau.setSize(getWidth(), Short.MAX_VALUE);
        int hauteur = bandeau.getPreferredSize().height;
        bandeau.setBounds(0, Math.max(0, getHeight() - hauteur), getWidth(), hauteur);
    }

    /** Le pixel de l'image montrée sous la souris ou, à défaut, au milieu ; {@code null} sans image. */
    Point getPixelVise() {
        if (montree == null) {
            return null;
        }
        boolean dedans = souris != null && getPlace(montree).contains(souris);
        return getPixel(montree, dedans ? souris : new Point(getLibre().width / 2, getLibre().height / 2));
    }

    /** Le pixel de cette image sous la souris ; {@code null} s'il n'y en a pas, ou s'il n'est pas encore dessiné. */
    Point getPixelSouris(ImageMemoire image) {
        if (souris == null || image == null || !getPlace(image).contains(souris)) {
            return null;
        }
        Point pixel = getPixel(image, souris);
        return image.codes[pixel.y * image.largeur + pixel.x] == 0 ? null : pixel;
    }

    /** Position à l'écran de ce point de l'image montrée, en pixels de l'écran. */
    Point2D placeDe(double xe, double ye) {
        Rectangle place = getPlace(montree);
        return new Point2D.Double(place.x + xe * place.width / montree.largeur,
                place.y + ye * place.height / montree.hauteur);
    }

    /** Le point de l'image montrée sous cet événement, en pixels de l'image. */
    Point2D pointDe(MouseEvent e) {
        Point2D ou = getEchelle().transform(e.getPoint(), new Point2D.Double());
        Rectangle place = getPlace(montree);
        return new Point2D.Double((ou.getX() - place.x) * montree.largeur / place.width,
                (ou.getY() - place.y) * montree.hauteur / place.height);
    }

    private Point getPixel(ImageMemoire image, Point ou) {
        Rectangle place = getPlace(image);
        long x = (long) (ou.x - place.x) * image.largeur / place.width;
        long y = (long) (ou.y - place.y) * image.hauteur / place.height;
        return new Point((int) Math.max(0, Math.min(image.largeur - 1, x)),
                (int) Math.max(0, Math.min(image.hauteur - 1, y)));
    }
}
