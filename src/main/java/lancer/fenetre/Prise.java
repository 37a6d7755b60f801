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
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.AbstractMap.SimpleEntry;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;
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
import lancer.scene.SceneLue;
import lancer.texte.Nombre;

/**
 * Ce que Maj et la souris déplacent, dans le plan parallèle à l'écran : une sphère, ou l'étoile d'une lampe. Le
 * déplacement est écrit dans le fichier de la scène quand on le demande, ou oublié quand ce fichier est relu.
 */
final class Prise extends MouseAdapter {

    private static final int RAYON_ETOILE = 9;
    private static final Shape ETOILE = new Polygon(new int[] {0, 2, 9, 2, 0, -2, -9, -2},
            new int[] {-9, -2, 0, 2, 9, 2, 0, -2}, 8);
    private static final Color LAMPE = new Color(0xFFE040);
    /** Écart permis entre la position voulue et la position écrite, en pixels. */
    private static final double ECART = 0.1;

    private final Controleur controleur;
    private final PanneauImage panneau;
    /** La scène telle que le fichier la donne, et la place de ce qui y est déplacé. */
    private SceneLue lue;
    private Map<Object, Point> places = new IdentityHashMap<>();
    /** Chaque déplacement, le dernier en tête : ce qui a bougé, et sa place d'avant. */
    private final Deque<Map.Entry<Object, Point>> faits = new ArrayDeque<>();
    /** Ce qui est tiré, tel que le fichier le donne ; sa place, et le point de l'image, au début du geste. */
    private Object prise;
    private Point origine;
    private Point2D depart;
    private boolean etoiles;

    Prise(Controleur controleur, PanneauImage panneau) {
        this.controleur = controleur;
        this.panneau = panneau;
        panneau.addMouseListener(this);
        panneau.addMouseMotionListener(this);
        panneau.prises = this::peindre;
    }

    /** Oublie tout déplacement : cette scène vient d'être lue. @return vrai si l'un d'eux n'était pas écrit */
    boolean oublier(SceneLue nouvelle) {
        boolean perdu = estDeplace();
        lue = nouvelle;
        places = new IdentityHashMap<>();
        faits.clear();
        prise = null;
        return perdu;
    }

    boolean estDeplace() {
        return !places.isEmpty();
    }

    /** La valeur à écrire dans la section de chaque chose déplacée. */
    Map<Object, String> getValeurs() {
        Map<Object, String> valeurs = new IdentityHashMap<>();
        places.forEach((chose, ou) -> valeurs.put(chose, ecrire(ou)));
        return valeurs;
    }

    SceneLue getLue() {
        return lue;
    }

    boolean peutDefaire() {
        return !faits.isEmpty();
    }

    /** Rend sa place d'avant à ce qui a été déplacé en dernier. */
    void defaire() {
        Map.Entry<Object, Point> dernier = faits.pop();
        placer(dernier.getKey(), dernier.getValue());
    }

    private static Point place(Object chose) {
        return chose instanceof Lampe ? ((Lampe) chose).getPosition() : ((Sphere) chose).getCentre();
    }

    private Point getPlace(Object chose) {
        return places.getOrDefault(chose, place(chose));
    }

    private Camera getCamera() {
        return controleur.montre.lancer.getCamera();
    }

    @Override
    public void mousePressed(MouseEvent e) {
        if (controleur.montre != null && e.isShiftDown() && SwingUtilities.isLeftMouseButton(e)) {
            depart = panneau.pointDe(e);
            try {
                prise = viser();
            } catch (RuntimeException panne) {
                dire(Messages.message(panne));
            }
            origine = prise == null ? null : getPlace(prise);
        }
    }

    /** La lampe ou la sphère sous la souris ; {@code null}, et un avis, si rien n'y peut être pris. */
    private Object viser() {
        Point2D souris = panneau.placeDe(depart.getX(), depart.getY());
        Optional<Lampe> lampe = lue.lampes.stream().filter(l -> aLEcran(getPlace(l)) != null
                && aLEcran(getPlace(l)).distance(souris) < RAYON_ETOILE).findFirst();
        if (lampe.isPresent()) {
            return lampe.get();
        }
        Scene montree = controleur.montre.lancer.getScene();
        PointContact contact = montree.avec(montree.getModele())
                .getClosestIntersection(getCamera().getRayon(depart.getX(), depart.getY()));
        int rang = contact == null ? -1 : controleur.demande.lecture.lue.objets.indexOf(contact.objet);
        if (rang < 0) {
            dire("rien à prendre ici : aucun objet du fichier ne s'y voit");
            return null;
        }
        Object vu = lue.objets.get(rang);
        String faute = vu.getClass() != Sphere.class ? " n'est pas une sphère : elle se déplace dans le fichier"
                : estTropGrande((Sphere) contact.objet) ? " dépasse l'image : elle se déplace dans le fichier" : "";
        if (!faute.isEmpty()) {
            dire(lue.origines.de(vu) + faute);
        }
        return faute.isEmpty() ? vu : null;
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
            // un pixel de l'écran, agrandi comme l'est le plan de ce qui est pris
            double fois = camera.getLargeur() / Constantes.ECHELLE / camera.projeter(origine).z;
            Point coin = camera.getEcran(0, 0);
            Point voulue = origine
                    .add(new Vecteur(coin, camera.getEcran(1, 0)).mul(fois * (ici.getX() - depart.getX())))
                    .add(new Vecteur(coin, camera.getEcran(0, 1)).mul(fois * (ici.getY() - depart.getY())));
            placer(prise, arrondie(voulue, camera.projeter(origine).z));
        }
    }

    /** Ce point, écrit avec le moins de chiffres possible. @param pixels nombre de pixels d'une unité */
    private static Point arrondie(Point p, double pixels) {
        int decimales = (int) Math.ceil(Math.log10(pixels / (2 * ECART)));
        return new Point(arrondi(p.x, decimales), arrondi(p.y, decimales), arrondi(p.z, decimales));
    }

    private static double arrondi(double x, int decimales) {
        return new BigDecimal(x).setScale(decimales, RoundingMode.HALF_EVEN).doubleValue();
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        if (prise != null && !getPlace(prise).equals(origine)) {
            faits.push(new SimpleEntry<>(prise, origine));
            controleur.avertir();
        }
        prise = null;
        panneau.repaint();
    }

    /** Dessine la scène où cette chose a cette place. */
    private void placer(Object chose, Point ou) {
        if (ou.equals(getPlace(chose))) {
            return;
        }
        if (ou.equals(place(chose))) {
            places.remove(chose);
        } else {
            places.put(chose, ou);
        }
        Map<Object, Object> deplacees = new IdentityHashMap<>();
        places.forEach((celle, la) -> deplacees.put(celle, deplacer(celle, la)));
        controleur.deplacer(lue.remplacer(deplacees));
        dire(lue.origines.de(chose) + " : " + (chose instanceof Lampe ? "position=" : "centre=") + ecrire(ou)
                + (estDeplace() ? " ; Ctrl+E l'écrit dans la scène" : ""));
    }

    private static Object deplacer(Object chose, Point ou) {
        if (chose instanceof Lampe) {
            return new Lampe(ou, ((Lampe) chose).getCouleur());
        }
        Sphere sphere = (Sphere) chose;
        Sphere deplacee = new Sphere(ou, sphere.getRayon());
        deplacee.setKd(sphere.getKd());
        deplacee.setKs(sphere.getKs());
        deplacee.setNs(sphere.getNs());
        return deplacee;
    }

    private static String ecrire(Point p) {
        return Nombre.ecrire(p.x) + " " + Nombre.ecrire(p.y) + " " + Nombre.ecrire(p.z);
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

    /** Peint l'étoile de chaque lampe. */
    private void peindre(Graphics2D g) {
        if (controleur.montre == null || panneau.montree == null || !etoiles && prise == null) {
            return;
        }
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        for (Lampe lampe : lue.lampes) {
            Point2D ou = aLEcran(getPlace(lampe));
            if (ou != null) {
                Figure.peindreLisere(g, AffineTransform.getTranslateInstance(ou.getX(), ou.getY())
                        .createTransformedShape(ETOILE), LAMPE);
            }
        }
    }
}
