package lancer.fenetre;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
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
import lancer.Vecteur;
import lancer.commande.Messages;
import lancer.fenetre.Bandeau.Sujet;
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
    private static final int BRANCHES = 4;
    private static final Color LAMPE = new Color(0xFFE040);
    private static final Color FOND = new Color(0x80000000, true);
    /** Temps maximal entre deux touches, ou deux crans, d'un même geste. */
    private static final long GESTE_NS = 1_000_000_000;
    private static final String RAYON = "rayon";
    /** Nombre de rayons, par côté de l'image, qui mesurent ce que couvre un objet ; de côtés d'un contour. */
    private static final int GRILLE = 32;
    private static final int COTES = 128;
    /** Distance, en pixels, d'un point de contour qui ne se dessine plus. */
    private static final double LOIN = 1e6;

    private final Controleur controleur;
    private final PanneauImage panneau;
    private final List<Runnable> prevenus = new ArrayList<>();
    /** Rang dans le fichier de ce qui est pris, et de ce qui le serait ; −1 s'il n'y en a pas. */
    private int rang = -1;
    private int survol = -1;
    /** Raison pour laquelle rien ne peut être pris sous la souris ; vide s'il n'y en a pas. */
    private String refus = "";
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

    /** Appelle {@code siChange} quand autre chose est pris. */
    void prevenir(Runnable siChange) {
        prevenus.add(siChange);
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
        if (voulu != rang) {
            rang = voulu;
            dernierNs = 0;
            prevenus.forEach(Runnable::run);
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
        return controleur.etat.montre.getLancer().getCamera();
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
        Optional<Lampe> lampe = getLue().lampes.stream().filter(l -> etoile(l) != null
                && etoile(l).distance(panneau.placeDe(ou.getX(), ou.getY())) < RAYON_ETOILE).findFirst();
        if (lampe.isPresent()) {
            return getLue().origines.getRang(lampe.get());
        }
        try {
            Scene montree = controleur.etat.montre.getScene();
            PointContact contact = montree.avec(montree.getModele())
                    .getClosestIntersection(getCamera().getRayon(ou.getX(), ou.getY()));
            int vu = contact == null ? -1 : controleur.etat.montre.getLue().origines.getRang(contact.objet);
            String nom = contact == null ? "" : getLue().origines.getNom(vu);
            SectionLue section = contact == null ? null : getLue().origines.getSection(vu);
            refus = contact == null ? "rien à prendre ici : aucun objet ne s'y voit"
                    : Deplacement.place(section) == null
                    ? nom + " ne se prend pas : sa section n'a ni centre, ni position"
                    : estTropGrand(contact.objet, section)
                    ? nom + " couvre plus de la moitié de l'image : on la prend dans l'onglet Scène" : "";
            return refus.isEmpty() ? vu : -1;
        } catch (RuntimeException panne) {
            refus = Messages.message(panne);
            return -1;
        }
    }

    /** Dit si cet objet couvre plus de la moitié de l'image, ou contient l'œil. */
    private boolean estTropGrand(Objet3D objet, SectionLue section) {
        Camera camera = getCamera();
        long couverts = IntStream.range(0, GRILLE * GRILLE).filter(k -> objet.getIntersectionDistance(camera.getRayon(
                (k % GRILLE + 0.5) / GRILLE * camera.getLargeur(), (k / GRILLE + 0.5) / GRILLE * camera.getHauteur()))
                < Double.POSITIVE_INFINITY).count();
        return 2 * couverts > GRILLE * GRILLE || section.valeur(RAYON) != null
                && new Vecteur(camera.getOeil(), Deplacement.place(section)).norme() <= section.longueur(RAYON);
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
        panneau.rafraichir();
    }

    @Override
    public void mouseMoved(MouseEvent e) {
        boolean montrees = e.isShiftDown() && controleur.etat.montre != null;
        if (etoiles || montrees) {
            etoiles = montrees;
            refus = "";
            survol = montrees && panneau.estDessine(e) ? viser(e) : -1;
            panneau.rafraichir();
        }
    }

    @Override
    public void mouseExited(MouseEvent e) {
        etoiles = false;
        survol = -1;
        refus = "";
        panneau.rafraichir();
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
        long maintenant = System.nanoTime();
        boolean suite = dernierNs != 0 && (depart != null || maintenant - dernierNs < GESTE_NS);
        dernierNs = maintenant;
        try {
            controleur.changer(getLue().avec(rang, cle, ou), suite);
        } catch (SceneFautive e) {
            panneau.bandeau.dire(Sujet.AVIS, e.getMessage());
        }
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
        getLue().lampes.stream().map(this::etoile).filter(Objects::nonNull)
                .forEach(etoile -> tracer(g, etoile(etoile), LAMPE));
        for (int k : new int[] {rang, survol}) {
            if (k >= 0) {
                marquer(g, k);
            }
        }
    }

    /** Le contour de cette boule ou, à défaut, une étoile, au bord si elle est hors de l'image ; et son nom. */
    private void marquer(Graphics2D g, int k) {
        SectionLue section = getLue().origines.getSection(k);
        Point place = Deplacement.place(section);
        Rectangle2D libre = panneau.getCadre();
        Point2D ou = new Point2D.Double(libre.getCenterX(), libre.getMaxY());
        if (place != null) {
            Point vue = getCamera().projeter(place);
            // derrière l'œil, la projection est retournée
            double sens = vue.z > 0 ? 1 : -1e3;
            ou = panneau.placeDe(getCamera().getLargeur() / 2.0 + sens * (vue.x - getCamera().getLargeur() / 2.0),
                    getCamera().getHauteur() / 2.0 + sens * (vue.y - getCamera().getHauteur() / 2.0));
            ou.setLocation(Math.max(libre.getMinX(), Math.min(libre.getMaxX(), ou.getX())),
                    Math.max(libre.getMinY(), Math.min(libre.getMaxY(), ou.getY())));
            tracer(g, section.valeur(RAYON) == null ? etoile(ou)
                    : contour(new Vecteur(getCamera().getOeil(), place), section.longueur(RAYON)), Color.WHITE);
        }
        FontMetrics m = g.getFontMetrics();
        double x = Math.max(libre.getMinX(), Math.min(ou.getX() + RAYON_ETOILE,
                libre.getMaxX() - m.stringWidth(dire(k))));
        double y = Math.max(libre.getMinY() + 2 * m.getHeight(), ou.getY() - RAYON_ETOILE);
        g.setColor(FOND);
        g.fill(new Rectangle2D.Double(x - 2, y - m.getAscent(), m.stringWidth(dire(k)) + 4, m.getHeight()));
        g.setColor(Color.WHITE);
        g.drawString(dire(k), (float) x, (float) y);
    }

    /** Le cercle où les rayons de l'œil touchent une boule, devant l'œil. @param C son centre, vu de l'œil */
    private Shape contour(Vecteur C, double rayon) {
        Path2D contour = new Path2D.Double();
        double part = 1 - rayon * rayon / C.norme2();
        boolean suite = false;
        for (int k = 0; k <= COTES && part > 0; k++) {
            Vecteur c = C.normalized();
            Vecteur u = c.x == 0 && c.z == 0 ? new Vecteur(1, 0, 0) : new Vecteur(c.z, 0, -c.x).normalized();
            Vecteur v = new Vecteur(c.y * u.z, c.z * u.x - c.x * u.z, -c.y * u.x);
            double angle = 2 * Math.PI * k / COTES;
            double r = rayon * Math.sqrt(part);
            Point vue = getCamera().projeter(getCamera().getOeil().add(C.mul(part))
                    .add(u.mul(r * Math.cos(angle)).add(v.mul(r * Math.sin(angle)))));
            Point2D ou = panneau.placeDe(vue.x, vue.y);
            boolean devant = vue.z > 0 && ou.distance(0, 0) < LOIN;
            if (devant && suite) {
                contour.lineTo(ou.getX(), ou.getY());
            } else if (devant) {
                contour.moveTo(ou.getX(), ou.getY());
            }
            suite = devant;
        }
        return contour;
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
