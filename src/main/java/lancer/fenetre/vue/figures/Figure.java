package lancer.fenetre.vue.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.function.BiFunction;
import lancer.Camera;
import lancer.Point;
import lancer.Vecteur;
import lancer.fenetre.etat.Prise;
import lancer.inspection.Inspection;
import lancer.inspection.Segment;
import lancer.inspection.Segment.Eclairage;

/** La chaîne d'un pixel, peinte selon une projection : les rayons, les contacts numérotés, ce qui les éclaire. */
public final class Figure {

    /** La couleur d'une lampe, et de ses rayons. */
    public static final Color LAMPE = new Color(0xFFE040);
    private static final Color REFLET = new Color(0x66E0FF);
    private static final Color OMBRE = new Color(0xFF8A3C);
    private static final Color LISERE = new Color(0, 0, 0, 120);

    private static final Stroke PLEIN = new BasicStroke(1.5f);
    private static final Stroke LARGE = new BasicStroke(3.5f);

    /** Distances minimale à l'œil et maximale d'un bout de trait, en unités de la scène. */
    private static final double PRES = 1e-3;
    private static final double LOIN = 1e6;

    /** Rayon d'un anneau, en hauteurs de caractère. */
    private static final double TAILLE = 0.75;

    private Figure() {
    }

    /** Peint la chaîne de ce pixel sur l'image. @param vue la place des points de l'image */
    public static void peindre(Graphics2D g, Inspection pixel, AffineTransform vue) {
        Camera camera = pixel.camera;
        Rectangle image = new Rectangle(camera.getLargeur(), camera.getHauteur());
        peindre(g, pixel, vue.createTransformedShape(image), Color.WHITE, (a, b) -> {
            double deA = camera.depuisLOeil(a).z;
            double deB = camera.depuisLOeil(b).z;
            if (deA < PRES) {
                // le premier rayon vient de l'œil : il n'est qu'un point de l'image
                return null;
            }
            Point de = Prise.projeter(camera, a);
            Point vers = Prise.projeter(camera, deB < PRES ? a.add((PRES - deA) / (deB - deA), new Vecteur(a, b)) : b);
            return new Line2D.Double(vue.transform(new Point2D.Double(de.x, de.y), null),
                    vue.transform(new Point2D.Double(vers.x, vers.y), null));
        });
    }

    /**
     * Peint la chaîne.
     *
     * @param cadre ce qui se voit
     * @param encre couleur des numéros
     * @param projection donne un segment, ou {@code null} s'il ne se voit pas
     */
    static void peindre(Graphics2D g, Inspection pixel, Shape cadre, Color encre,
            BiFunction<Point, Point, Line2D> projection) {
        Shape avant = g.getClip();
        g.clip(cadre);
        Point depart = pixel.camera.getOeil();
        for (Segment segment : pixel.getSegments()) {
            Point bout = segment.contact != null ? segment.contact : depart.add(LOIN, segment.rayon.getV());
            tracer(g, projection.apply(depart, bout), REFLET);
            for (Eclairage lampe : segment.eclairages) {
                if (lampe.eclaire()) {
                    tracer(g, projection.apply(bout, lampe.lampe.getPosition()), LAMPE);
                } else if (lampe.obstacle != null) {
                    tracer(g, projection.apply(bout, lampe.obstacle), OMBRE);
                }
            }
            depart = bout;
        }
        for (Segment segment : pixel.getSegments()) {
            Line2D contact = segment.contact == null ? null : projection.apply(segment.contact, segment.contact);
            if (contact != null) {
                numeroter(g, contact.getX1(), contact.getY1(), "" + segment.numero, encre);
            }
        }
        g.setClip(avant);
    }

    private static void numeroter(Graphics2D g, double x, double y, String numero, Color encre) {
        double rayon = TAILLE * g.getFont().getSize2D();
        tracer(g, new Ellipse2D.Double(x - rayon, y - rayon, 2 * rayon, 2 * rayon), encre);
        float droite = (float) (x + rayon + 2);
        float haut = (float) (y - rayon - 2);
        if (encre.getRed() > 128) {
            // une encre claire est sur une image de n'importe quelle couleur
            g.setColor(Color.BLACK);
            g.drawString(numero, droite + 1, haut + 1);
        }
        g.setColor(encre);
        g.drawString(numero, droite, haut);
    }

    /** Peint ce trait, bordé, sur un fond de n'importe quelle couleur ; {@code null} pour rien. */
    public static void tracer(Graphics2D g, Shape trait, Color couleur) {
        if (trait != null) {
            g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            g.setStroke(LARGE);
            g.setColor(LISERE);
            g.draw(trait);
            g.setStroke(PLEIN);
            g.setColor(couleur);
            g.draw(trait);
        }
    }
}
