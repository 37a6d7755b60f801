package lancer.fenetre;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import javax.swing.SwingUtilities;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.commande.Messages;
import lancer.fenetre.Bandeau.Sujet;
import lancer.scene.Deplacement;
import lancer.scene.SceneLue;

/** Déplacement, avec Maj et la souris, d'une sphère ou d'une lampe. Il se fait en mémoire, et l'image le suit. */
final class Prise extends MouseAdapter {

    /** Rapport des distances à l'œil avant et après un cran de la molette. */
    private static final double CRAN = 1.04;
    private static final int RAYON_ETOILE = 9;
    private static final int BRANCHES = 4;
    private static final Color LAMPE = new Color(0xFFE040);
    /** Temps maximal entre deux touches, ou deux crans, d'un même geste. */
    private static final long GESTE_NS = 1_000_000_000;

    private final Controleur controleur;
    private final PanneauImage panneau;
    /** Rang de la sphère ou de la lampe prise, dans sa liste ; −1 si rien n'est pris. */
    private int rang = -1;
    private boolean estLampe;
    /** Point de l'image au début du geste de la souris, et position de l'objet pris à ce moment. */
    private Point2D depart;
    private Point origine;
    private long dernierNs;
    private boolean etoiles;
    /** Le dessin qui a lu la scène de l'objet pris. */
    private Tracage lue;

    Prise(Controleur controleur, PanneauImage panneau) {
        this.controleur = controleur;
        this.panneau = panneau;
        panneau.addMouseListener(this);
        panneau.addMouseMotionListener(this);
        panneau.addMouseWheelListener(this);
        panneau.prises = this::peindre;
        controleur.prevenir(() -> {
            if (lue != controleur.etat.lecture) {
                lue = controleur.etat.lecture;
                lacher();
            }
        });
    }

    private SceneLue getLue() {
        return controleur.etat.choix.scene;
    }

    /** Déplace ce qui est pris d'autant de pixels. */
    void pousser(int dx, int dy) {
        aller(deplacee(getPosition(), dx, dy));
    }

    boolean estPris() {
        return rang >= 0;
    }

    void lacher() {
        rang = -1;
        depart = null;
        panneau.repaint();
    }

    private Object getChose() {
        return estLampe ? getLue().lampes.get(rang) : getLue().objets.get(rang);
    }

    private Point getPosition() {
        return Deplacement.position(getChose());
    }

    private Camera getCamera() {
        return controleur.etat.montre.getLancer().getCamera();
    }

    @Override
    public void mousePressed(MouseEvent e) {
        if (panneau.montree == null || controleur.etat.montre == null || !SwingUtilities.isLeftMouseButton(e)) {
            return;
        }
        lacher();
        if (e.isShiftDown() && prendre(panneau.pointDe(e))) {
            depart = panneau.pointDe(e);
            origine = getPosition();
            dernierNs = 0;
            panneau.repaint();
        }
    }

    /** Prend la lampe ou, à défaut, la sphère visible en ce point de l'image. Un avis explique un refus. */
    private boolean prendre(Point2D ou) {
        for (int k = 0; k < getLue().lampes.size(); k++) {
            Point2D etoile = etoile(getLue().lampes.get(k));
            if (etoile != null && etoile.distance(panneau.placeDe(ou.getX(), ou.getY())) < RAYON_ETOILE) {
                estLampe = true;
                rang = k;
                return true;
            }
        }
        Scene scene = controleur.etat.montre.getScene().avec(controleur.etat.montre.getScene().getModele());
        PointContact contact;
        try {
            contact = scene.getClosestIntersection(getCamera().getRayon(ou.getX(), ou.getY()));
        } catch (RuntimeException e) {
            panneau.bandeau.dire(Sujet.AVIS, Messages.message(e));
            return false;
        }
        Objet3D objet = contact == null ? null : contact.objet;
        SceneLue montree = controleur.etat.montre.getLue();
        estLampe = false;
        rang = objet == null || objet.getClass() != Sphere.class ? -1 : montree.objets.indexOf(objet);
        if (!estPris()) {
            panneau.bandeau.dire(Sujet.AVIS, objet == null ? "rien à prendre ici : aucun objet ne s'y voit"
                    : montree.origines.de(objet) + " ne se prend pas : la souris ne prend que sphères et lampes");
        }
        return estPris();
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        if (depart != null && estPris()) {
            Point2D ici = panneau.pointDe(e);
            aller(deplacee(origine, ici.getX() - depart.getX(), ici.getY() - depart.getY()));
        }
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        depart = null;
    }

    @Override
    public void mouseMoved(MouseEvent e) {
        if (etoiles != e.isShiftDown()) {
            etoiles = e.isShiftDown();
            panneau.repaint();
        }
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        if (e.isShiftDown() && estPris()) {
            Point oeil = getCamera().getOeil();
            aller(oeil.add(new Vecteur(oeil, getPosition()).mul(Math.pow(CRAN, -e.getPreciseWheelRotation()))));
        }
    }

    /** Cette position, déplacée de {@code dx} et {@code dy} pixels dans le plan parallèle à l'écran. */
    private Point deplacee(Point p, double dx, double dy) {
        double pixels = getCamera().projeter(p).z;
        return p.add(new Vecteur(dx / pixels, -dy / pixels, 0));
    }

    private void aller(Point voulue) {
        Point ou = Deplacement.arrondir(voulue, Math.abs(getCamera().projeter(voulue).z));
        Object ancienne = getChose();
        if (ou.equals(getPosition())) {
            return;
        }
        long maintenant = System.nanoTime();
        boolean suite = dernierNs != 0 && (depart != null || maintenant - dernierNs < GESTE_NS);
        dernierNs = maintenant;
        controleur.deplacer(ancienne, Deplacement.en(ancienne, ou), suite);
        panneau.repaint();
    }

    /** Position de cette lampe à l'écran ; {@code null} si elle est derrière l'œil. */
    private Point2D etoile(Lampe lampe) {
        Point vue = getCamera().projeter(lampe.getPosition());
        return vue.z > 0 && !Double.isInfinite(vue.z) ? panneau.placeDe(vue.x, vue.y) : null;
    }

    private void peindre(Graphics2D g) {
        if (panneau.montree == null || controleur.etat.montre == null || !etoiles && !estPris()) {
            return;
        }
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        for (Lampe lampe : getLue().lampes) {
            Point2D etoile = etoile(lampe);
            if (etoile != null) {
                tracer(g, etoile(etoile), LAMPE);
            }
        }
        if (estPris()) {
            Point vue = getCamera().projeter(getPosition());
            Point2D centre = panneau.placeDe(vue.x, vue.y);
            double rayon = estLampe ? 2 * RAYON_ETOILE : ((Sphere) getChose()).getRayon() * vue.z
                    * panneau.getReduction(panneau.montree);
            tracer(g, new Ellipse2D.Double(centre.getX() - rayon, centre.getY() - rayon, 2 * rayon, 2 * rayon),
                    Color.WHITE);
        }
    }

    private static void tracer(Graphics2D g, Shape forme, Color couleur) {
        g.setStroke(new BasicStroke(4));
        g.setColor(Color.BLACK);
        g.draw(forme);
        g.setStroke(new BasicStroke(2));
        g.setColor(couleur);
        g.draw(forme);
    }

    private static Shape etoile(Point2D centre) {
        Path2D etoile = new Path2D.Double();
        for (int k = 0; k < BRANCHES; k++) {
            double x = Math.cos(Math.PI * k / BRANCHES) * RAYON_ETOILE;
            double y = Math.sin(Math.PI * k / BRANCHES) * RAYON_ETOILE;
            etoile.append(new Line2D.Double(centre.getX() - x, centre.getY() - y, centre.getX() + x,
                    centre.getY() + y), false);
        }
        return etoile;
    }
}
