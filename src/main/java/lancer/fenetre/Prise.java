package lancer.fenetre;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Polygon;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.util.Objects;
import javax.swing.SwingUtilities;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Point;
import lancer.PointContact;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.commande.Messages;
import lancer.dessin.Dessin;
import lancer.fenetre.figures.Figure;
import lancer.scene.SceneLue;

/**
 * Ce que Maj et la souris déplacent, dans le plan parallèle à l'écran : une sphère, ou l'étoile d'une lampe. Le
 * déplacement est écrit dans le fichier de la scène quand on le demande, ou oublié quand ce fichier est relu.
 */
final class Prise extends MouseAdapter {

    private static final int RAYON_ETOILE = 9;
    private static final Shape ETOILE = new Polygon(new int[] {0, 2, 9, 2, 0, -2, -9, -2},
            new int[] {-9, -2, 0, 2, 9, 2, 0, -2}, 8);
    private static final Color LAMPE = new Color(0xFFE040);

    private final Controleur controleur;
    private final PanneauImage panneau;
    /** Au début du geste : ce qui est tiré, ou {@code null}, le point de l'image, et la scène. */
    private Object prise;
    private Point2D depart;
    private SceneLue debut;
    /** La scène pendant le geste, et la nouvelle place de ce qui est tiré. */
    private SceneLue tiree;
    private String place;
    private boolean etoiles;

    Prise(Controleur controleur) {
        this.controleur = controleur;
        panneau = controleur.panneau;
        panneau.addMouseListener(this);
        panneau.addMouseMotionListener(this);
        panneau.prises = this::peindre;
        controleur.prevenir(this::suivre);
    }

    /** Lâche ce qui est tiré si un autre geste ou une lecture a changé la scène. */
    private void suivre(Etat etat) {
        if (prise != null && etat.demande.lue != tiree) {
            prise = null;
        }
    }

    /** Ce qui est tiré, et sa nouvelle place ; {@code null} si rien n'est tiré. */
    String getGeste() {
        return prise == null ? null : place;
    }

    /** Renonce au geste : ce qui est tiré revient où il était. */
    void lacher() {
        prise = null;
        controleur.deplacer(debut);
    }

    private Dessin montre() {
        return controleur.getEtat().montre.dessin;
    }

    private Camera getCamera() {
        return montre().lancer.getCamera();
    }

    @Override
    public void mousePressed(MouseEvent e) {
        if (montre() != null && prise == null && e.isShiftDown() && SwingUtilities.isLeftMouseButton(e)) {
            // un message cacherait le bas de l'image
            panneau.bandeau.dire("");
            depart = panneau.pointDe(e);
            debut = controleur.getEtat().demande.lue;
            tiree = debut;
            try {
                prise = viser();
                place = "";
            } catch (RuntimeException panne) {
                panneau.bandeau.dire(Messages.message(panne));
            }
        }
    }

    /** La lampe ou la sphère sous la souris ; {@code null}, et un avis, si rien n'y peut être pris. */
    private Object viser() {
        Point2D souris = panneau.placeDe(depart.getX(), depart.getY());
        for (Lampe lampe : debut.lampes) {
            Point2D etoile = aLEcran(lampe.getPosition());
            if (etoile != null && etoile.distance(souris) < RAYON_ETOILE) {
                return lampe;
            }
        }
        Scene montree = montre().lancer.getScene();
        PointContact contact = montree.pourUnFil()
                .getClosestIntersection(getCamera().getRayon(depart.getX(), depart.getY()));
        // l'image montrée peut être celle d'avant le dernier déplacement, où cet objet avait une autre place
        int rang = contact == null ? -1 : montre().demande.lue.objets.indexOf(contact.objet);
        Object vise = rang < 0 ? null : debut.objets.get(rang);
        if (vise != null && vise.getClass() == Sphere.class && !estTropGrande((Sphere) vise)) {
            return vise;
        }
        panneau.bandeau.dire("rien ne se tire ici ; se tirent une sphère du fichier, moins large que l'image, et "
                + "l'étoile d'une lampe");
        return null;
    }

    /** Dit si une sphère est derrière l'œil, ou plus large que l'image : un sol, une voûte. */
    private boolean estTropGrande(Sphere sphere) {
        double pixels = getCamera().projeter(sphere.getCentre()).z;
        return !(pixels > 0) || 2 * pixels * sphere.getRayon() > getCamera().getLargeur();
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        if (prise != null) {
            Point2D ici = panneau.pointDe(e);
            Camera camera = getCamera();
            Point origine = SceneLue.place(prise);
            double pixels = camera.projeter(origine).z;
            // un pixel de l'écran, agrandi comme l'est le plan de ce qui est pris
            double fois = camera.getLargeur() / Constantes.ECHELLE / pixels;
            Point coin = camera.getEcran(0, 0);
            Vecteur droite = new Vecteur(coin, camera.getEcran(1, 0)).mul(fois * (ici.getX() - depart.getX()));
            Vecteur bas = new Vecteur(coin, camera.getEcran(0, 1)).mul(fois * (ici.getY() - depart.getY()));
            tirer(bouger(origine, droite.add(bas), pixels));
        }
    }

    /** Ce point, déplacé ; une coordonnée qui bouge est à un dixième de pixel. @param pixels ceux d'une unité */
    private static Point bouger(Point p, Vecteur v, double pixels) {
        double fois = Math.pow(10, Math.ceil(Math.log10(5 * pixels)));
        return new Point(bouger(p.x, v.x, fois), bouger(p.y, v.y, fois), bouger(p.z, v.z, fois));
    }

    private static double bouger(double x, double de, double fois) {
        // la valeur à écrire est courte, et celle que rien ne bouge reste celle du fichier
        return Math.abs(de * fois) < 0.5 ? x : Math.rint((x + de) * fois) / fois;
    }

    private void tirer(Point ou) {
        tiree = debut.avec(prise, ou);
        place = debut.getOrigine(prise) + (prise instanceof Lampe ? " : position=" : " : centre=")
                + SceneLue.ecrire(ou);
        controleur.deplacer(tiree);
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        if (prise != null && SwingUtilities.isLeftMouseButton(e)) {
            prise = null;
            if (tiree != debut) {
                panneau.bandeau.dire(place + " ; Ctrl+E l'écrit dans " + controleur.getEtat().getNom());
                controleur.retenir(debut);
            }
        }
    }

    @Override
    public void mouseMoved(MouseEvent e) {
        if (etoiles != e.isShiftDown()) {
            etoiles = e.isShiftDown();
            panneau.repaint();
        }
    }

    /** La place de ce point à l'écran ; {@code null} s'il est derrière l'œil. */
    private Point2D aLEcran(Point p) {
        Point vu = getCamera().projeter(p);
        return vu.z > 0 && vu.z < Double.POSITIVE_INFINITY ? panneau.placeDe(vu.x, vu.y) : null;
    }

    /** Avec Maj, peint l'étoile de chaque lampe qui est devant l'œil. */
    private void peindre(Graphics2D g) {
        if (montre() != null && etoiles) {
            g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            controleur.getEtat().demande.lue.lampes.stream().map(lampe -> aLEcran(lampe.getPosition()))
                    .filter(Objects::nonNull).forEach(ou -> Figure.peindreLisere(g, AffineTransform
                    .getTranslateInstance(ou.getX(), ou.getY()).createTransformedShape(ETOILE), LAMPE));
        }
    }
}
