package lancer.fenetre.figures;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import javax.swing.JPanel;
import lancer.Camera;
import lancer.Constantes;
import lancer.Point;
import lancer.PointContact;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.inspection.Eclairage;
import lancer.inspection.Etape;
import lancer.inspection.Inspection;

/** La figure du cours : l'œil, l'écran, les sphères rencontrées et les rayons, vus de côté (z à droite, y en haut). */
public final class VueDeCote extends JPanel {

    private static final long serialVersionUID = 1;

    private static final int HAUTEUR = 180;
    private static final int MARGE = 14;
    private static final int SEGMENTS = 256;
    private static final Color RAYON = new Color(0x0070C0);
    private static final Color SPHERE = new Color(0x909090);
    private static final Color LAMPE = new Color(0xC08000);

    private transient Inspection pixel;
    private double echelle;
    private double y0;

    public VueDeCote() {
        setName("cote");
        setPreferredSize(new Dimension(HAUTEUR, HAUTEUR));
        getAccessibleContext().setAccessibleName("vue de côté des rayons");
        setToolTipText("vue de côté : z vers la droite, y vers le haut");
    }

    public void montrer(Inspection nouvelle) {
        pixel = nouvelle;
        repaint();
    }

    @Override
    protected void paintComponent(Graphics g) {
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, getWidth(), getHeight());
        if (pixel != null) {
            Graphics2D g2 = (Graphics2D) g.create();
            g2.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            cadrer();
            peindre(g2);
            g2.dispose();
        }
    }

    /** Prend une échelle où l'œil, l'écran et les contacts tiennent. */
    private void cadrer() {
        double demi = demiEcran();
        double zMax = 0;
        double yMin = -demi;
        double yMax = demi;
        for (Etape etape : pixel.getEtapes()) {
            if (etape.contact != null) {
                zMax = Math.max(zMax, etape.contact.z);
                yMin = Math.min(yMin, etape.contact.y);
                yMax = Math.max(yMax, etape.contact.y);
            }
        }
        // de quoi voir le bord de ce qui est touché
        double marge = 1 + zMax / 10;
        echelle = Math.min((getWidth() - 2 * MARGE) / (zMax + marge + Camera.FOCALE),
                (getHeight() - 2 * MARGE) / (yMax - yMin + 2 * marge));
        y0 = (yMin + yMax) / 2;
    }

    private double demiEcran() {
        return Constantes.ECHELLE / 2 * pixel.camera.getHauteur() / pixel.camera.getLargeur();
    }

    private Line2D ligne(Point a, Point b) {
        return new Line2D.Double(h(a.z), v(a.y), h(b.z), v(b.y));
    }

    double h(double z) {
        return MARGE + (z + Camera.FOCALE) * echelle;
    }

    double v(double y) {
        return getHeight() / 2.0 - (y - y0) * echelle;
    }

    private void peindre(Graphics2D g) {
        g.setColor(Color.BLACK);
        g.draw(new Line2D.Double(h(0), v(-demiEcran()), h(0), v(demiEcran())));
        g.fill(new Ellipse2D.Double(h(-Camera.FOCALE) - 3, v(0) - 3, 6, 6));
        g.drawString("œil", (float) h(-Camera.FOCALE), (float) v(0) - 6);
        Point depart = Camera.OEIL;
        Vecteur V = pixel.getChoisi() == null ? null
                : pixel.camera.getRayon(pixel.getChoisi().xe, pixel.getChoisi().ye).getV();
        for (Etape etape : pixel.getEtapes()) {
            Point bout = etape.contact == null ? depart.add(getWidth() / echelle, V) : etape.contact;
            entourer(g, etape.contact);
            for (Eclairage lampe : etape.lampes) {
                entourer(g, lampe.getCache());
                if (lampe.eclaire()) {
                    g.setColor(LAMPE);
                    g.draw(ligne(bout, lampe.lampe.getPosition()));
                }
            }
            g.setColor(RAYON);
            g.draw(ligne(depart, bout));
            if (etape.contact != null) {
                g.drawString(String.valueOf(etape.numero), (float) h(bout.z) + 4, (float) v(bout.y) - 4);
            }
            depart = bout;
            V = etape.getReflechi();
        }
    }

    private void entourer(Graphics2D g, PointContact contact) {
        if (contact != null && contact.objet instanceof Sphere) {
            Sphere s = (Sphere) contact.objet;
            g.setColor(SPHERE);
            g.draw(arc(h(s.getCentre().z), v(s.getCentre().y), s.getRayon() * echelle));
        }
    }

    /**
     * Le bord d'un disque, entier ou là où il est en vue, en segments qui s'en écartent de moins d'un vingtième de
     * pixel : l'ellipse de Java s'écarte du sien d'un 3700e de son rayon.
     */
    private Path2D arc(double x, double y, double r) {
        double diagonale = Math.hypot(getWidth(), getHeight());
        double milieu = Math.atan2(getHeight() / 2.0 - y, getWidth() / 2.0 - x);
        double demi = Math.min(Math.PI, 2 * diagonale / r);
        Path2D arc = new Path2D.Double();
        for (int k = -SEGMENTS; k <= SEGMENTS; k++) {
            double angle = milieu + demi * k / SEGMENTS;
            double px = x + r * Math.cos(angle);
            double py = y + r * Math.sin(angle);
            if (k == -SEGMENTS) {
                arc.moveTo(px, py);
            } else {
                arc.lineTo(px, py);
            }
        }
        return arc;
    }
}
