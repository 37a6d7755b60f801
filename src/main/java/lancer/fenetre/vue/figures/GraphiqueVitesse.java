package lancer.fenetre.vue.figures;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
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

    private Trace trace = new Trace(Collections.emptyList(), null, null);

    /** Ce qui est tracé. Immuable. */
    private static final class Trace {

        final Collection<Essai> tous;
        /** Les réglages dessinés, du plus rapide au plus lent. */
        final List<Essai> essais;
        final Reglages present;
        final Reglages vise;
        final Axe temps;
        final Axe erreurs;

        Trace(Collection<Essai> tous, Reglages present, Reglages vise) {
            this.tous = tous;
            this.present = present;
            this.vise = vise;
            essais = tous.stream().filter(Essai::estFait)
                    .sorted(Comparator.comparingDouble(GraphiqueVitesse::secondes)).collect(Collectors.toList());
            temps = new Axe(essais.stream().map(essai -> essai.durees)
                    .flatMapToDouble(d -> DoubleStream.of(d.getMin() / 1e9, d.getMax() / 1e9)));
            erreurs = new Axe(essais.stream().filter(Essai::estVue).flatMapToDouble(e -> DoubleStream.of(
                    Math.max(e.erreur - e.incertitude, e.erreur / 2), e.erreur + e.incertitude)));
        }
    }

    /** Un axe logarithmique, un peu plus long que ce qu'il porte. */
    private static final class Axe {

        final double min;
        final double max;

        Axe(DoubleStream valeurs) {
            DoubleSummaryStatistics bornes = valeurs.summaryStatistics();
            min = (bornes.getCount() == 0 ? 0.1 : bornes.getMin()) / AU_DELA;
            max = (bornes.getCount() == 0 ? 1 : bornes.getMax()) * AU_DELA;
        }

        /** La place de cette valeur, de 0 à 1 ; ce qui n'a pas été vu est au début. */
        double part(double valeur) {
            return Math.log(Math.max(valeur, min) / min) / Math.log(max / min);
        }

        /** 1, 2 et 5 fois une puissance de dix ou, si l'axe est court, des nombres à égale distance. */
        DoubleStream graduations() {
            if (max > LARGE * min) {
                return IntStream.range(-30, 30).mapToDouble(Axe::rond).filter(t -> t >= min && t <= max);
            }
            double pas = IntStream.range(-30, 30).mapToDouble(Axe::rond).filter(p -> max - min < 6 * p)
                    .findFirst().getAsDouble();
            return IntStream.rangeClosed((int) Math.ceil(min / pas), (int) (max / pas)).mapToDouble(k -> k * pas);
        }

        private static double rond(int k) {
            return new int[] {1, 2, 5}[Math.floorMod(k, 3)] * Math.pow(10, Math.floorDiv(k, 3));
        }
    }

    public GraphiqueVitesse() {
        setName("vitesse.graphique");
        setFocusable(true);
        getAccessibleContext().setAccessibleName("réglages, par temps et par erreur");
    }

    /** @param celui le réglage de l'image montrée @param entoure celui qui est entouré, ou {@code null} */
    public void montrer(Collection<Essai> tous, Reglages celui, Reglages entoure) {
        if (tous != trace.tous || celui != trace.present || entoure != trace.vise) {
            trace = new Trace(tous, celui, entoure);
            repaint();
        }
    }

    /** Le réglage sous ce point, ou {@code null}. */
    public Essai sous(Point ou) {
        return trace.essais.stream().min(Comparator.comparingDouble(p -> ou.distance(place(p))))
                .filter(p -> ou.distance(place(p)) < 2 * RAYON).orElse(null);
    }

    /** Le réglage dessiné qui suit, ou précède, celui qui est entouré ; à défaut, le premier, s'il y en a un. */
    public Essai voisin(int pas) {
        List<Essai> essais = trace.essais;
        int rang = IntStream.range(0, essais.size()).filter(k -> essais.get(k).reglages.equals(trace.vise)).findFirst()
                .orElse(-pas);
        return essais.isEmpty() ? null : essais.get(Math.max(0, Math.min(essais.size() - 1, rang + pas)));
    }

    private static double secondes(Essai p) {
        return p.durees.getMediane() / 1e9;
    }

    private double x(double secondes) {
        return MARGE + (getWidth() - MARGE - BORD) * trace.temps.part(secondes);
    }

    private double y(double erreur) {
        return getHeight() - MARGE - (getHeight() - MARGE - HAUT) * trace.erreurs.part(erreur);
    }

    private Point2D place(Essai p) {
        return new Point2D.Double(x(secondes(p)), y(p.erreur));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics;
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(UIManager.getColor("Tree.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        if (!trace.essais.isEmpty()) {
            peindreAxes(g, getWidth() - BORD, getHeight() - MARGE);
            trace.essais.forEach(p -> peindre(g, p));
            // un nom ne cache ni un point, ni un autre nom
            List<Rectangle2D> pris = trace.essais.stream().map(p -> rond(p, RAYON).getBounds2D())
                    .collect(Collectors.toCollection(ArrayList::new));
            trace.essais.forEach(p -> nommer(g, p, pris));
        }
    }

    private void peindreAxes(Graphics2D g, int droite, int bas) {
        Color trame = UIManager.getColor("Panel.background");
        double[] fin = {0};
        trace.temps.graduations().forEach(t -> {
            g.setColor(trame);
            g.draw(new Line2D.Double(x(t), HAUT, x(t), bas));
            double demi = g.getFontMetrics().stringWidth(nombre(t)) / 2.0;
            if (x(t) - demi > fin[0]) {
                ecrire(g, nombre(t), x(t), bas + 15, 0.5);
                fin[0] = x(t) + demi + RAYON;
            }
        });
        trace.erreurs.graduations().forEach(e -> {
            g.setColor(trame);
            g.draw(new Line2D.Double(MARGE, y(e), droite, y(e)));
            ecrire(g, nombre(e), MARGE - 6, y(e) + 4, 1);
        });
        ecrire(g, "temps du dessin, en secondes", (MARGE + droite) / 2, bas + 33, 0.5);
        ecrire(g, "erreur, en niveaux", 6, 14, 0);
    }

    private Ellipse2D rond(Essai p, int rayon) {
        return new Ellipse2D.Double(place(p).getX() - rayon, place(p).getY() - rayon, 2 * rayon, 2 * rayon);
    }

    /** Peint ce réglage et ses deux intervalles. */
    private void peindre(Graphics2D g, Essai p) {
        // bleu sombre sur un fond clair, et le contraire
        g.setColor(UIManager.getColor("Tree.background").getRed() < 128 ? POINT_CLAIR : POINT);
        double x = place(p).getX();
        double y = place(p).getY();
        g.draw(new Line2D.Double(x, y(p.erreur - p.incertitude), x, y(p.erreur + p.incertitude)));
        g.draw(new Line2D.Double(x(p.durees.getMin() / 1e9), y, x(p.durees.getMax() / 1e9), y));
        g.fill(rond(p, RAYON));
        if (p.reglages.equals(trace.vise)) {
            g.setColor(UIManager.getColor("Component.focusColor"));
            g.draw(rond(p, 2 * RAYON));
        }
    }

    /** Écrit son nom à côté de lui, là où il ne couvre rien et n'est pas plus près d'un autre point. */
    private void nommer(Graphics2D g, Essai p, List<Rectangle2D> pris) {
        String nom = p.reglages.equals(trace.present) ? "ici : " + p.getNom() : p.getNom();
        double large = g.getFontMetrics().stringWidth(nom);
        double haut = g.getFontMetrics().getHeight();
        Rectangle2D cadre = new Rectangle2D.Double(MARGE, HAUT - haut / 2, getWidth() - MARGE,
                getHeight() - MARGE - HAUT + haut);
        for (double[] vers : PLACES) {
            double marge = vers[1] == 0 ? 2 * RAYON : 0;
            Rectangle2D place = new Rectangle2D.Double(
                    place(p).getX() - large / 2 + vers[0] * (marge + large / 2),
                    place(p).getY() - haut / 2 + vers[1] * (RAYON + haut / 2), large, haut);
            if (cadre.contains(place) && pris.stream().noneMatch(place::intersects) && trace.essais.stream()
                    .noneMatch(autre -> ecart(place, autre) < ecart(place, p))) {
                pris.add(place);
                g.setColor(UIManager.getColor("Tree.background"));
                g.fill(place);
                ecrire(g, nom, place.getX(), place.getMaxY() - g.getFontMetrics().getDescent(), 0);
                return;
            }
        }
    }

    /** La distance de ce point au bord de cette place. */
    private double ecart(Rectangle2D place, Essai p) {
        Point2D ou = place(p);
        double dx = Math.max(0, Math.max(place.getMinX() - ou.getX(), ou.getX() - place.getMaxX()));
        double dy = Math.max(0, Math.max(place.getMinY() - ou.getY(), ou.getY() - place.getMaxY()));
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
