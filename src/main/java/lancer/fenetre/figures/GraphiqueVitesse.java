package lancer.fenetre.figures;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import javax.swing.JPanel;
import javax.swing.UIManager;
import lancer.commande.Reglages;
import lancer.texte.Nombre;

/** Les réglages dessinés : temps en abscisse, erreur mesurée en ordonnée, en échelles logarithmiques. */
@SuppressWarnings("serial")
public final class GraphiqueVitesse extends JPanel {

    private static final double Y_MIN = 0.1;
    private static final int MARGE = 50;
    private static final int BORD = 20;
    private static final int RAYON = 5;
    private static final Color POINT = new Color(0x2675BF);

    /** Les réglages dessinés, du plus rapide au plus lent, et l'intervalle au milieu duquel chacun est placé. */
    private final Map<Essai, double[]> places = new LinkedHashMap<>();
    private Reglages present;
    private double xMin;
    private double xMax;
    private double yMax;

    public GraphiqueVitesse() {
        setName("vitesse.graphique");
        getAccessibleContext().setAccessibleName("réglages, par temps et par erreur");
    }

    /** @param celui le réglage de l'image montrée */
    public void montrer(List<Essai> essais, Reglages celui) {
        present = celui;
        places.clear();
        double[] commun = {0, Double.MAX_VALUE};
        for (Essai p : essais.stream().filter(essai -> essai.durees.getNombre() > 0)
                .sorted(Comparator.comparingDouble(essai -> essai.durees.getMediane())).collect(Collectors.toList())) {
            // des réglages qui se suivent ont la même place tant que leurs intervalles ont un temps commun
            if (p.durees.getMin() > commun[1] || p.durees.getMax() < commun[0]) {
                commun = new double[] {0, Double.MAX_VALUE};
            }
            commun[0] = Math.max(commun[0], p.durees.getMin());
            commun[1] = Math.min(commun[1], p.durees.getMax());
            places.put(p, commun);
        }
        xMin = places.keySet().stream().mapToDouble(p -> p.durees.getMin()).min().orElse(1) / 2.5;
        xMax = places.keySet().stream().mapToDouble(p -> p.durees.getMax()).max().orElse(1) * 1.5;
        yMax = places.keySet().stream().mapToDouble(p -> p.erreur + p.incertitude).max().orElse(1) + 2 * Y_MIN;
        repaint();
    }

    /** Le réglage sous ce point, ou {@code null}. */
    public Essai sous(Point ou) {
        return places.keySet().stream().filter(p -> ou.distance(x(p), y(p.erreur)) < 2 * RAYON)
                .min(Comparator.comparingDouble(p -> ou.distance(x(p), y(p.erreur)))).orElse(null);
    }

    /** Les 1, 2 et 5 fois une puissance de dix entre ces bornes. */
    private static DoubleStream graduations(double min, double max) {
        return IntStream.range(-18, 21).mapToDouble(k -> new int[] {1, 2, 5}[Math.floorMod(k, 3)]
                * Math.pow(10, Math.floorDiv(k, 3))).filter(t -> t >= 0.999 * min && t <= max);
    }

    private double x(Essai p) {
        return x((places.get(p)[0] + places.get(p)[1]) / 2);
    }

    private double x(double ns) {
        return MARGE + (getWidth() - MARGE - BORD) * Math.log(ns / xMin) / Math.log(xMax / xMin);
    }

    private double y(double erreur) {
        double part = Math.log(Math.max(erreur, Y_MIN) / Y_MIN) / Math.log(yMax / Y_MIN);
        return getHeight() - MARGE - (getHeight() - MARGE - BORD) * part;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics;
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(UIManager.getColor("Tree.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        if (!places.isEmpty()) {
            peindreAxes(g, getWidth() - BORD, getHeight() - MARGE);
            List<Rectangle2D> noms = new ArrayList<>();
            places.keySet().stream().sorted(Comparator.comparing(p -> !p.reglages.equals(present)))
                    .forEach(p -> peindre(g, p, noms));
        }
    }

    private void peindreAxes(Graphics2D g, int droite, int bas) {
        Color trame = UIManager.getColor("Panel.background");
        graduations(xMin / 1e9, xMax / 1e9).forEach(t -> {
            g.setColor(trame);
            g.draw(new Line2D.Double(x(t * 1e9), BORD, x(t * 1e9), bas));
            ecrire(g, nombre(t), x(t * 1e9), bas + 15, 0.5);
        });
        graduations(Y_MIN, yMax).forEach(e -> {
            g.setColor(trame);
            g.draw(new Line2D.Double(MARGE, y(e), droite, y(e)));
            ecrire(g, nombre(e), MARGE - 6, y(e) + 4, 1);
        });
        ecrire(g, "temps du dessin, en secondes", (MARGE + droite) / 2, bas + 33, 0.5);
        ecrire(g, "erreur, en niveaux", MARGE, 14, 0);
    }

    /** Peint ce réglage, ses deux intervalles, et son nom s'il n'en touche pas un autre. */
    private void peindre(Graphics2D g, Essai p, List<Rectangle2D> noms) {
        double x = x(p);
        double y = y(p.erreur);
        g.setColor(POINT);
        g.draw(new Line2D.Double(x, y(p.erreur - p.incertitude), x, y(p.erreur + p.incertitude)));
        g.draw(new Line2D.Double(x(p.durees.getMin()), y, x(p.durees.getMax()), y));
        g.fill(new Ellipse2D.Double(x - RAYON, y - RAYON, 2 * RAYON, 2 * RAYON));
        String nom = p.reglages.equals(present) ? "ici : " + p.getNom() : p.getNom();
        // à droite, s'il y a la place
        double large = g.getFontMetrics().stringWidth(nom);
        double gauche = x + 2 * RAYON + large < getWidth() ? x + 2 * RAYON : x - 2 * RAYON - large;
        Rectangle2D place = new Rectangle2D.Double(gauche, y - 3 * RAYON, large, 2 * RAYON);
        if (noms.stream().noneMatch(place::intersects)) {
            noms.add(place);
            ecrire(g, nom, gauche, y - RAYON, 0);
        }
    }

    private static String nombre(double t) {
        return Nombre.ecrire(t).replace('.', ',');
    }

    /** @param cale 0 pour écrire à partir de x, 1 pour finir en x */
    private static void ecrire(Graphics2D g, String texte, double x, double y, double cale) {
        g.setColor(UIManager.getColor("Tree.textForeground"));
        g.drawString(texte, (float) (x - cale * g.getFontMetrics().stringWidth(texte)), (float) y);
    }
}
