package lancer.fenetre.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import javax.swing.JPanel;
import javax.swing.UIManager;

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

    /** Dans l'ordre des temps. */
    private final List<Reglage> points = new ArrayList<>();
    private Reglage choisi;
    private double xMin;
    private double xMax;
    private double yMax;

    /** Un réglage dessiné : son temps et son erreur en niveaux, chacun avec son intervalle. */
    public static class Reglage {

        final String nom;
        final boolean ici;
        final double min;
        final double max;
        final double erreur;
        final double incertitude;
        /** Le temps où il est placé : le même pour des réglages dont les temps ne se distinguent pas. */
        double secondes;

        /** @param ici vrai pour le réglage de l'image montrée @param secondes le temps, puis son intervalle */
        public Reglage(String nom, boolean ici, double[] secondes, double erreur, double incertitude) {
            this.nom = nom;
            this.ici = ici;
            this.secondes = secondes[0];
            min = secondes[1];
            max = secondes[2];
            this.erreur = erreur;
            this.incertitude = incertitude;
        }
    }

    public GraphiqueVitesse() {
        setName("vitesse.graphique");
        setFocusable(true);
        getAccessibleContext().setAccessibleName("réglages, par temps et par erreur");
    }

    public void montrer(List<? extends Reglage> nouveaux) {
        points.clear();
        points.addAll(nouveaux);
        points.sort(Comparator.comparingDouble(p -> p.secondes));
        rapprocher();
        // les bornes sont des graduations : elles changent rarement quand un point s'ajoute
        xMin = graduation(points.stream().mapToDouble(p -> p.min).min().orElse(1) / 2.5);
        xMax = graduation(points.stream().mapToDouble(p -> p.max).max().orElse(1) * 1.1);
        yMax = graduation(points.stream().mapToDouble(p -> p.erreur + p.incertitude).max().orElse(1) * 1.1);
        repaint();
    }

    /** Place au même temps les réglages qui se suivent, tant que leurs intervalles ont un temps commun. */
    private void rapprocher() {
        int debut = 0;
        double min = 0;
        double max = Double.POSITIVE_INFINITY;
        for (int k = 0; k <= points.size(); k++) {
            if (k == points.size() || points.get(k).min > max || points.get(k).max < min) {
                double commun = (min + max) / 2;
                points.subList(debut, k).forEach(p -> p.secondes = commun);
                debut = k;
                min = 0;
                max = Double.POSITIVE_INFINITY;
            }
            if (k < points.size()) {
                min = Math.max(min, points.get(k).min);
                max = Math.min(max, points.get(k).max);
            }
        }
    }

    /** Le réglage désigné, ou {@code null}. */
    public Reglage getChoisi() {
        return choisi;
    }

    /** Désigne le réglage sous ce point, s'il y en a un. */
    public boolean choisir(java.awt.Point ou) {
        return choisir(points.stream().filter(p -> ou.distance(x(p.secondes), y(p.erreur)) < PORTEE)
                .min(Comparator.comparingDouble(p -> ou.distance(x(p.secondes), y(p.erreur)))).orElse(null));
    }

    /** Désigne le réglage plus rapide ({@code pas} −1) ou plus lent (1) que celui qui l'est. */
    public boolean choisir(int pas) {
        return choisir(points.isEmpty() ? null
                : points.get(Math.max(0, Math.min(points.size() - 1, points.indexOf(choisi) + pas))));
    }

    private boolean choisir(Reglage vise) {
        choisi = vise == null ? choisi : vise;
        repaint();
        return vise != null;
    }

    private static double graduation(double min) {
        return graduations(min, Double.MAX_VALUE).findFirst().orElse(min);
    }

    /** Les 1, 2 et 5 fois une puissance de dix entre ces bornes. */
    private static DoubleStream graduations(double min, double max) {
        return IntStream.range(-18, 21).mapToDouble(k -> new int[] {1, 2, 5}[Math.floorMod(k, 3)]
                * Math.pow(10, Math.floorDiv(k, 3))).filter(t -> t >= 0.999 * min && t <= 1.001 * max);
    }

    private double x(double temps) {
        return GAUCHE + (getWidth() - GAUCHE - DROITE) * Math.log(temps / xMin) / Math.log(xMax / xMin);
    }

    private double y(double erreur) {
        double part = Math.log(Math.max(erreur, Y_MIN) / Y_MIN) / Math.log(yMax / Y_MIN);
        return getHeight() - BAS - (getHeight() - HAUT - BAS) * part;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics;
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(UIManager.getColor("Tree.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        if (!points.isEmpty()) {
            peindreAxes(g, getWidth() - DROITE, getHeight() - BAS);
            peindrePoints(g);
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

    private void peindrePoints(Graphics2D g) {
        Color accent = UIManager.getColor("Component.accentColor");
        Color encre = UIManager.getColor("Tree.textForeground");
        List<Rectangle2D> noms = new ArrayList<>();
        g.setStroke(new BasicStroke(1.5f));
        for (Reglage p : points) {
            double x = x(p.secondes);
            double y = y(p.erreur);
            g.setColor(accent == null ? encre : accent);
            g.draw(new Line2D.Double(x, y(p.erreur - p.incertitude), x, y(p.erreur + p.incertitude)));
            g.draw(new Line2D.Double(x(p.min), y, x(p.max), y));
            g.fill(new Ellipse2D.Double(x - RAYON, y - RAYON, 2 * RAYON, 2 * RAYON));
            g.setColor(encre);
            if (p.ici) {
                g.draw(new Ellipse2D.Double(x - 2 * RAYON, y - 2 * RAYON, 4 * RAYON, 4 * RAYON));
            }
            if (p == choisi) {
                g.draw(new Rectangle2D.Double(x - RAYON - 3, y - RAYON - 3, 2 * RAYON + 6, 2 * RAYON + 6));
            }
            nommer(g, p, noms);
        }
    }

    /** Écrit le nom de ce point à sa droite ou à sa gauche, sauf s'il y toucherait un autre nom. */
    private void nommer(Graphics2D g, Reglage p, List<Rectangle2D> noms) {
        double large = g.getFontMetrics().stringWidth(p.nom);
        double haut = g.getFontMetrics().getAscent();
        for (double x : new double[] {x(p.secondes) + 2 * RAYON + 2, x(p.secondes) - 2 * RAYON - 2 - large}) {
            Rectangle2D place = new Rectangle2D.Double(x, y(p.erreur) - RAYON - haut, large, haut);
            if (x > GAUCHE && x + large < getWidth() && noms.stream().noneMatch(place::intersects)) {
                noms.add(place);
                ecrire(g, p.nom, x, y(p.erreur) - RAYON, 0);
                return;
            }
        }
    }

    /** @param cale 0 pour écrire à partir de x, 1 pour finir en x */
    private static void ecrire(Graphics2D g, String texte, double x, double y, double cale) {
        g.setColor(UIManager.getColor("Tree.textForeground"));
        g.drawString(texte, (float) (x - cale * g.getFontMetrics().stringWidth(texte)), (float) y);
    }

    private static String nombre(double t) {
        return t >= 10 ? String.format(Locale.FRANCE, "%.0f", t)
                : String.format(Locale.FRANCE, "%.3f", t).replaceAll(",?0+$", "");
    }
}
