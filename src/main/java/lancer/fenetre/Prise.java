package lancer.fenetre;

import java.awt.Graphics2D;
import java.awt.Polygon;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.util.ArrayDeque;
import java.util.Deque;
import javax.swing.SwingUtilities;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.PointContact;
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

    private final Controleur controleur;
    private final PanneauImage panneau;
    /** Au début du geste, ce qui est tiré, ou {@code null}, et le point de l'image. */
    private Object prise;
    private Point2D depart;
    /** La scène, à jour du geste, et la nouvelle place de ce qui est tiré. */
    private SceneLue scene;
    private String place;
    /** La scène avant chaque déplacement, en tête celle d'avant le dernier ou le geste. */
    private final Deque<SceneLue> avant = new ArrayDeque<>();
    private boolean etoiles;

    Prise(Controleur controleur) {
        this.controleur = controleur;
        panneau = controleur.panneau;
        panneau.addMouseListener(this);
        panneau.addMouseMotionListener(this);
        panneau.prises = this::peindre;
        controleur.prevenir(this::suivre);
    }

    /** D'une scène qui vient d'être lue, rien n'est tiré, ni à défaire. */
    private void suivre(Etat etat) {
        if (etat.demande != null && etat.demande.lue != scene) {
            scene = etat.demande.lue;
            prise = null;
            avant.clear();
        }
    }

    private void deplacer(SceneLue deplacee) {
        scene = deplacee;
        controleur.deplacer(deplacee);
    }

    boolean peutDefaire() {
        return !avant.isEmpty();
    }

    /** Rend sa place d'avant à ce qui est tiré ou, à défaut, a été déplacé en dernier. */
    void defaire() {
        prise = null;
        panneau.bandeau.dire("");
        deplacer(avant.pop());
    }

    /** Ce qui est tiré, et sa nouvelle place ; {@code null} si rien n'est tiré. */
    String getGeste() {
        return prise == null ? null : place;
    }

    private Dessin montre() {
        return controleur.getEtat().montre.dessin;
    }

    @Override
    public void mousePressed(MouseEvent e) {
        if (montre() != null && prise == null && e.isShiftDown() && SwingUtilities.isLeftMouseButton(e)) {
            // un message cacherait le bas de l'image
            panneau.bandeau.dire("");
            depart = panneau.pointDe(e.getPoint());
            try {
                prise = viser();
                place = "";
                if (prise != null) {
                    avant.push(scene);
                }
            } catch (RuntimeException panne) {
                panneau.bandeau.dire(Messages.message(panne));
            }
        }
    }

    /** La lampe ou la sphère sous la souris ; {@code null}, et un avis, si rien n'y peut être pris. */
    private Object viser() {
        Point2D souris = panneau.placeDe(depart.getX(), depart.getY());
        for (Lampe lampe : scene.lampes) {
            Point2D etoile = aLEcran(lampe);
            if (etoile != null && etoile.distance(souris) < RAYON_ETOILE) {
                return lampe;
            }
        }
        Lancer lancer = montre().lancer;
        PointContact contact = lancer.getScene().pourUnFil()
                .getClosestIntersection(lancer.getCamera().getRayon(depart.getX(), depart.getY()));
        // l'image montrée peut être celle d'avant le dernier déplacement, où cet objet avait une autre place
        int rang = contact == null ? -1 : montre().demande.lue.objets.indexOf(contact.objet);
        if (rang >= 0 && scene.objets.get(rang).getClass() == Sphere.class) {
            Sphere sphere = (Sphere) scene.objets.get(rang);
            double pixels = Figure.projeter(lancer.getCamera(), sphere.getCentre()).z;
            // plus large que l'image, ou autour de l'œil, c'est un sol ou une voûte
            if (pixels > 0 && 2 * pixels * sphere.getRayon() <= lancer.getCamera().getLargeur()) {
                return sphere;
            }
        }
        panneau.bandeau.dire("rien ne se tire ici ; se tirent une sphère du fichier, moins large que l'image, et "
                + "l'étoile d'une lampe");
        return null;
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        if (prise != null) {
            Point2D ici = panneau.pointDe(e.getPoint());
            Camera camera = montre().lancer.getCamera();
            Point origine = SceneLue.place(prise);
            double pixels = Figure.projeter(camera, origine).z;
            // ce que la souris parcourt à l'écran, agrandi comme l'est le plan de ce qui est pris
            Vecteur de = new Vecteur(camera.getEcran(depart.getX(), depart.getY()),
                    camera.getEcran(ici.getX(), ici.getY())).mul(camera.getLargeur() / Constantes.ECHELLE / pixels);
            // à un dixième de pixel : la valeur à écrire est courte
            double fois = Math.pow(10, Math.ceil(Math.log10(5 * pixels)));
            Point ou = new Point(bouger(origine.x, de.x, fois), bouger(origine.y, de.y, fois),
                    bouger(origine.z, de.z, fois));
            place = avant.peek().getOrigine(prise) + (prise instanceof Lampe ? " : position=" : " : centre=")
                    + SceneLue.ecrire(ou);
            deplacer(avant.peek().avec(prise, ou));
        }
    }

    private static double bouger(double x, double de, double fois) {
        // la coordonnée que rien ne bouge reste celle du fichier
        return Math.abs(de * fois) < 0.5 ? x : Math.rint((x + de) * fois) / fois;
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        if (prise != null && SwingUtilities.isLeftMouseButton(e)) {
            prise = null;
            if (scene == avant.peek()) {
                avant.pop();
            } else {
                panneau.bandeau.dire(place + " ; Ctrl+E l'écrit dans " + controleur.getEtat().getNom());
                controleur.avertir();
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

    /** La place de cette lampe dans le panneau ; {@code null} si elle est derrière l'œil. */
    private Point2D aLEcran(Lampe lampe) {
        Point vu = Figure.projeter(montre().lancer.getCamera(), lampe.getPosition());
        return vu.z > 0 && vu.z < Double.POSITIVE_INFINITY ? panneau.placeDe(vu.x, vu.y) : null;
    }

    /** Avec Maj, peint l'étoile de chaque lampe qui est devant l'œil. */
    private void peindre(Graphics2D g) {
        if (etoiles) {
            g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            for (Lampe lampe : scene.lampes) {
                Point2D ou = aLEcran(lampe);
                Figure.tracer(g, ou == null ? null : AffineTransform.getTranslateInstance(ou.getX(), ou.getY())
                        .createTransformedShape(ETOILE), Figure.LAMPE);
            }
        }
    }
}
