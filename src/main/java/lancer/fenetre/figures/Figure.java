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
import java.util.ArrayList;
import java.util.List;
import lancer.Camera;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.inspection.Eclairage;
import lancer.inspection.Inspection;
import lancer.inspection.Segment;

/** La suite des contacts d'un pixel, peinte sur l'image : contacts, rayons, lampes. Elle n'est calculée qu'une fois. */
public final class Figure {

    private static final Color REFLET = new Color(0x66E0FF);
    private static final Color LAMPE = new Color(0xFFE040);
    private static final Color OMBRE = new Color(0xFF8A3C);
    private static final Color LISERE = new Color(0, 0, 0, 120);

    private static final Stroke PLEIN = new BasicStroke(1.5f);
    private static final Stroke LARGE = new BasicStroke(3.5f);
    private static final Stroke TIRETE = new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 1,
            new float[] {3, 4}, 0);

    /** Nombre de morceaux d'un trait ; chacun est plein ou en tirets. */
    private static final int MORCEAUX = 48;
    /** Distances minimale à l'œil et maximale d'un bout de trait, en unités de la scène. */
    private static final double PRES = 1e-3;
    private static final double LOIN = 1e6;
    /** Un objet cache le trait s'il est à moins de cette part de la distance ; plus loin, c'est la surface touchée. */
    private static final double DEVANT = 1 - 1e-4;

    /** Rayon d'un anneau et longueur d'une flèche, en hauteurs de caractère ; demi-angle d'une flèche, en radians. */
    private static final double TAILLE = 0.75;
    private static final double OUVERTURE = 0.4;

    private final Camera camera;
    private final Scene scene;
    private final List<Trait> traits = new ArrayList<>();
    private final List<double[]> anneaux = new ArrayList<>();
    /** À appeler hors du fil des événements. */
    public Figure(Inspection pixel) {
        camera = pixel.camera;
        scene = pixel.scene.avec(pixel.scene.getModele());
        Point depart = null;
        for (Segment segment : pixel.getSegments()) {
            if (depart != null) {
                tracer(depart, segment.contact == null ? depart.add(LOIN, segment.rayon.getV()) : segment.contact,
                        REFLET, segment.contact == null);
            }
            depart = segment.contact;
            if (depart != null) {
                double[] ou = projeter(depart);
                anneaux.add(new double[] {ou[0], ou[1], segment.numero});
                segment.eclairages.forEach(eclairage -> tracer(segment.contact, eclairage));
            }
        }
    }

    private void tracer(Point contact, Eclairage eclairage) {
        Point position = eclairage.lampe.getPosition();
        if (eclairage.eclaire()) {
            tracer(contact, position, LAMPE, false);
        } else if (eclairage.obstacle != null) {
            tracer(eclairage.obstacle, position, Color.BLACK, false);
            tracer(contact, eclairage.obstacle, OMBRE, false);
        }
    }

    /** La projection d'un point sur l'image, et sa profondeur depuis l'œil. */
    private double[] projeter(Point p) {
        Point vu = camera.projeter(p);
        return new double[] {vu.x, vu.y, profondeur(p)};
    }

    private double profondeur(Point p) {
        return camera.depuisLOeil(p).z;
    }

    private void tracer(Point a, Point b, Color couleur, boolean sansFin) {
        double deA = profondeur(a);
        double deB = profondeur(b);
        if (deA < PRES) {
            return;
        }
        boolean derriere = deB < PRES;
        double[] de = projeter(a);
        double[] vers = projeter(derriere ? a.add((PRES - deA) / (deB - deA), new Vecteur(a, b)) : b);
        double[] parts = couper(de, vers, new Rectangle(camera.getLargeur(), camera.getHauteur()));
        if (parts[0] < parts[1]) {
            traits.add(new Trait(de, vers, parts, couleur, derriere || sansFin || parts[1] < 1));
        }
    }

    /** Les parts du segment entre lesquelles il est dans ce cadre (Liang et Barsky, 1984). */
    private static double[] couper(double[] de, double[] vers, Rectangle cadre) {
        double debut = 0;
        double fin = 1;
        double[] moins = {cadre.getMinX(), cadre.getMinY()};
        double[] plus = {cadre.getMaxX(), cadre.getMaxY()};
        for (int axe = 0; axe < 2; axe++) {
            double pas = vers[axe] - de[axe];
            if (pas != 0) {
                debut = Math.max(debut, ((pas > 0 ? moins : plus)[axe] - de[axe]) / pas);
                fin = Math.min(fin, ((pas > 0 ? plus : moins)[axe] - de[axe]) / pas);
            } else if (de[axe] < moins[axe] || de[axe] > plus[axe]) {
                fin = 0;
            }
        }
        return new double[] {debut, fin};
    }

    /** La projection d'un segment, en petits morceaux, cachés ou non. */
    private final class Trait {

        final double[] x = new double[MORCEAUX + 1];
        final double[] y = new double[MORCEAUX + 1];
        final boolean[] derriere = new boolean[MORCEAUX];
        final Color couleur;
        final boolean fleche;

        Trait(double[] de, double[] vers, double[] parts, Color couleur, boolean fleche) {
            this.couleur = couleur;
            this.fleche = fleche;
            for (int k = 0; k <= MORCEAUX; k++) {
                double part = parts[0] + (parts[1] - parts[0]) * k / MORCEAUX;
                x[k] = de[0] + part * (vers[0] - de[0]);
                y[k] = de[1] + part * (vers[1] - de[1]);
                if (k > 0) {
                    double milieu = part - (parts[1] - parts[0]) / (2 * MORCEAUX);
                    double profondeur = 1 / ((1 - milieu) / de[2] + milieu / vers[2]);
                    derriere[k - 1] = estDerriere((x[k - 1] + x[k]) / 2, (y[k - 1] + y[k]) / 2, profondeur);
                }
            }
        }

        private boolean estDerriere(double xe, double ye, double profondeur) {
            Rayon rayon = camera.getRayon(xe, ye);
            scene.getClosestIntersection(rayon);
            double ecran = profondeur(rayon.getP());
            double pente = profondeur(rayon.getP().add(rayon.getV())) - ecran;
            return rayon.getDistance() < DEVANT * (profondeur - ecran) / pente;
        }

        void peindre(Graphics2D g, Rectangle place, Rectangle vue) {
            double echelle = (double) place.width / camera.getLargeur();
            int debut = 0;
            for (int k = 1; k <= MORCEAUX; k++) {
                if (k == MORCEAUX || derriere[k] != derriere[debut]) {
                    Line2D ligne = new Line2D.Double(place.x + echelle * x[debut], place.y + echelle * y[debut],
                            place.x + echelle * x[k], place.y + echelle * y[k]);
                    if (derriere[debut] || couleur == OMBRE || couleur == Color.BLACK) {
                        g.setStroke(TIRETE);
                        g.setColor(couleur);
                        g.draw(ligne);
                    } else {
                        peindreLisere(g, ligne, couleur);
                    }
                    debut = k;
                }
            }
            double[] de = {place.x + echelle * x[0], place.y + echelle * y[0]};
            double[] vers = {place.x + echelle * x[MORCEAUX], place.y + echelle * y[MORCEAUX]};
            double[] parts = couper(de, vers, vue);
            boolean sort = parts[0] < parts[1] && (fleche || parts[1] < 1);
            double angle = Math.atan2(vers[1] - de[1], vers[0] - de[0]);
            double boutX = de[0] + parts[1] * (vers[0] - de[0]);
            double boutY = de[1] + parts[1] * (vers[1] - de[1]);
            double pointe = TAILLE * g.getFont().getSize2D();
            for (double ecart = -OUVERTURE; sort && ecart <= OUVERTURE; ecart += 2 * OUVERTURE) {
                peindreLisere(g, new Line2D.Double(boutX, boutY, boutX - pointe * Math.cos(angle + ecart),
                        boutY - pointe * Math.sin(angle + ecart)), couleur);
            }
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

    /** @param g en pixels de l'écran @param place position de l'image @param vue taille de la partie visible */
    public void peindre(Graphics2D g, Rectangle place, Dimension vue) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        double rayon = TAILLE * g.getFont().getSize2D();
        double echelle = (double) place.width / camera.getLargeur();
        traits.forEach(trait -> trait.peindre(g, place, place.intersection(new Rectangle(vue))));
        for (double[] anneau : anneaux) {
            double x = place.x + echelle * anneau[0];
            double y = place.y + echelle * anneau[1];
            peindreLisere(g, new Ellipse2D.Double(x - rayon, y - rayon, 2 * rayon, 2 * rayon), Color.WHITE);
            String numero = "" + (int) anneau[2];
            g.setColor(Color.BLACK);
            g.drawString(numero, (float) (x + rayon + 3), (float) (y - rayon - 1));
            g.setColor(Color.WHITE);
            g.drawString(numero, (float) (x + rayon + 2), (float) (y - rayon - 2));
        }
    }
}
