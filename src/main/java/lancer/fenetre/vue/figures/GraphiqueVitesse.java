package lancer.fenetre.vue.figures;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import javax.swing.JPanel;
import javax.swing.UIManager;
import lancer.commande.Reglages;
import lancer.fenetre.etat.Essai;
import lancer.texte.Nombre;

/** Les réglages dessinés : temps en abscisse, erreur mesurée en ordonnée, en échelles logarithmiques. */
@SuppressWarnings("serial")
public final class GraphiqueVitesse extends JPanel {

    private static final int MARGE = 50;
    private static final int HAUT = 26;
    private static final int BORD = 14;
    private static final int RAYON = 5;
    /** Les places d'un nom : à droite, à gauche, au-dessus, au-dessous, puis en biais. */
    private static final double[][] PLACES = {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}};
    private static final Color POINT = new Color(0x2675BF);
    private static final Color POINT_CLAIR = new Color(0x7CBBF2);

    /** Rapport d'un bout d'axe au dernier point, et celui au-delà duquel les graduations sont 1, 2, 5, 10… */
    private static final double AU_DELA = 1.25;
    private static final double LARGE = 8;

    /** Les réglages dessinés, du plus rapide au plus lent. */
    private List<Essai> essais = Collections.emptyList();
    private Reglages present;
    private Reglages vise;
    private double xMin;
    private double xMax;
    private double yMin;
    private double yMax;

    public GraphiqueVitesse() {
        setName("vitesse.graphique");
        setFocusable(true);
        getAccessibleContext().setAccessibleName("réglages, par temps et par erreur");
    }

    /** @param celui le réglage de l'image montrée @param entoure celui qui est entouré, ou {@code null} */
    public void montrer(Collection<Essai> tous, Reglages celui, Reglages entoure) {
        present = celui;
        vise = entoure;
        essais = tous.stream().filter(Essai::estFait)
                .sorted(Comparator.comparingDouble(essai -> essai.durees.getMediane())).collect(Collectors.toList());
        xMin = essais.stream().mapToDouble(p -> p.durees.getMin()).min().orElse(1) / AU_DELA;
        xMax = essais.stream().mapToDouble(p -> p.durees.getMax()).max().orElse(1) * AU_DELA;
        yMin = essais.stream().filter(Essai::estVue).mapToDouble(p -> Math.max(p.erreur - p.incertitude, p.erreur / 2))
                .min().orElse(0.1) / AU_DELA;
        yMax = essais.stream().filter(Essai::estVue).mapToDouble(p -> p.erreur + p.incertitude).max().orElse(1)
                * AU_DELA;
        repaint();
    }

    /** Le réglage sous ce point, ou {@code null}. */
    public Essai sous(Point ou) {
        return essais.stream().min(Comparator.comparingDouble(p -> ou.distance(x(p), y(p))))
                .filter(p -> ou.distance(x(p), y(p)) < 2 * RAYON).orElse(null);
    }

    /** Le réglage dessiné qui suit celui-ci, ou le précède ; le premier si celui-ci n'est pas dessiné. */
    public Essai voisin(Reglages celui, int pas) {
        int rang = IntStream.range(0, essais.size()).filter(k -> essais.get(k).reglages.equals(celui)).findFirst()
                .orElse(-pas);
        return essais.isEmpty() ? null : essais.get(Math.max(0, Math.min(essais.size() - 1, rang + pas)));
    }

    /** Les graduations d'un axe entre ces bornes : 1, 2 et 5 fois une puissance de dix ou, s'il est court, égales. */
    private static DoubleStream graduations(double min, double max) {
        if (max > LARGE * min) {
            return IntStream.range(-30, 30).mapToDouble(GraphiqueVitesse::ronde).filter(t -> t >= min && t <= max);
        }
        double pas = IntStream.range(-30, 30).mapToDouble(GraphiqueVitesse::ronde).filter(p -> max - min < 6 * p)
                .findFirst().getAsDouble();
        return IntStream.rangeClosed((int) Math.ceil(min / pas), (int) (max / pas)).mapToDouble(k -> k * pas);
    }

    private static double ronde(int k) {
        return new int[] {1, 2, 5}[Math.floorMod(k, 3)] * Math.pow(10, Math.floorDiv(k, 3));
    }

    private double x(Essai p) {
        return x(p.durees.getMediane());
    }

    private double y(Essai p) {
        return y(p.erreur);
    }

    private double x(double ns) {
        return MARGE + (getWidth() - MARGE - BORD) * Math.log(ns / xMin) / Math.log(xMax / xMin);
    }

    /** Une erreur qui n'a pas été vue est au bas de l'axe. */
    private double y(double erreur) {
        double part = Math.log(Math.max(erreur, yMin) / yMin) / Math.log(yMax / yMin);
        return getHeight() - MARGE - (getHeight() - MARGE - HAUT) * part;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics;
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(UIManager.getColor("Tree.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        if (!essais.isEmpty()) {
            peindreAxes(g, getWidth() - BORD, getHeight() - MARGE);
            essais.forEach(p -> peindre(g, p));
            // un nom ne cache ni un point, ni un autre nom
            List<Rectangle2D> pris = essais.stream().map(p -> rond(p, RAYON).getBounds2D())
                    .collect(Collectors.toCollection(ArrayList::new));
            essais.forEach(p -> nommer(g, p, pris));
        }
    }

    private void peindreAxes(Graphics2D g, int droite, int bas) {
        Color trame = UIManager.getColor("Panel.background");
        double[] fin = {0};
        graduations(xMin / 1e9, xMax / 1e9).forEach(t -> {
            double x = x(t * 1e9);
            g.setColor(trame);
            g.draw(new Line2D.Double(x, HAUT, x, bas));
            double demi = g.getFontMetrics().stringWidth(nombre(t)) / 2.0;
            if (x - demi > fin[0]) {
                ecrire(g, nombre(t), x, bas + 15, 0.5);
                fin[0] = x + demi + RAYON;
            }
        });
        graduations(yMin, yMax).forEach(e -> {
            g.setColor(trame);
            g.draw(new Line2D.Double(MARGE, y(e), droite, y(e)));
            ecrire(g, nombre(e), MARGE - 6, y(e) + 4, 1);
        });
        ecrire(g, "temps du dessin, en secondes", (MARGE + droite) / 2, bas + 33, 0.5);
        ecrire(g, "erreur, en niveaux", 6, 14, 0);
    }

    private Ellipse2D rond(Essai p, int rayon) {
        return new Ellipse2D.Double(x(p) - rayon, y(p) - rayon, 2 * rayon, 2 * rayon);
    }

    /** Peint ce réglage et ses deux intervalles. */
    private void peindre(Graphics2D g, Essai p) {
        // bleu sombre sur un fond clair, et le contraire
        g.setColor(UIManager.getColor("Tree.background").getRed() < 128 ? POINT_CLAIR : POINT);
        g.draw(new Line2D.Double(x(p), y(p.erreur - p.incertitude), x(p), y(p.erreur + p.incertitude)));
        g.draw(new Line2D.Double(x(p.durees.getMin()), y(p), x(p.durees.getMax()), y(p)));
        g.fill(rond(p, RAYON));
        if (p.reglages.equals(vise)) {
            g.setColor(UIManager.getColor("Component.focusColor"));
            g.draw(rond(p, 2 * RAYON));
        }
    }

    /** Écrit son nom à côté de lui, là où il ne couvre rien et n'est pas plus près d'un autre point. */
    private void nommer(Graphics2D g, Essai p, List<Rectangle2D> pris) {
        String nom = p.reglages.equals(present) ? "ici : " + p.getNom() : p.getNom();
        double large = g.getFontMetrics().stringWidth(nom);
        double haut = g.getFontMetrics().getHeight();
        Rectangle2D cadre = new Rectangle2D.Double(MARGE, HAUT - haut / 2, getWidth() - MARGE,
                getHeight() - MARGE - HAUT + haut);
        for (double[] vers : PLACES) {
            double milieu = y(p) + vers[1] * (RAYON + haut / 2);
            double marge = vers[1] == 0 ? 2 * RAYON : 0;
            double gauche = x(p) - large / 2 + vers[0] * (marge + large / 2);
            Rectangle2D place = new Rectangle2D.Double(gauche, milieu - haut / 2, large, haut);
            if (cadre.contains(place) && pris.stream().noneMatch(place::intersects) && essais.stream()
                    .noneMatch(autre -> ecart(place, autre) < ecart(place, p))) {
                pris.add(place);
                ecrire(g, nom, gauche, milieu + haut / 2 - g.getFontMetrics().getDescent(), 0);
                return;
            }
        }
    }

    /** La distance de ce point au bord de cette place. */
    private double ecart(Rectangle2D place, Essai p) {
        double dx = Math.max(0, Math.max(place.getMinX() - x(p), x(p) - place.getMaxX()));
        double dy = Math.max(0, Math.max(place.getMinY() - y(p), y(p) - place.getMaxY()));
        return Math.hypot(dx, dy);
    }

    private static String nombre(double t) {
        // le produit d'un entier et d'un pas n'est pas toujours rond
        return Nombre.ecrire(Math.rint(t * 1e9) / 1e9).replace('.', ',');
    }

    /** @param cale 0 pour écrire à partir de x, 1 pour finir en x */
    private static void ecrire(Graphics2D g, String texte, double x, double y, double cale) {
        g.setColor(UIManager.getColor("Tree.textForeground"));
        g.drawString(texte, (float) (x - cale * g.getFontMetrics().stringWidth(texte)), (float) y);
    }
}
