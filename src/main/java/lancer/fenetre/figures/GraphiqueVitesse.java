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
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import javax.swing.JPanel;
import javax.swing.UIManager;
import lancer.commande.Reglages;

/** Les réglages dessinés : temps en abscisse, erreur mesurée en ordonnée, en échelles logarithmiques. */
@SuppressWarnings("serial")
public final class GraphiqueVitesse extends JPanel {

    private static final double Y_MIN = 0.1;
    private static final int GAUCHE = 52;
    private static final int DROITE = 14;
    private static final int HAUT = 26;
    private static final int BAS = 42;
    private static final int RAYON = 5;
    private static final int PORTEE = 12;

    /** Ceux qui sont dessinés, du plus rapide au plus lent, et l'intervalle où chacun est placé. */
    private List<Essai> points = new ArrayList<>();
    private final List<double[]> places = new ArrayList<>();
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
        points = essais.stream().filter(essai -> essai.durees.getNombre() > 0)
                .sorted(Comparator.comparingDouble(essai -> essai.durees.getMediane())).collect(Collectors.toList());
        present = celui;
        placer();
        // les bornes sont des graduations : elles changent rarement quand un point s'ajoute
        xMin = graduation(points.stream().mapToDouble(GraphiqueVitesse::min).min().orElse(1) / 2.5);
        xMax = graduation(points.stream().mapToDouble(GraphiqueVitesse::max).max().orElse(1) * 1.1);
        yMax = graduation(points.stream().mapToDouble(p -> p.erreur + p.incertitude).max().orElse(1) * 1.1);
        repaint();
    }

    /** Donne le même temps à des réglages qui se suivent, tant que leurs intervalles ont un temps commun. */
    private void placer() {
        places.clear();
        double[] commun = {0, 0};
        for (Essai p : points) {
            if (min(p) > commun[1] || max(p) < commun[0]) {
                commun = new double[] {min(p), max(p)};
            }
            commun[0] = Math.max(commun[0], min(p));
            commun[1] = Math.min(commun[1], max(p));
            places.add(commun);
        }
    }

    private static double min(Essai p) {
        return p.durees.getMin() / 1e9;
    }

    private static double max(Essai p) {
        return p.durees.getMax() / 1e9;
    }

    /** Le réglage sous ce point, ou {@code null}. */
    public Essai sous(Point ou) {
        return points.stream().filter(p -> ou.distance(x(p), y(p.erreur)) < PORTEE)
                .min(Comparator.comparingDouble(p -> ou.distance(x(p), y(p.erreur)))).orElse(null);
    }

    private static double graduation(double min) {
        return graduations(min, Double.MAX_VALUE).findFirst().orElse(min);
    }

    /** Les 1, 2 et 5 fois une puissance de dix entre ces bornes. */
    private static DoubleStream graduations(double min, double max) {
        return IntStream.range(-18, 21).mapToDouble(k -> new int[] {1, 2, 5}[Math.floorMod(k, 3)]
                * Math.pow(10, Math.floorDiv(k, 3))).filter(t -> t >= 0.999 * min && t <= 1.001 * max);
    }

    private double x(Essai p) {
        double[] place = places.get(points.indexOf(p));
        return x((place[0] + place[1]) / 2);
    }

    private double x(double secondes) {
        return GAUCHE + (getWidth() - GAUCHE - DROITE) * Math.log(secondes / xMin) / Math.log(xMax / xMin);
    }

    private double y(double erreur) {
        double part = Math.log(Math.max(erreur, Y_MIN) / Y_MIN) / Math.log(yMax / Y_MIN);
        return getHeight() - BAS - (getHeight() - HAUT - BAS) * part;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics;
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(UIManager.getColor("Tree.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        if (!points.isEmpty()) {
            peindreAxes(g, getWidth() - DROITE, getHeight() - BAS);
            List<Rectangle2D> noms = new ArrayList<>();
            points.stream().sorted(Comparator.comparing(p -> !p.reglages.equals(present)))
                    .forEach(p -> peindre(g, p, noms));
        }
    }

    private void peindreAxes(Graphics2D g, int droite, int bas) {
        Color trame = UIManager.getColor("Panel.background");
        graduations(xMin, xMax).forEach(t -> {
            g.setColor(trame);
            g.draw(new Line2D.Double(x(t), HAUT, x(t), bas));
            ecrire(g, nombre(t), x(t), bas + 15, 0.5);
        });
        graduations(Y_MIN, yMax).forEach(t -> {
            g.setColor(trame);
            g.draw(new Line2D.Double(GAUCHE, y(t), droite, y(t)));
            ecrire(g, nombre(t), GAUCHE - 6, y(t) + 4, 1);
        });
        ecrire(g, "temps du dessin, en secondes", (GAUCHE + droite) / 2, bas + 33, 0.5);
        ecrire(g, "erreur, en niveaux", 6, 14, 0);
    }

    /** Peint ce réglage, ses deux intervalles, et son nom s'il n'en touche pas un autre. */
    private void peindre(Graphics2D g, Essai p, List<Rectangle2D> noms) {
        double x = x(p);
        double y = y(p.erreur);
        g.setColor(new Color(0x2675BF));
        g.draw(new Line2D.Double(x, y(p.erreur - p.incertitude), x, y(p.erreur + p.incertitude)));
        g.draw(new Line2D.Double(x(min(p)), y, x(max(p)), y));
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
        return t >= 10 ? String.format(Locale.FRANCE, "%.0f", t)
                : String.format(Locale.FRANCE, "%.3f", t).replaceAll(",?0+$", "");
    }

    /** @param cale 0 pour écrire à partir de x, 1 pour finir en x */
    private static void ecrire(Graphics2D g, String texte, double x, double y, double cale) {
        g.setColor(UIManager.getColor("Tree.textForeground"));
        g.drawString(texte, (float) (x - cale * g.getFontMetrics().stringWidth(texte)), (float) y);
    }
}
