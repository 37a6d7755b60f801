package lancer.fenetre.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.function.BiFunction;
import lancer.Camera;
import lancer.Point;
import lancer.Vecteur;
import lancer.inspection.Inspection;
import lancer.inspection.Segment;
import lancer.inspection.Segment.Eclairage;

/** La chaîne d'un pixel, peinte selon une projection : les rayons, les contacts numérotés, ce qui les éclaire. */
public final class Figure {

    private static final Color REFLET = new Color(0x66E0FF);
    private static final Color LAMPE = new Color(0xFFE040);
    private static final Color OMBRE = new Color(0xFF8A3C);
    private static final Color LISERE = new Color(0, 0, 0, 120);

    private static final Stroke PLEIN = new BasicStroke(1.5f);
    private static final Stroke LARGE = new BasicStroke(3.5f);

    /** Distances minimale à l'œil et maximale d'un bout de trait, en unités de la scène. */
    private static final double PRES = 1e-3;
    private static final double LOIN = 1e6;

    /** Rayon d'un anneau, en hauteurs de caractère. */
    private static final double TAILLE = 0.75;

    private final Inspection pixel;

    /** @param pixel expliqué */
    public Figure(Inspection pixel) {
        this.pixel = pixel;
    }

    /** Peint la chaîne sur l'image. @param place position de l'image @param vue taille de la partie visible */
    public void peindre(Graphics2D g, Rectangle place, Dimension vue) {
        Camera camera = pixel.camera;
        double echelle = (double) place.width / camera.getLargeur();
        peindre(g, place.intersection(new Rectangle(vue)), Color.WHITE, (a, b) -> {
            double deA = camera.depuisLOeil(a).z;
            double deB = camera.depuisLOeil(b).z;
            if (deA < PRES) {
                // le premier rayon vient de l'œil : il n'est qu'un point de l'image
                return null;
            }
            Point de = camera.projeter(a);
            Point vers = camera.projeter(deB < PRES ? a.add((PRES - deA) / (deB - deA), new Vecteur(a, b)) : b);
            return new Line2D.Double(place.x + echelle * de.x, place.y + echelle * de.y,
                    place.x + echelle * vers.x, place.y + echelle * vers.y);
        });
    }

    /**
     * Peint la chaîne.
     *
     * @param cadre ce qui se voit
     * @param encre couleur des numéros
     * @param projection donne un segment, ou {@code null} s'il ne se voit pas
     */
    void peindre(Graphics2D g, Rectangle cadre, Color encre, BiFunction<Point, Point, Line2D> projection) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        Shape avant = g.getClip();
        g.clip(cadre);
        Point depart = pixel.camera.getOeil();
        for (Segment segment : pixel.getSegments()) {
            Point bout = segment.contact != null ? segment.contact : depart.add(LOIN, segment.rayon.getV());
            tracer(g, projection.apply(depart, bout), REFLET);
            for (Eclairage lampe : segment.eclairages) {
                boolean eclaire = lampe.eclaire();
                Point vers = eclaire ? lampe.lampe.getPosition() : lampe.obstacle;
                tracer(g, vers == null ? null : projection.apply(bout, vers), eclaire ? LAMPE : OMBRE);
            }
            depart = bout;
        }
        for (Segment segment : pixel.getSegments()) {
            if (segment.contact != null) {
                numeroter(g, projection.apply(segment.contact, segment.contact), "" + segment.numero, encre);
            }
        }
        g.setClip(avant);
    }

    private static void tracer(Graphics2D g, Line2D segment, Color couleur) {
        if (segment != null) {
            peindreLisere(g, segment, couleur);
        }
    }

    private static void numeroter(Graphics2D g, Line2D contact, String numero, Color encre) {
        if (contact != null) {
            double rayon = TAILLE * g.getFont().getSize2D();
            peindreLisere(g, new Ellipse2D.Double(contact.getX1() - rayon, contact.getY1() - rayon, 2 * rayon,
                    2 * rayon), encre);
            float x = (float) (contact.getX1() + rayon + 2);
            float y = (float) (contact.getY1() - rayon - 2);
            g.setColor(Color.BLACK);
            g.drawString(numero, x + 1, y + 1);
            g.setColor(encre);
            g.drawString(numero, x, y);
        }
    }

    /** Peint ce trait sur un fond de n'importe quelle couleur. */
    public static void peindreLisere(Graphics2D g, Shape trait, Color couleur) {
        g.setStroke(LARGE);
        g.setColor(LISERE);
        g.draw(trait);
        g.setStroke(PLEIN);
        g.setColor(couleur);
        g.draw(trait);
    }
}
