package lancer.fenetre;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Graphics;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.DataBufferInt;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import lancer.fenetre.figures.Figure;
import lancer.image.ImageMemoire;
import lancer.image.Reduction;

/**
 * L'image sur un gris neutre, pixel pour pixel ; réduite, ses proportions gardées, là où la place manque. Les places et
 * la souris sont en pixels de l'écran, plusieurs par point s'il est dense.
 */
@SuppressWarnings("serial")
final class PanneauImage extends JPanel {

    private static final Color GRIS = new Color(0x777777);
    private static final int LOUPE_MAX = 16;
    private static final int TREMBLEMENT = 4;
    /** Lignes et colonnes d'une image en cours dont un pixel réduit est la moyenne. */
    private static final int LIGNES_REGARDEES = 4;

    final Bandeau bandeau = new Bandeau();
    /** L'image montrée, {@code null} avant la première ; celle d'avant, tant qu'on la tient à la place des autres. */
    ImageMemoire montree;
    ImageMemoire tenue;
    /** Une petite image, le temps que le brouillon se dessine. */
    ImageMemoire apercu;
    /** Ce qui peut se prendre, par-dessus l'image. */
    Consumer<Graphics2D> prises = g -> { };
    /** L'image réduite à sa place, et ce dont elle dépend. */
    private BufferedImage reduite;
    private ImageMemoire reduiteDe;
    private boolean reduiteAchevee;
    private Figure dessus;
    private IntConsumer siNumero;
    private final Runnable siBouge;
    private final Runnable siClique;
    private Point souris;
    private Point appui = new Point();
    private Point suivi;
    /** Ligne qui se lit sur le haut de l'image. */
    String ligne = "";
    boolean peinte;

    /** Grossissement de la loupe, 0 sans elle, et le point de l'image qu'elle met au milieu, en parts de ses côtés. */
    private int loupe;
    private double centreX = 0.5;
    private double centreY = 0.5;

    /** @param siBouge appelé quand la souris ou la loupe bouge @param siClique quand on clique sur l'image montrée */
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

    /** Suit la souris ; la molette, et un bouton tenu, mènent la loupe. */
    private final class Suiveur extends MouseAdapter {

        private void placer(MouseEvent e) {
            AffineTransform ecran = getEchelle();
            souris = new Point((int) (e.getX() * ecran.getScaleX()), (int) (e.getY() * ecran.getScaleY()));
        }

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            appui = e.getPoint();
        }

        /** Un clic ; AWT n'en voit plus si le bouton est tenu et que la main tremble, ne fût-ce que d'un pixel. */
        @Override
        public void mouseReleased(MouseEvent e) {
            placer(e);
            int numero = dessus == null ? 0 : dessus.numeroEn(souris);
            // le second clic d'un double clic dirait un autre pixel, si le panneau a réduit l'image entre les deux
            if (!SwingUtilities.isLeftMouseButton(e) || e.getPoint().distance(appui) > TREMBLEMENT || e.isShiftDown()
                    || e.getClickCount() > 1) {
                return;
            }
            if (numero > 0) {
                siNumero.accept(numero);
            } else if (montree != null && getPlace(montree).contains(souris)) {
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
            perdreSouris();
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            if (loupe > 0 && souris != null && !e.isShiftDown()) {
                Point avant = souris;
                placer(e);
                centrer(centreX - (souris.x - avant.x) / (double) (loupe * montree.largeur),
                        centreY - (souris.y - avant.y) / (double) (loupe * montree.hauteur));
            }
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            placer(e);
            if (e.getWheelRotation() != 0 && !e.isShiftDown()) {
                grossir(e.getWheelRotation() < 0);
            }
        }
    }

    /** Oublie où est la souris : sortie, ou la fenêtre a bougé sous elle, qui n'en dit rien. */
    void perdreSouris() {
        souris = null;
        siBouge.run();
    }

    /** Dit ceci en une ligne sur le haut de l'image. @param texte vide pour ne plus rien dire */
    void dire(String texte) {
        ligne = texte;
        repaint();
    }

    ImageMemoire getVisible() {
        return tenue != null ? tenue : apercu != null ? apercu : montree;
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

    /** La plus grande taille de ces proportions qui tienne ici. */
    Dimension getTailleMax(int largeur, int hauteur) {
        return dans(getLibre(), largeur, hauteur);
    }

    /** La plus grande taille de ces proportions qui tienne dans cette place. */
    static Dimension dans(Dimension libre, int largeur, int hauteur) {
        double rapport = Math.min((double) libre.width / largeur, (double) libre.height / hauteur);
        return new Dimension(Math.max(1, (int) Math.round(rapport * largeur)),
                Math.max(1, (int) Math.round(rapport * hauteur)));
    }

    /** Place de cette image ; à la loupe, elle déborde. */
    private Rectangle getPlace(ImageMemoire image) {
        Dimension libre = getLibre();
        Dimension max = getTailleMax(image.largeur, image.hauteur);
        int l = loupe > 0 ? loupe * image.largeur : Math.min(image.largeur, max.width);
        int h = loupe > 0 ? loupe * image.hauteur : Math.min(image.hauteur, max.height);
        return new Rectangle((int) (libre.width / 2.0 - centreX * l), (int) (libre.height / 2.0 - centreY * h), l, h);
    }

    /** Le rapport de la taille à laquelle l'image est montrée à la sienne, du côté où il est le plus petit. */
    double getReduction(ImageMemoire image) {
        Rectangle place = getPlace(image);
        return Math.min((double) place.width / image.largeur, (double) place.height / image.hauteur);
    }

    /** Agrandit deux fois plus, ou deux fois moins, comme la molette, sans perdre de vue le pixel suivi. */
    void approcher(boolean plus) {
        grossir(plus);
        suivre(suivi);
    }

    private void grossir(boolean plus) {
        if (montree == null) {
            return;
        }
        // une image qui ne tient qu'en réduction passe d'abord à sa taille, un pixel pour un
        Dimension max = getTailleMax(montree.largeur, montree.hauteur);
        int premiere = montree.largeur > max.width || montree.hauteur > max.height ? 1 : 2;
        int autre = plus ? Math.max(premiere, Math.min(LOUPE_MAX, 2 * loupe)) : loupe <= premiere ? 0 : loupe / 2;
        Dimension libre = getLibre();
        Point ici = souris == null ? new Point(libre.width / 2, libre.height / 2) : souris;
        Rectangle place = getPlace(montree);
        loupe = autre;
        if (loupe == 0) {
            centrer(0.5, 0.5);
        } else {
            Rectangle apres = getPlace(montree);
            centrer((double) (ici.x - place.x) / place.width - (ici.x - libre.width / 2.0) / apres.width,
                    (double) (ici.y - place.y) / place.height - (ici.y - libre.height / 2.0) / apres.height);
        }
    }

    /** Garde ce pixel de l'image en vue à la loupe ; {@code null} : plus aucun. */
    void suivre(Point pixel) {
        suivi = pixel;
        if (loupe > 0 && suivi != null) {
            Rectangle place = getPlace(montree);
            Rectangle carre = new Rectangle(place.x + loupe * suivi.x, place.y + loupe * suivi.y, loupe, loupe);
            if (!new Rectangle(getLibre()).contains(carre)) {
                centrer((suivi.x + 0.5) / montree.largeur, (suivi.y + 0.5) / montree.hauteur);
            }
        }
    }

    private void centrer(double x, double y) {
        centreX = Math.max(0, Math.min(1, x));
        centreY = Math.max(0, Math.min(1, y));
        repaint();
        siBouge.run();
    }

    /** Peint ceci par-dessus l'image, à l'écran seulement ; un clic sur un numéro va à {@code siChoisi}. */
    void superposer(Figure figure, IntConsumer siChoisi) {
        dessus = figure;
        siNumero = siChoisi;
        repaint();
    }

    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        Graphics2D g2 = (Graphics2D) g.create();
        // défait l'agrandissement d'un écran dense : l'image a déjà ses pixels
        AffineTransform t = g2.getTransform();
        g2.setTransform(AffineTransform.getTranslateInstance(Math.round(t.getTranslateX()),
                Math.round(t.getTranslateY())));
        peinte |= getVisible() != null;
        peindre(g2, getVisible());
        if (dessus != null && montree != null && tenue == null) {
            g2.setFont(getFont().deriveFont((float) (getFont().getSize2D() * t.getScaleX())));
            dessus.peindre(g2, getPlace(montree), getLibre());
        }
        prises.accept(g2);
        g2.dispose();
        if (!ligne.isEmpty()) {
            FontMetrics m = g.getFontMetrics();
            g.setColor(new Color(0x80000000, true));
            g.fillRect(0, 0, getWidth(), m.getHeight());
            g.setColor(Color.WHITE);
            g.drawString(ligne, m.getHeight() / 2, m.getAscent());
        }
    }

    private static BufferedImage image(int[] codes, int largeur) {
        // sur le tableau même des codes : rien n'est copié
        DirectColorModel couleurs = (DirectColorModel) ColorModel.getRGBdefault();
        return new BufferedImage(couleurs, Raster.createPackedRaster(new DataBufferInt(codes, codes.length), largeur,
                codes.length / largeur, largeur, couleurs.getMasks(), null), false, null);
    }

    /** Peint les pixels qui sont en vue : l'image entière, à la loupe, AWT ne saurait la peindre. */
    private void peindre(Graphics2D g, ImageMemoire image) {
        if (image == null) {
            return;
        }
        Rectangle place = getPlace(image);
        if (place.width < image.largeur) {
            g.drawImage(reduire(image, place), place.x, place.y, null);
            return;
        }
        BufferedImage pixels = image(image.codes, image.largeur);
        double l = (double) place.width / image.largeur;
        double h = (double) place.height / image.hauteur;
        Point de = getPixel(image, new Point());
        Point a = getPixel(image, new Point(getLibre().width, getLibre().height));
        g.drawImage(pixels, (int) Math.round(place.x + l * de.x), (int) Math.round(place.y + h * de.y),
                (int) Math.round(place.x + l * (a.x + 1)), (int) Math.round(place.y + h * (a.y + 1)),
                de.x, de.y, a.x + 1, a.y + 1, null);
    }

    /** L'image à la taille de sa place, chaque pixel en étant une moyenne : exacte une fois l'image achevée. */
    private BufferedImage reduire(ImageMemoire image, Rectangle place) {
        boolean achevee = image.legende != null;
        if (!achevee || !reduiteAchevee || image != reduiteDe || reduite.getWidth() != place.width) {
            reduite = image(Reduction.moyenne(image, place.width, place.height,
                    achevee ? 1 : 1 + image.largeur / (LIGNES_REGARDEES * place.width)), place.width);
            reduiteDe = image;
            reduiteAchevee = achevee;
        }
        return reduite;
    }

    /** Le bandeau recouvre le bas de l'image, sans la pousser ; plus haut qu'elle, c'est sa fin qui ne se voit pas. */
    @Override
    public void doLayout() {
        bandeau.setSize(getWidth(), Short.MAX_VALUE);
        int hauteur = bandeau.getPreferredSize().height;
        bandeau.setBounds(0, Math.max(0, getHeight() - hauteur), getWidth(), hauteur);
    }

    /** Le pixel de l'image montrée sous la souris, ou le plus près du milieu ; {@code null} s'il n'y en a pas. */
    Point getPixelVise() {
        boolean sous = souris != null && montree != null && getPlace(montree).contains(souris);
        return montree == null ? null
                : getPixel(montree, sous ? souris : new Point(getLibre().width / 2, getLibre().height / 2));
    }

    /** Le pixel de cette image qui est sous la souris ; {@code null} s'il n'y en a pas, ou s'il n'est pas dessiné. */
    Point getPixelSouris(ImageMemoire image) {
        if (souris == null || image == null || !getPlace(image).contains(souris)) {
            return null;
        }
        Point pixel = getPixel(image, souris);
        return image.codes[pixel.y * image.largeur + pixel.x] == 0 ? null : pixel;
    }

    /** Où se peint ce point de l'image montrée, en pixels de l'écran. */
    Point2D placeDe(double xe, double ye) {
        Rectangle place = getPlace(montree);
        return new Point2D.Double(place.x + xe * place.width / montree.largeur,
                place.y + ye * place.height / montree.hauteur);
    }

    /** Le point de l'image montrée qui se peint sous cet événement, en pixels de l'image. */
    Point2D pointDe(MouseEvent e) {
        AffineTransform ecran = getEchelle();
        Rectangle place = getPlace(montree);
        return new Point2D.Double((e.getX() * ecran.getScaleX() - place.x) * montree.largeur / place.width,
                (e.getY() * ecran.getScaleY() - place.y) * montree.hauteur / place.height);
    }

    private Point getPixel(ImageMemoire image, Point ou) {
        Rectangle place = getPlace(image);
        long x = (long) (ou.x - place.x) * image.largeur / place.width;
        long y = (long) (ou.y - place.y) * image.hauteur / place.height;
        return new Point((int) Math.max(0, Math.min(image.largeur - 1, x)),
                (int) Math.max(0, Math.min(image.hauteur - 1, y)));
    }
}
