package lancer.fenetre.vue.figures;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Objects;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.swing.UIManager;
import lancer.Camera;
import lancer.Point;
import lancer.PointContact;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.inspection.Inspection;
import lancer.inspection.Segment;

/** La figure du cours, vue de côté : l'œil, et à sa droite l'écran, les sphères et les rayons. */
@SuppressWarnings("serial")
public final class VueDeCote extends JPanel {

    private static final int MARGE = 14;
    private static final Color SPHERE = new Color(0x949494);

    private Inspection pixel;

    public VueDeCote() {
        setName("cote");
        getAccessibleContext().setAccessibleName("vue de côté des rayons");
        setToolTipText("vue de côté : ce que vise l'œil à droite, le haut de l'image en haut");
    }

    public void montrer(Inspection nouvelle) {
        pixel = nouvelle;
        repaint();
    }

    @Override
    protected void paintComponent(Graphics g) {
        g.setColor(UIManager.getColor("Tree.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        if (pixel != null) {
            ((Graphics2D) g).setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            peindre((Graphics2D) g, cadrer());
        }
    }

    /** Ce qui place un point, vu de l'œil, d'abscisse z et d'ordonnée y, et montre l'œil, l'écran et les contacts. */
    AffineTransform cadrer() {
        Camera camera = pixel.camera;
        Point haut = camera.getEcran(0, 0);
        Stream<Point> contacts = pixel.getSegments().stream().map(segment -> segment.contact);
        List<Vecteur> vus = Stream.concat(contacts.filter(Objects::nonNull),
                Stream.of(haut, camera.getEcran(0, camera.getHauteur()), camera.getOeil()))
                .map(camera::depuisLOeil).collect(Collectors.toList());
        DoubleSummaryStatistics z = vus.stream().mapToDouble(p -> p.z).summaryStatistics();
        DoubleSummaryStatistics y = vus.stream().mapToDouble(p -> p.y).summaryStatistics();
        // la marge laisse voir le bord des objets touchés
        double marge = 1 + (z.getMax() - camera.depuisLOeil(haut).z) / 10;
        double echelle = Math.min((getWidth() - 2 * MARGE) / (z.getMax() + marge - z.getMin()),
                (getHeight() - 2 * MARGE) / (y.getMax() - y.getMin() + 2 * marge));
        AffineTransform vue = AffineTransform.getTranslateInstance(MARGE, getHeight() / 2.0);
        vue.scale(echelle, -echelle);
        vue.translate(-z.getMin(), -(y.getMin() + y.getMax()) / 2);
        return vue;
    }

    Point2D place(AffineTransform vue, Point p) {
        Vecteur vu = pixel.camera.depuisLOeil(p);
        return vue.transform(new Point2D.Double(vu.z, vu.y), null);
    }

    private void peindre(Graphics2D g, AffineTransform vue) {
        for (Segment segment : pixel.getSegments()) {
            entourer(g, vue, segment.contact);
            segment.eclairages.forEach(lampe -> entourer(g, vue, lampe.obstacle));
        }
        BiFunction<Point, Point, Line2D> ligne = (a, b) -> new Line2D.Double(place(vue, a), place(vue, b));
        Color encre = UIManager.getColor("Tree.textForeground");
        g.setColor(encre);
        g.draw(ligne.apply(pixel.camera.getEcran(0, pixel.camera.getHauteur()), pixel.camera.getEcran(0, 0)));
        Figure.peindre(g, pixel, new Rectangle(getSize()), encre, ligne);
        Point2D oeil = place(vue, pixel.camera.getOeil());
        g.setColor(encre);
        g.fill(new Ellipse2D.Double(oeil.getX() - 3, oeil.getY() - 3, 6, 6));
        g.drawString("œil", (float) oeil.getX(), (float) oeil.getY() - 6);
    }

    /** Peint le bord visible d'une sphère : d'un grand cercle, Java ne peint juste qu'un petit arc. */
    private void entourer(Graphics2D g, AffineTransform vue, PointContact contact) {
        if (contact != null && contact.objet instanceof Sphere) {
            Sphere s = (Sphere) contact.objet;
            double x = place(vue, s.getCentre()).getX();
            double y = place(vue, s.getCentre()).getY();
            double r = s.getRayon() * vue.getScaleX();
            double milieu = Math.toDegrees(Math.atan2(y - getHeight() / 2.0, getWidth() / 2.0 - x));
            double demi = Math.min(180, Math.toDegrees(2 * Math.hypot(getWidth(), getHeight()) / r));
            g.setColor(SPHERE);
            g.draw(new Arc2D.Double(x - r, y - r, 2 * r, 2 * r, milieu - demi, 2 * demi, Arc2D.OPEN));
        }
    }
}
