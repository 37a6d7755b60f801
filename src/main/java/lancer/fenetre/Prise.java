package lancer.fenetre;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Polygon;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Point2D;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.SwingUtilities;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.commande.Messages;
import lancer.fenetre.Bandeau.Sujet;
import lancer.fenetre.figures.Figure;
import lancer.scene.Deplacement;
import lancer.scene.SceneLue;
import lancer.scene.SectionLue;

/**
 * Ce qui est pris, dans l'image par Maj et la souris, ou dans l'onglet Scène. Son déplacement se fait en mémoire, et
 * l'image le suit.
 */
final class Prise extends MouseAdapter {

    /** Rapport des distances à l'œil avant et après un cran de la molette. */
    private static final double CRAN = 1.04;
    private static final int RAYON_ETOILE = 9;
    private static final Shape ETOILE = new Polygon(new int[] {0, 2, 9, 2, 0, -2, -9, -2},
            new int[] {-9, -2, 0, 2, 9, 2, 0, -2}, 8);
    private static final Color LAMPE = new Color(0xFFE040);
    /** Nombre de rayons, par côté de l'image, qui mesurent ce que couvre un objet. */
    private static final int GRILLE = 32;

    private final Controleur controleur;
    private final PanneauImage panneau;
    /** Appelé quand autre chose est pris. */
    Runnable siAutre = () -> { };
    /** Rang dans le fichier de ce qui est pris, et de ce qui le serait ; −1 s'il n'y en a pas. */
    private int rang = -1;
    private int survol = -1;
    /** Raison pour laquelle rien ne peut être pris sous la souris ; vide s'il n'y en a pas. */
    private String refus = "";
    /** Point de l'image au début du geste de la souris, et position de l'objet pris à ce moment. */
    private Point2D depart;
    private Point origine;
    private Object geste;
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

    /** Dit si ce qui est pris a une place, et peut donc être déplacé. */
    boolean estMobile() {
        return estPris() && getPosition() != null;
    }

    boolean estPris() {
        return rang >= 0;
    }

    int getRang() {
        return rang;
    }

    /** Prend ce qui a ce rang dans le fichier, visible ou non ; −1 pour ne rien prendre. */
    void prendre(int voulu) {
        depart = null;
        survol = -1;
        geste = new Object();
        if (voulu != rang) {
            rang = voulu;
            siAutre.run();
        }
        panneau.repaint();
    }

    void lacher() {
        prendre(-1);
    }

    private Point getPosition() {
        return Deplacement.place(getLue().origines.getSection(rang));
    }

    private Camera getCamera() {
        return controleur.etat.montre.lancer.getCamera();
    }

    /** Ce qui est tiré ou, avec Maj, ce qu'un bouton de la souris prendrait ; vide si la souris ne fait rien. */
    String dire() {
        return depart != null ? dire(rang) : survol >= 0 ? dire(survol) : refus;
    }

    private String dire(int k) {
        SectionLue section = getLue().origines.getSection(k);
        String cle = Deplacement.cle(section);
        return getLue().origines.getNom(k) + (cle == null ? "" : " " + cle + "=" + section.valeur(cle));
    }

    @Override
    public void mousePressed(MouseEvent e) {
        if (controleur.etat.montre != null && SwingUtilities.isLeftMouseButton(e)) {
            prendre(e.isShiftDown() ? viser(e) : -1);
            if (estPris()) {
                depart = panneau.pointDe(e);
                origine = getPosition();
            } else if (!refus.isEmpty()) {
                panneau.bandeau.dire(Sujet.AVIS, refus);
            }
        }
    }

    /** Le rang de ce qui peut être pris sous la souris ; −1 si {@code refus} dit pourquoi rien ne peut l'être. */
    private int viser(MouseEvent e) {
        Point2D ou = panneau.pointDe(e);
        refus = "";
        Point2D souris = panneau.placeDe(ou.getX(), ou.getY());
        Optional<Lampe> lampe = getLue().lampes.stream().filter(l -> aLEcran(l.getPosition()) != null
                && aLEcran(l.getPosition()).distance(souris) < RAYON_ETOILE).findFirst();
        if (lampe.isPresent()) {
            return getLue().origines.getRang(lampe.get());
        }
        try {
            Scene montree = controleur.etat.montre.lancer.getScene();
            PointContact contact = montree.avec(montree.getModele())
                    .getClosestIntersection(getCamera().getRayon(ou.getX(), ou.getY()));
            int vu = contact == null ? -1 : controleur.etat.montre.demande.lecture.lue.origines.getRang(contact.objet);
            if (vu < 0) {
                refus = "rien à prendre ici : aucun objet du fichier ne s'y voit";
                return -1;
            }
            String nom = getLue().origines.getNom(vu);
            refus = Deplacement.place(getLue().origines.getSection(vu)) == null
                    ? nom + " ne se prend pas : sa section n'a ni centre, ni position"
                    : !estTropGrand(contact.objet) ? ""
                    : nom + " couvre plus de la moitié de l'image : on la prend dans l'onglet Scène";
            return refus.isEmpty() ? vu : -1;
        } catch (RuntimeException panne) {
            refus = Messages.message(panne);
            return -1;
        }
    }

    /** Dit si cet objet couvre plus de la moitié de l'image, ou si c'est une boule qui contient l'œil. */
    private boolean estTropGrand(Objet3D objet) {
        Camera camera = getCamera();
        long couverts = IntStream.range(0, GRILLE * GRILLE).filter(k -> objet.getIntersectionDistance(camera.getRayon(
                (k % GRILLE + 0.5) / GRILLE * camera.getLargeur(), (k / GRILLE + 0.5) / GRILLE * camera.getHauteur()))
                < Double.POSITIVE_INFINITY).count();
        return 2 * couverts > GRILLE * GRILLE || objet instanceof Sphere
                && new Vecteur(camera.getOeil(), ((Sphere) objet).getCentre()).norme() <= ((Sphere) objet).getRayon();
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        if (depart != null) {
            Point2D ici = panneau.pointDe(e);
            aller(deplacee(origine, ici.getX() - depart.getX(), ici.getY() - depart.getY()));
        }
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        depart = null;
        panneau.rafraichir();
    }

    @Override
    public void mouseMoved(MouseEvent e) {
        boolean montrees = e.isShiftDown() && controleur.etat.montre != null && e.getID() != MouseEvent.MOUSE_EXITED;
        if (etoiles || montrees) {
            etoiles = montrees;
            refus = "";
            survol = montrees && panneau.getPixelSouris(panneau.montree) != null ? viser(e) : -1;
            panneau.rafraichir();
        }
    }

    @Override
    public void mouseExited(MouseEvent e) {
        mouseMoved(e);
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        if (e.isShiftDown() && estMobile()) {
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
        String ou = Deplacement.ecrire(voulue, Math.abs(getCamera().projeter(voulue).z));
        SectionLue section = getLue().origines.getSection(rang);
        String cle = Deplacement.cle(section);
        if (ou.equals(section.valeur(cle))) {
            return;
        }
        try {
            controleur.choisir(controleur.etat.choix.avec(getLue().avec(rang, cle, ou)), geste, depart != null);
        } catch (SceneFautive e) {
            panneau.bandeau.dire(Sujet.AVIS, e.getMessage());
        }
        panneau.repaint();
    }

    /** La place de ce point à l'écran ; {@code null} s'il est derrière l'œil ou n'existe pas. */
    private Point2D aLEcran(Point p) {
        Point vu = p == null ? null : getCamera().projeter(p);
        return vu == null || vu.z <= 0 || Double.isInfinite(vu.z) ? null : panneau.placeDe(vu.x, vu.y);
    }

    private void peindre(Graphics2D g) {
        if (panneau.montree == null || controleur.etat.montre == null || !etoiles && !estPris()) {
            return;
        }
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        getLue().lampes.stream().map(lampe -> aLEcran(lampe.getPosition())).filter(Objects::nonNull)
                .forEach(ou -> Figure.peindreLisere(g, AffineTransform.getTranslateInstance(ou.getX(), ou.getY())
                .createTransformedShape(ETOILE), LAMPE));
        entourer(g, survol);
        if (estPris()) {
            entourer(g, rang);
            Point2D ou = aLEcran(getPosition());
            panneau.ecrire(g, dire(rang) + (ou != null && panneau.getCadre().contains(ou) ? "" : " (hors de l'image)"));
        }
    }

    /** Entoure ce qui a ce rang. Le cercle d'une boule a son centre et son rayon. */
    private void entourer(Graphics2D g, int k) {
        Point place = k < 0 ? null : Deplacement.place(getLue().origines.getSection(k));
        Point2D ou = aLEcran(place);
        if (ou != null) {
            Object chose = getLue().origines.getChose(k);
            double r = !(chose instanceof Sphere) ? 2 * RAYON_ETOILE : ((Sphere) chose).getRayon()
                    * getCamera().projeter(place).z * panneau.getReduction(panneau.montree);
            Figure.peindreLisere(g, new Ellipse2D.Double(ou.getX() - r, ou.getY() - r, 2 * r, 2 * r), Color.WHITE);
        }
    }
}
