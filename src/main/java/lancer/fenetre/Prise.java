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
import java.io.File;
import java.util.ArrayDeque;
import java.util.Deque;
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
import lancer.fenetre.Bandeau.Sujet;
import lancer.fenetre.figures.Figure;
import lancer.image.Ecriture;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;
import lancer.texte.Texte;

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
    private final Enregistrement disque;
    private final PanneauImage panneau;
    /** La scène telle que le fichier la donne, et avec ses déplacements. */
    private SceneLue lue;
    private SceneLue deplacee;
    /** La scène avant chaque déplacement, le dernier en tête. */
    private final Deque<SceneLue> avant = new ArrayDeque<>();
    /** Au début du geste : ce qui est tiré, ou {@code null}, le point de l'image, et la scène. */
    private Object prise;
    private Point2D depart;
    private SceneLue debut;
    private boolean etoiles;

    Prise(Controleur controleur, Enregistrement disque) {
        this.controleur = controleur;
        this.disque = disque;
        panneau = controleur.panneau;
        panneau.addMouseListener(this);
        panneau.addMouseMotionListener(this);
        panneau.prises = this::peindre;
        controleur.oubli = this::oublier;
    }

    /** Oublie tout déplacement : cette scène vient d'être lue. @return vrai si l'un d'eux n'était pas écrit */
    boolean oublier(SceneLue nouvelle) {
        boolean perdu = estDeplace();
        lue = nouvelle;
        deplacee = nouvelle;
        avant.clear();
        prise = null;
        return perdu;
    }

    boolean estDeplace() {
        return deplacee != lue;
    }

    boolean peutDefaire() {
        return !avant.isEmpty();
    }

    /** Rend sa place d'avant à ce qui a été déplacé en dernier. */
    void defaire() {
        deplacee = avant.pop();
        dire("");
        controleur.deplacer(deplacee);
    }

    /** Écrit les déplacements dans le fichier de la scène ; la surveillance le relit ensuite. */
    void ecrire() {
        SceneLue celle = lue;
        SceneLue voulue = deplacee;
        String fichier = controleur.demande.lue.nom;
        disque.confier(() -> new Ecriture<SceneLue>(LecteurScene.trouver(fichier).toString(),
                (scene, sortie) -> sortie.write(celle.deplacer(scene))).ecrire(voulue),
                () -> {
                    // une autre scène a pu être lue depuis
                    if (lue == celle) {
                        lue = voulue;
                        avant.clear();
                        controleur.avertir();
                    }
                    return "écrit dans " + Texte.echappe(new File(fichier).getName());
                });
    }

    private Camera getCamera() {
        return controleur.montre.lancer.getCamera();
    }

    @Override
    public void mousePressed(MouseEvent e) {
        if (controleur.montre != null && e.isShiftDown() && SwingUtilities.isLeftMouseButton(e)) {
            depart = panneau.pointDe(e);
            debut = deplacee;
            try {
                prise = viser();
            } catch (RuntimeException panne) {
                dire(Messages.message(panne));
            }
        }
    }

    /** La lampe ou la sphère sous la souris ; {@code null}, et un avis, si rien n'y peut être pris. */
    private Object viser() {
        Point2D souris = panneau.placeDe(depart.getX(), depart.getY());
        for (Lampe lampe : deplacee.lampes) {
            Point2D etoile = aLEcran(lampe.getPosition());
            if (etoile != null && etoile.distance(souris) < RAYON_ETOILE) {
                return lampe;
            }
        }
        Scene montree = controleur.montre.lancer.getScene();
        PointContact contact = montree.avec(montree.getModele())
                .getClosestIntersection(getCamera().getRayon(depart.getX(), depart.getY()));
        if (contact != null && contact.objet.getClass() == Sphere.class && !estTropGrande((Sphere) contact.objet)
                && deplacee.getOrigine(contact.objet) != null) {
            return contact.objet;
        }
        dire("rien ne se tire ici ; se tirent une sphère du fichier, moins large que l'image, et l'étoile d'une lampe");
        return null;
    }

    /** Dit si une sphère est derrière l'œil, ou plus large que l'image : un sol, une voûte. */
    private boolean estTropGrande(Sphere sphere) {
        double pixels = getCamera().projeter(sphere.getCentre()).z;
        return !(pixels > 0) || 2 * pixels * sphere.getRayon() > getCamera().getLargeur();
    }

    private void dire(String texte) {
        panneau.bandeau.dire(Sujet.AVIS, texte);
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
            tirer(arrondir(origine.add(droite).add(bas), pixels));
        }
    }

    /** Ce point, à un dixième de pixel : la valeur à écrire est courte. @param pixels nombre de pixels d'une unité */
    private static Point arrondir(Point p, double pixels) {
        double fois = Math.pow(10, Math.ceil(Math.log10(5 * pixels)));
        return new Point(Math.rint(p.x * fois) / fois, Math.rint(p.y * fois) / fois, Math.rint(p.z * fois) / fois);
    }

    private void tirer(Point ou) {
        deplacee = debut.avec(prise, ou);
        dire(debut.getOrigine(prise) + (prise instanceof Lampe ? " : position=" : " : centre=")
                + SceneLue.ecrire(ou) + " ; Ctrl+E l'écrit dans la scène");
        controleur.deplacer(deplacee);
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        if (prise != null && deplacee != debut) {
            avant.push(debut);
            controleur.avertir();
        }
        prise = null;
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
        if (controleur.montre != null && etoiles) {
            g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            deplacee.lampes.stream().map(lampe -> aLEcran(lampe.getPosition())).filter(Objects::nonNull)
                    .forEach(ou -> Figure.peindreLisere(g, AffineTransform.getTranslateInstance(ou.getX(), ou.getY())
                            .createTransformedShape(ETOILE), LAMPE));
        }
    }
}
