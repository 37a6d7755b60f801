package lancer.fenetre.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import javax.swing.JPanel;
import javax.swing.UIManager;

/** Graphique des réglages dessinés : temps en abscisse, erreur mesurée en ordonnée, en échelles logarithmiques. */
@SuppressWarnings("serial")
public final class GraphiqueVitesse extends JPanel {

    /** Erreur d'arrondi de l'écran, à un niveau entier. */
    private static final double ARRONDI = 1 / Math.sqrt(12);

    private static final double Y_MIN = ARRONDI / 3;
    private static final int GAUCHE = 58;
    private static final int DROITE = 18;
    private static final int HAUT = 26;
    private static final int BAS = 42;
    private static final int SERRE = 150;
    private static final int RAYON = 5;
    private static final int PORTEE = 12;

    private final Consumer<String> siAtteint;
    private List<Reglage> echelle = new ArrayList<>();
    private List<Reglage> points = new ArrayList<>();
    private Reglage ici;
    private Reglage choisi;
    private double xMin;
    private double xMax;
    private double yMax;

    /** Un réglage dessiné : son temps, son erreur en niveaux, et l'incertitude de cette erreur à 95 %. */
    public static class Reglage {

        final String nom;
        final String texte;
        final double secondes;
        final double erreur;
        final double incertitude;
        /** Vrai si l'erreur peut être nulle : seule sa borne supérieure est alors écrite. */
        final boolean borne;

        /** @param nom nom court @param texte le réglage en entier */
        public Reglage(String nom, String texte, double secondes, double erreur, double incertitude) {
            this.nom = nom;
            this.secondes = secondes;
            this.erreur = erreur;
            this.incertitude = incertitude;
            borne = erreur - incertitude <= Y_MIN;
            this.texte = texte + String.format(Locale.FRANCE, borne ? " : %.3f s, erreur d'au plus %.2f"
                    : " : %.3f s, erreur de %3$.2f ± %4$.2f", secondes, erreur + incertitude, erreur, incertitude);
        }
    }

    /** @param siClique appelé après un clic sur le réglage choisi @param siAtteint reçoit le texte de ce réglage */
    public GraphiqueVitesse(Runnable siClique, Consumer<String> siAtteint) {
        this.siAtteint = siAtteint;
        setName("vitesse.graphique");
        setFocusable(true);
        getAccessibleContext().setAccessibleName("réglages, par temps et par erreur");
        MouseAdapter suiveur = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                choisir(sous(e));
            }

            @Override
            public void mousePressed(MouseEvent e) {
                requestFocusInWindow();
                if (sous(e) != null) {
                    choisir(sous(e));
                    siClique.run();
                }
            }
        };
        addMouseListener(suiveur);
        addMouseMotionListener(suiveur);
    }

    /** Choisit le point qui est à cette distance dans l'échelle. */
    public void aller(int pas) {
        if (!echelle.isEmpty()) {
            choisir(echelle.get(Math.max(0, Math.min(echelle.size() - 1, echelle.indexOf(choisi) + pas))));
        }
    }

    /** Le point choisi, ou {@code null}. */
    public Reglage getChoisi() {
        return choisi;
    }

    private void choisir(Reglage vise) {
        if (vise != null && vise != choisi) {
            choisi = vise;
            siAtteint.accept(vise.texte);
            getAccessibleContext().setAccessibleDescription(vise.texte);
            repaint();
        }
    }

    /** @param ici celui de l'image montrée, de l'échelle ou non ; {@code null} s'il n'est pas mesuré */
    public void montrer(List<? extends Reglage> dessines, Reglage ici) {
        echelle = new ArrayList<>(dessines);
        points = new ArrayList<>(dessines);
        if (ici != null && !points.contains(ici)) {
            points.add(ici);
        }
        this.ici = ici;
        choisi = points.contains(choisi) ? choisi : null;
        // les bornes sont des graduations : elles changent rarement quand un point s'ajoute
        xMin = graduation(points.stream().mapToDouble(p -> p.secondes).min().orElse(1) / 2.5);
        xMax = graduation(points.stream().mapToDouble(p -> p.secondes).max().orElse(1) * 1.1);
        yMax = graduation(points.stream().mapToDouble(p -> p.erreur + p.incertitude).max().orElse(1) * 1.1);
        repaint();
    }

    private static double graduation(double min) {
        return graduations(min, Double.MAX_VALUE).findFirst().orElse(min);
    }

    private double x(double temps) {
        return GAUCHE + (getWidth() - GAUCHE - DROITE) * Math.log(temps / xMin) / Math.log(xMax / xMin);
    }

    private double y(double erreur) {
        double part = Math.log(Math.max(erreur, Y_MIN) / Y_MIN) / Math.log(yMax / Y_MIN);
        return getHeight() - BAS - (getHeight() - HAUT - BAS) * part;
    }

    private Reglage sous(MouseEvent e) {
        ToDoubleFunction<Reglage> distance = p -> e.getPoint().distance(x(p.secondes), y(p.erreur));
        return points.stream().filter(p -> distance.applyAsDouble(p) < PORTEE)
                .min(Comparator.comparingDouble(distance)).orElse(null);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics;
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(UIManager.getColor("Tree.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        if (!points.isEmpty()) {
            g.setFont(g.getFont().deriveFont(g.getFont().getSize2D() * 0.9f));
            peindreAxes(g, getWidth() - DROITE, getHeight() - BAS);
            peindrePoints(g);
        }
    }

    private void peindreAxes(Graphics2D g, int droite, int bas) {
        Color trame = UIManager.getColor("Panel.background");
        g.setColor(trame);
        g.fillRect(GAUCHE, (int) y(ARRONDI), droite - GAUCHE, bas - (int) y(ARRONDI));
        graduations(xMin, xMax).forEach(t -> {
            trait(g, new Line2D.Double(x(t), HAUT, x(t), bas), trame);
            ecrire(g, nombre(t), x(t), bas + 15, 0.5);
        });
        // sans place, les seules puissances de dix
        graduations(Y_MIN, yMax).filter(t -> bas > SERRE || Math.log10(t) % 1 == 0).forEach(t -> {
            trait(g, new Line2D.Double(GAUCHE, y(t), droite, y(t)), trame);
            ecrire(g, nombre(t), GAUCHE - 6, y(t) + 4, 1);
        });
        ecrire(g, "temps du dessin, en secondes", (GAUCHE + droite) / 2, bas + 33, 0.5);
        ecrire(g, "erreur, en niveaux ; en gris, sous l'arrondi", 6, 14, 0);
    }

    private void peindrePoints(Graphics2D g) {
        Color accent = UIManager.getColor("Component.accentColor") == null ? encre()
                : UIManager.getColor("Component.accentColor");
        g.setStroke(new BasicStroke(1.5f));
        List<Shape> traits = new ArrayList<>();
        for (Reglage p : points) {
            double x = x(p.secondes);
            traits.add(new Line2D.Double(x, y(p.erreur - p.incertitude), x, y(p.erreur + p.incertitude)));
            if (echelle.indexOf(p) > 0) {
                Reglage avant = echelle.get(echelle.indexOf(p) - 1);
                traits.add(new Line2D.Double(x(avant.secondes), y(avant.erreur), x, y(p.erreur)));
            }
        }
        traits.forEach(trait -> trait(g, trait, accent));
        for (Reglage p : points) {
            Shape disque = disque(p, RAYON);
            g.setColor(p.borne ? UIManager.getColor("Tree.background") : accent);
            g.fill(disque);
            trait(g, disque, accent);
            traits.add(disque(p, p == ici ? 2 * RAYON : RAYON));
            if (p == ici) {
                trait(g, disque(p, 2 * RAYON), encre());
            }
            if (p == choisi) {
                trait(g, disque(p, RAYON + 3).getBounds(), encre());
            }
        }
        if (ici != null) {
            nommer(g, "ici : " + ici.nom, ici, traits);
        }
        echelle.stream().filter(p -> p != ici).forEach(p -> nommer(g, p.nom, p, traits));
    }

    /** Écrit le nom d'un point près de lui, à la première place où il ne touche ni un trait, ni un autre nom. */
    private void nommer(Graphics2D g, String nom, Reglage p, List<Shape> pris) {
        double large = g.getFontMetrics().stringWidth(nom);
        double haut = g.getFontMetrics().getAscent();
        for (int k = 0; k < 16; k++) {
            // à droite, puis à gauche ; au-dessus, puis au-dessous ; de plus en plus loin
            double x = x(p.secondes) + (k % 4 < 2 ? 2 * RAYON : -2 * RAYON - large);
            double y = y(p.erreur) + (k % 2 == 0 ? -RAYON - haut * (k / 4) : RAYON + haut * (k / 4 + 1));
            Rectangle2D place = new Rectangle2D.Double(x - 2, y - haut, large + 4, haut + 2);
            if (x > GAUCHE && x + large < getWidth() - DROITE && y - haut > HAUT && y < getHeight() - BAS
                    && pris.stream().noneMatch(forme -> forme.intersects(place))) {
                ecrire(g, nom, x, y, 0);
                pris.add(place);
                return;
            }
        }
    }

    private Ellipse2D disque(Reglage p, int rayon) {
        return new Ellipse2D.Double(x(p.secondes) - rayon, y(p.erreur) - rayon, 2 * rayon, 2 * rayon);
    }

    private static Color encre() {
        return UIManager.getColor("Tree.textForeground");
    }

    private static void trait(Graphics2D g, Shape forme, Color couleur) {
        g.setColor(couleur);
        g.draw(forme);
    }

    /** @param cale 0 pour écrire à partir de x, 1 pour finir en x */
    private static void ecrire(Graphics2D g, String texte, double x, double y, double cale) {
        g.setColor(encre());
        g.drawString(texte, (float) (x - cale * g.getFontMetrics().stringWidth(texte)), (float) y);
    }

    /** Les 1, 2 et 5 fois une puissance de dix entre ces bornes. */
    private static DoubleStream graduations(double min, double max) {
        return IntStream.range(-18, 21).mapToDouble(k -> new int[] {1, 2, 5}[Math.floorMod(k, 3)]
                * Math.pow(10, Math.floorDiv(k, 3))).filter(t -> t >= 0.999 * min && t <= 1.001 * max);
    }

    private static String nombre(double t) {
        return t >= 10 ? String.format(Locale.FRANCE, "%.0f", t)
                : String.format(Locale.FRANCE, "%.3f", t).replaceAll(",?0+$", "");
    }
}
