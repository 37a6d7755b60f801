package lancer.fenetre.figures;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Graphics;
import java.awt.RenderingHints;
import java.awt.Stroke;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.IntConsumer;
import java.util.stream.Collectors;
import javax.swing.JPanel;
import javax.swing.UIManager;
import lancer.Point;
import lancer.PointContact;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Ecoute.Segment;
import lancer.contrat.Ecoute.Terme;
import lancer.inspection.Inspection;

/** La figure du cours, vue de côté : l'œil, l'écran, les sphères et les rayons (z à droite, y en haut). */
@SuppressWarnings("serial")
public final class VueDeCote extends JPanel {

    private static final int MARGE = 14;
    private static final Color RAYON = new Color(0x2A90D8);
    private static final Color SPHERE = new Color(0x909090);
    private static final Color LAMPE = new Color(0xC08000);

    private Inspection pixel;
    private int seul;
    /** Position du numéro de chaque contact. */
    private final Map<Integer, Rectangle2D> numeros = new LinkedHashMap<>();
    private double echelle;
    private double y0;
    private double z0;

    /** @param siChoisi reçoit le numéro du rebond sur lequel on clique */
    public VueDeCote(IntConsumer siChoisi) {
        setName("cote");
        getAccessibleContext().setAccessibleName("vue de côté des rayons");
        setToolTipText("vue de côté : z vers la droite, y vers le haut ; un clic sur un numéro en fait le seul");
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                numeros.entrySet().stream().filter(n -> n.getValue().contains(e.getPoint())).findFirst()
                        .ifPresent(n -> siChoisi.accept(n.getKey()));
            }
        });
    }

    /** @param nouveauSeul le numéro du seul rebond à montrer de près ; 0 pour tous */
    public void montrer(Inspection nouvelle, int nouveauSeul) {
        seul = nouveauSeul;
        pixel = nouvelle;
        repaint();
    }

    @Override
    protected void paintComponent(Graphics g) {
        g.setColor(UIManager.getColor("Tree.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        if (pixel != null) {
            ((Graphics2D) g).setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            cadrer();
            peindre((Graphics2D) g);
        }
    }

    /** Choisit l'échelle qui contient l'œil, l'écran et les contacts, ou le rebond choisi et un contact voisin. */
    private void cadrer() {
        List<Point> vus = pixel.getSegments().stream().map(segment -> segment.contact).filter(Objects::nonNull)
                .collect(Collectors.toCollection(ArrayList::new));
        vus.add(0, pixel.camera.getEcran(0, 0));
        int rang = Math.min(seul, vus.size() - 1);
        if (rang == 0) {
            vus.add(pixel.camera.getEcran(0, pixel.camera.getHauteur()));
            vus.add(pixel.camera.getOeil());
        } else {
            Point ici = vus.get(rang);
            vus = vus.subList(rang - 1, Math.min(rang + 2, vus.size()));
            vus.sort(Comparator.comparingDouble(p -> new Vecteur(ici, p).norme()));
            vus = vus.subList(0, 2);
        }
        DoubleSummaryStatistics z = vus.stream().mapToDouble(p -> p.z).summaryStatistics();
        DoubleSummaryStatistics y = vus.stream().mapToDouble(p -> p.y).summaryStatistics();
        // la marge laisse voir le bord des objets touchés
        double marge = rang == 0 ? 1 + z.getMax() / 10
                : 0.2 * Math.max(z.getMax() - z.getMin(), y.getMax() - y.getMin()) + 0.01;
        z0 = rang == 0 ? z.getMin() : z.getMin() - marge;
        y0 = (y.getMin() + y.getMax()) / 2;
        echelle = Math.min((getWidth() - 2 * MARGE) / (z.getMax() + marge - z0),
                (getHeight() - 2 * MARGE) / (y.getMax() - y.getMin() + 2 * marge));
        if (rang > 0) {
            z0 = (z.getMin() + z.getMax()) / 2 - (getWidth() / 2.0 - MARGE) / echelle;
        }
    }

    private Line2D ligne(Point a, Point b) {
        return new Line2D.Double(h(a.z), v(a.y), h(b.z), v(b.y));
    }

    double h(double z) {
        return MARGE + (z - z0) * echelle;
    }

    double v(double y) {
        return getHeight() / 2.0 - (y - y0) * echelle;
    }

    private void peindre(Graphics2D g) {
        g.setColor(UIManager.getColor("Tree.textForeground"));
        Point depart = pixel.camera.getOeil();
        g.draw(ligne(pixel.camera.getEcran(0, pixel.camera.getHauteur()), pixel.camera.getEcran(0, 0)));
        g.fill(new Ellipse2D.Double(h(depart.z) - 3, v(depart.y) - 3, 6, 6));
        g.drawString("œil", (float) h(depart.z), (float) v(depart.y) - 6);
        numeros.clear();
        for (Segment segment : pixel.getSegments()) {
            boolean montre = seul == 0 || seul == segment.numero;
            Point bout = segment.contact == null ? depart.add(2 * getWidth() / echelle, segment.V) : segment.contact;
            entourer(g, segment.contact);
            if (montre) {
                segment.lampes.forEach(lampe -> eclairer(g, bout, lampe));
            }
            g.setColor(RAYON);
            if (montre || seul == segment.numero - 1) {
                g.draw(ligne(depart, bout));
            }
            if (segment.contact != null) {
                g.setColor(UIManager.getColor("Tree.textForeground"));
                numeros.put(segment.numero, Figure.ecrire(g, segment.numero, h(bout.z) + 4, v(bout.y) - 4));
            }
            depart = bout;
        }
    }

    /** Peint une lampe, ou l'objet qui la cache ; en tirets jusqu'à une lampe cachée, si un rebond est choisi. */
    private void eclairer(Graphics2D g, Point contact, Terme lampe) {
        entourer(g, lampe.cache);
        g.setColor(LAMPE);
        if (lampe.eclaire() || lampe.cache != null && seul > 0) {
            Stroke plein = g.getStroke();
            g.setStroke(lampe.eclaire() ? plein : Figure.TIRETE);
            g.draw(ligne(contact, lampe.lampe.getPosition()));
            g.setStroke(plein);
        }
    }

    /** Peint le bord visible d'une sphère : d'un grand cercle, Java ne peint juste qu'un petit arc. */
    private void entourer(Graphics2D g, PointContact contact) {
        if (contact != null && contact.objet instanceof Sphere) {
            Sphere s = (Sphere) contact.objet;
            double x = h(s.getCentre().z);
            double y = v(s.getCentre().y);
            double r = s.getRayon() * echelle;
            double milieu = Math.toDegrees(Math.atan2(y - getHeight() / 2.0, getWidth() / 2.0 - x));
            double demi = Math.min(180, Math.toDegrees(2 * Math.hypot(getWidth(), getHeight()) / r));
            g.setColor(SPHERE);
            g.draw(new Arc2D.Double(x - r, y - r, 2 * r, 2 * r, milieu - demi, 2 * demi, Arc2D.OPEN));
        }
    }
}
