package lancer.fenetre.vue;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Polygon;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.AffineTransform;
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

    private static final Color GRIS = new Color(0x777777);
    /** Le plus grand écart, en points, entre le début et la fin d'un clic. */
    private static final int TREMBLEMENT = 4;
    private static final int RAYON_ETOILE = 9;
    private static final Shape ETOILE = new Polygon(new int[] {0, 2, 9, 2, 0, -2, -9, -2},
            new int[] {-9, -2, 0, 2, 9, 2, 0, -2}, 8);

    final Bandeau bandeau;
    private final Consumer<Suite.Evenement> recevoir;
    private final Runnable siBouge;
    private Etat etat;
    /** La place de la souris dans le panneau, ou {@code null}, et vrai si Maj y est tenue. */
    private Point souris;
    private boolean etoiles;

    /** @param siBouge appelé quand la souris bouge */
    PanneauImage(Etat etat, Consumer<Suite.Evenement> recevoir, Runnable siBouge) {
        this.etat = etat;
        this.recevoir = recevoir;
        this.siBouge = siBouge;
        bandeau = new Bandeau(recevoir);
        setName("image");
        setBackground(GRIS);
        setFocusable(true);
        getAccessibleContext().setAccessibleName("image");
        add(bandeau);
        setPreferredSize(new Dimension((int) Math.ceil(etat.ecran.loupe.largeur * getPixel()),
                (int) Math.ceil(etat.ecran.loupe.hauteur * getPixel())));
        Suiveur suiveur = new Suiveur();
        addMouseListener(suiveur);
        addMouseMotionListener(suiveur);
        addMouseWheelListener(suiveur);
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent e) {
                recevoir.accept(suite -> suite.tenir(false));
            }
        });
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                Loupe placee = getLoupe();
                recevoir.accept(suite -> suite.placer(placee.largeur, placee.hauteur));
            }
        });
    }

    /** Dit ce que fait la souris. La molette règle la loupe ; un bouton tenu tire l'image ou, avec Maj, une boule. */
    private final class Suiveur extends MouseAdapter {

        private Point appui = new Point();
        /** Le point de l'image qui est tiré avec elle, ou {@code null}. */
        private lancer.Point saisi;

        private void placer(MouseEvent e) {
            souris = e.getPoint();
        }

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            placer(e);
            appui = e.getPoint();
            saisi = null;
            if (getImage() != null && SwingUtilities.isLeftMouseButton(e) && e.isShiftDown()) {
                lancer.Point point = pointSousLaSouris(0);
                double portee = RAYON_ETOILE / getPixel() / getLoupe().getReduction(getImage());
                recevoir.accept(suite -> suite.saisir(point.x, point.y, portee));
            } else if (getImage() != null && !e.isShiftDown()) {
                saisi = pointSousLaSouris(0.5);
            }
        }

        /** Un clic. AWT n'en signale pas si la souris bouge d'un seul pixel pendant l'appui. */
        @Override
        public void mouseReleased(MouseEvent e) {
            placer(e);
            if (!SwingUtilities.isLeftMouseButton(e)) {
                return;
            }
            if (etat.geste != null) {
                recevoir.accept(Suite::lacher);
            } else if (e.getPoint().distance(appui) <= TREMBLEMENT && !e.isShiftDown() && e.getClickCount() <= 1
                    && estSousLaSouris()) {
                // le premier clic a pu réduire l'image : le second désignerait un autre pixel
                expliquer();
            }
        }

        @Override
        public void mouseMoved(MouseEvent e) {
            placer(e);
            if (etoiles != e.isShiftDown()) {
                etoiles = e.isShiftDown();
                repaint();
            }
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
            if (etat.geste != null) {
                lancer.Point point = pointSousLaSouris(0);
                recevoir.accept(suite -> suite.tirer(point.x, point.y));
            } else if (saisi != null && !e.isShiftDown()) {
                lancer.Point point = saisi;
                recevoir.accept(suite -> suite.amener(point, enPixels(souris.x) + 0.5, enPixels(souris.y) + 0.5));
            }
            siBouge.run();
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            placer(e);
            if (e.getWheelRotation() != 0) {
                recevoir.accept(suite -> suite.grossir(e.getWheelRotation() < 0, enPixels(souris.x) + 0.5,
                        enPixels(souris.y) + 0.5));
            }
            siBouge.run();
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
        GraphicsConfiguration ecran = getGraphicsConfiguration();
        return 1 / (ecran != null ? ecran : GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice()
                .getDefaultConfiguration()).getDefaultTransform().getScaleX();
    }

    private double enPixels(double points) {
        return points / getPixel();
    }

    /** La loupe, à la place que l'image a ici : l'état l'apprend un instant plus tard. */
    private Loupe getLoupe() {
        return etat.ecran.loupe.dans((int) Math.max(1, Math.round(enPixels(getWidth()))),
                (int) Math.max(1, Math.round(enPixels(getHeight()))));
    }

    /** @param dedans 0.5 pour le milieu d'un pixel de l'écran, et non son bord */
    private lancer.Point pointSousLaSouris(double dedans) {
        return getLoupe().pointDe(getImage(), enPixels(souris.x) + dedans, enPixels(souris.y) + dedans);
    }

    private boolean estSousLaSouris() {
        return getImage() != null && souris != null
                && getLoupe().contient(getImage(), enPixels(souris.x) + 0.5, enPixels(souris.y) + 0.5);
    }

    /** Le pixel de l'image sous la souris ou, à défaut, au milieu. */
    Pixel getPixelVise() {
        Loupe loupe = getLoupe();
        return estSousLaSouris() ? loupe.pixelDe(getImage(), enPixels(souris.x) + 0.5, enPixels(souris.y) + 0.5)
                : loupe.pixelDe(getImage(), loupe.largeur / 2.0, loupe.hauteur / 2.0);
    }

    /** Montre les rayons du pixel visé. */
    void expliquer() {
        if (getImage() != null) {
            Pixel vise = getPixelVise();
            recevoir.accept(suite -> suite.expliquer(vise));
        }
    }

    /** Le pixel de l'image sous la souris ; {@code null} s'il n'y en a pas, ou s'il n'est pas encore dessiné. */
    Pixel getPixelSouris() {
        Pixel pixel = estSousLaSouris() ? getPixelVise() : null;
        return pixel == null || getImage().codes[pixel.y * getImage().largeur + pixel.x] == 0 ? null : pixel;
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
                new Figure(etat.explication.faite.inspection).peindre(g2, getVue());
            }
            peindreLesEtoiles(g2);
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

    /** Avec Maj, peint l'étoile de chaque lampe qui est devant l'œil. */
    private void peindreLesEtoiles(Graphics2D g) {
        if (etoiles && etat.montre.dessin != null) {
            g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            for (Lampe lampe : etat.demande.lue.lampes) {
                lancer.Point vue = Prise.etoile(etat.montre.dessin.lancer.getCamera(), lampe);
                if (vue != null) {
                    lancer.Point ou = getLoupe().placeDe(getImage(), vue.x, vue.y);
                    Figure.tracer(g, AffineTransform.getTranslateInstance(ou.x * getPixel(), ou.y * getPixel())
                            .createTransformedShape(ETOILE), Figure.LAMPE);
                }
            }
        }
    }

    /** Le bandeau couvre le bas de l'image sans la déplacer ; s'il est trop haut, sa fin est coupée. */
    @Override
    public void doLayout() {
        bandeau.setSize(getWidth(), Short.MAX_VALUE);
        int hauteur = bandeau.getPreferredSize().height;
        bandeau.setBounds(0, Math.max(0, getHeight() - hauteur), getWidth(), hauteur);
    }
}
