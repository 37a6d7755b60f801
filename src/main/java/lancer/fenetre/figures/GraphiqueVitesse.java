package lancer.fenetre.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import lancer.auto.Candidat;
import lancer.contrat.Section;

/** Des réglages, chacun un point : son prix en abscisse, son erreur en ordonnée, tous deux en échelle logarithmique. */
public final class GraphiqueVitesse extends JPanel {

    /** L'erreur que fait l'écran seul en arrondissant à un niveau entier : 1/√12. */
    public static final double ARRONDI = 1 / Math.sqrt(12);

    private static final long serialVersionUID = 1;

    private static final int GAUCHE = 58;
    private static final int DROITE = 18;
    private static final int HAUT = 26;
    private static final int BAS = 42;
    private static final int RAYON = 5;
    private static final int PORTEE = 12;
    private static final Color SOUS_L_ARRONDI = new Color(0xE4F1E4);
    private static final Color GRILLE = new Color(0xDDDDDD);
    private static final Color DOMINE = new Color(0xAAAAAA);
    private static final Color FRONT = new Color(0x1F5FA8);
    private static final Color MESURE = new Color(0xC0392B);

    private final transient Consumer<String> dire;
    private final transient List<Point> points = new ArrayList<>();
    private final transient List<double[]> mesures = new ArrayList<>();
    private transient Point ici;
    private String present = "";
    private int choisi = -1;
    private int version;
    private double xMin = 1;
    private double xMax = 10;
    private double yMin = 0.1;
    private double yMax = 10;

    /** Un réglage et ce qui en est attendu. Immuable, à la différence du réglage. */
    public static final class Point {
        private final Candidat reglage;
        private final boolean front;
        private final double rayons;
        private final double erreur;
        private final double auMoins;
        private final double auPlus;

        public Point(Candidat reglage, boolean front) {
            this.reglage = reglage;
            this.front = front;
            rayons = reglage.prix;
            erreur = reglage.erreur;
            auPlus = reglage.auPlus;
            auMoins = reglage.auMoins;
        }
    }

    /**
     * @param clic reçoit le réglage du point choisi
     * @param siAtteint reçoit ce qu'il y a à dire du point où mènent la souris et les flèches
     */
    public GraphiqueVitesse(Consumer<Candidat> clic, Consumer<String> siAtteint) {
        dire = siAtteint;
        setName("vitesse.graphique");
        setFocusable(true);
        getAccessibleContext().setAccessibleName("réglages, par prix et par erreur");
        MouseAdapter suiveur = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                if (sous(e) != null) {
                    dire.accept(legende(sous(e)));
                }
            }

            @Override
            public void mouseClicked(MouseEvent e) {
                requestFocusInWindow();
                viser(e, clic);
            }
        };
        addMouseListener(suiveur);
        addMouseMotionListener(suiveur);
        for (int touche : new int[] {KeyEvent.VK_LEFT, KeyEvent.VK_RIGHT}) {
            registerKeyboardAction(e -> avancer(touche == KeyEvent.VK_RIGHT ? 1 : -1),
                    KeyStroke.getKeyStroke(touche, 0), WHEN_IN_FOCUSED_WINDOW);
        }
        registerKeyboardAction(e -> {
            if (choisi >= 0 && choisi < front().size()) {
                clic.accept(front().get(choisi).reglage);
            }
        }, KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0), WHEN_IN_FOCUSED_WINDOW);
    }

    /** Combien de scènes ont été essayées. */
    public int getVersion() {
        return version;
    }

    public void vider() {
        version++;
        points.clear();
        mesures.clear();
        ici = null;
        choisi = -1;
        repaint();
    }

    /** @param nouvelIci les réglages présents, s'ils sont essayés */
    public void montrer(List<Point> nouveaux, Point nouvelIci) {
        points.clear();
        points.addAll(nouveaux);
        ici = nouvelIci;
        cadrer();
    }

    /** De quoi comparer des réglages. @param section celle de l'échantillonnage, {@code null} si c'est la scène */
    public static String cle(int reflets, double seuil, Section section) {
        return reflets + " " + seuil + " " + section;
    }

    public static String cle(Candidat reglage) {
        return cle(reglage.reflets, reglage.seuil, reglage.section);
    }

    /** @param cle celle des réglages de l'image montrée */
    public void setPresent(String cle) {
        present = cle;
        repaint();
    }

    public void ajouterMesure(double rayons, double erreur, double incertitude) {
        mesures.add(new double[] {rayons, erreur, incertitude});
        cadrer();
    }

    private boolean estPresent(Point p) {
        return cle(p.reglage).equals(present);
    }

    private List<Point> tous() {
        List<Point> tous = new ArrayList<>(points);
        if (ici != null) {
            tous.add(ici);
        }
        return tous;
    }

    private List<Point> front() {
        List<Point> front = new ArrayList<>(points);
        front.removeIf(p -> !p.front);
        front.sort(Comparator.comparingDouble(p -> p.rayons));
        return front;
    }

    private void cadrer() {
        xMin = tous().stream().mapToDouble(p -> p.rayons).min().orElse(1) / 1.3;
        xMax = tous().stream().mapToDouble(p -> p.rayons).max().orElse(10) * 1.3;
        yMin = ARRONDI / 3;
        yMax = Math.max(1, tous().stream().mapToDouble(p -> p.auPlus).max().orElse(10) * 1.3);
        repaint();
    }

    private double x(double rayons) {
        return GAUCHE + (getWidth() - GAUCHE - DROITE) * Math.log(rayons / xMin) / Math.log(xMax / xMin);
    }

    private double y(double erreur) {
        double part = Math.log(Math.max(erreur, yMin) / yMin) / Math.log(yMax / yMin);
        return getHeight() - BAS - (getHeight() - HAUT - BAS) * part;
    }

    private void avancer(int pas) {
        choisi = Math.max(0, Math.min(front().size() - 1, choisi + pas));
        if (!front().isEmpty()) {
            dire.accept(legende(front().get(choisi)));
        }
        repaint();
    }

    private Point sous(MouseEvent e) {
        return tous().stream().filter(p -> e.getPoint().distance(x(p.rayons), y(p.erreur)) < PORTEE)
                .min(Comparator.comparingDouble(p -> e.getPoint().distance(x(p.rayons), y(p.erreur)))).orElse(null);
    }

    private void viser(MouseEvent e, Consumer<Candidat> clic) {
        Point vise = sous(e);
        if (vise != null) {
            choisi = front().indexOf(vise);
            clic.accept(vise.reglage);
        }
    }

    /** Le réglage en mots, son prix, et ce qu'on y gagne sur le présent. */
    private String legende(Point p) {
        String gain = tous().stream().filter(this::estPresent).findFirst().filter(autre -> autre != p)
                .map(autre -> String.format(Locale.FRANCE, " ; au lieu du présent, %s rayons et %s erreur",
                        fois(p.rayons / autre.rayons), fois(p.erreur / autre.erreur))).orElse("");
        String erreur = auPlus(p) ? String.format(Locale.FRANCE, "d'au plus %.2f", p.auPlus)
                : String.format(Locale.FRANCE, "de %.2f à %.2f", p.auMoins, p.auPlus);
        return enMots(p.reglage) + String.format(Locale.FRANCE, " — %.1f rayons par pixel, erreur %s niveau%s",
                p.rayons, erreur, p.auPlus < 2 ? "" : "x") + gain;
    }

    /** Le réglage tel qu'on le dirait : {@code 16 rayons là où c'est utile, reflets : 10}. */
    private static String enMots(Candidat reglage) {
        String n = reglage.section == null ? null : reglage.section.valeur("n");
        String rayons = n == null ? reglage.toString().replaceFirst(", .*", "")
                : n.equals("1") ? "un rayon par pixel" : Math.round(Math.pow(Double.parseDouble(n), 2))
                + " rayons là où c'est utile, seuil " + reglage.section.valeur("seuil");
        return rayons + ", reflets : " + reglage.reflets;
    }

    /** Dit si l'erreur attendue peut être nulle : seule sa plus grande valeur est alors sûre. */
    private boolean auPlus(Point p) {
        return p.auMoins <= yMin;
    }

    private static String fois(double rapport) {
        return String.format(Locale.FRANCE, rapport < 1 ? "%.1f fois moins de" : "%.1f fois plus de",
                rapport < 1 ? 1 / rapport : rapport);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, getWidth(), getHeight());
        if (!points.isEmpty()) {
            peindreAxes(g);
            peindrePoints(g);
        }
        g.dispose();
    }

    private void peindreAxes(Graphics2D g) {
        double droite = (double) getWidth() - DROITE;
        double bas = (double) getHeight() - BAS;
        g.setColor(SOUS_L_ARRONDI);
        g.fill(new Rectangle2D.Double(GAUCHE, y(ARRONDI), droite - GAUCHE, bas - y(ARRONDI)));
        g.setFont(g.getFont().deriveFont(Font.PLAIN, g.getFont().getSize2D() * 0.9f));
        for (double t : graduations(xMin, xMax)) {
            trait(g, x(t), HAUT, x(t), bas, GRILLE);
            ecrire(g, nombre(t), x(t), bas + 15, 0.5);
        }
        for (double t : graduations(yMin, yMax)) {
            trait(g, GAUCHE, y(t), droite, y(t), GRILLE);
            ecrire(g, nombre(t), GAUCHE - 6.0, y(t) + 4, 1);
        }
        trait(g, GAUCHE, HAUT, droite, HAUT, Color.BLACK);
        trait(g, GAUCHE, bas, droite, bas, Color.BLACK);
        trait(g, GAUCHE, HAUT, GAUCHE, bas, Color.BLACK);
        ecrire(g, "sous l'arrondi de l'écran", GAUCHE + 4.0, bas - 5, 0);
        ecrire(g, "rayons de toutes sortes par pixel", (GAUCHE + droite) / 2, bas + 33, 0.5);
        ecrire(g, "erreur attendue (niveaux sur 255)", 6, 14, 0);
    }

    private void peindrePoints(Graphics2D g) {
        Path2D ligne = new Path2D.Double();
        for (Point p : front()) {
            if (ligne.getCurrentPoint() == null) {
                ligne.moveTo(x(p.rayons), y(p.erreur));
            } else {
                ligne.lineTo(x(p.rayons), y(p.erreur));
            }
        }
        g.setColor(FRONT);
        g.setStroke(new BasicStroke(1.5f));
        g.draw(ligne);
        for (Point p : tous()) {
            Color couleur = p.front ? FRONT : DOMINE;
            if (auPlus(p)) {
                // au plus : un plafond, et une flèche vers le bas
                trait(g, x(p.rayons) - RAYON, y(p.auPlus), x(p.rayons) + RAYON, y(p.auPlus), couleur);
                trait(g, x(p.rayons) - RAYON, y(yMin) - 2 * RAYON, x(p.rayons), y(yMin) - RAYON, couleur);
                trait(g, x(p.rayons) + RAYON, y(yMin) - 2 * RAYON, x(p.rayons), y(yMin) - RAYON, couleur);
            }
            trait(g, x(p.rayons), auPlus(p) ? y(yMin) - RAYON : y(p.auMoins), x(p.rayons), y(p.auPlus), couleur);
            g.fill(disque(p.rayons, p.erreur, p.front ? RAYON : RAYON - 2));
            if (p == ici ? points.stream().noneMatch(this::estPresent) : estPresent(p)) {
                g.setColor(Color.BLACK);
                g.draw(disque(p.rayons, p.erreur, 2.0 * RAYON));
            }
        }
        for (double[] m : mesures) {
            trait(g, x(m[0]), y(m[1] - m[2]), x(m[0]), y(m[1] + m[2]), MESURE);
            g.draw(disque(m[0], m[1], RAYON));
        }
        List<Point> front = front();
        if (choisi >= 0 && choisi < front.size()) {
            Point p = front.get(choisi);
            g.setColor(Color.BLACK);
            g.draw(new Rectangle2D.Double(x(p.rayons) - 8, y(p.erreur) - 8, 16, 16));
        }
    }

    private Ellipse2D disque(double rayons, double erreur, double rayon) {
        return new Ellipse2D.Double(x(rayons) - rayon, y(erreur) - rayon, 2 * rayon, 2 * rayon);
    }

    private static void trait(Graphics2D g, double x0, double y0, double x1, double y1, Color couleur) {
        g.setColor(couleur);
        g.draw(new Line2D.Double(x0, y0, x1, y1));
    }

    /** @param cale 0 : à partir de x ; 1 : jusqu'à x */
    private static void ecrire(Graphics2D g, String texte, double x, double y, double cale) {
        g.setColor(Color.DARK_GRAY);
        g.drawString(texte, (float) (x - cale * g.getFontMetrics().stringWidth(texte)), (float) y);
    }

    /** Les 1, 2 et 5 fois une puissance de dix entre ces bornes ; d'autres aussi si elles sont proches. */
    private static List<Double> graduations(double min, double max) {
        List<Double> graduations = new ArrayList<>();
        double[] fois = max < 10 * min ? new double[] {1, 2, 3, 4, 5, 7} : new double[] {1, 2, 5};
        for (double dix = Math.pow(10, Math.floor(Math.log10(min))); dix <= max; dix *= 10) {
            for (double n : fois) {
                if (n * dix >= min && n * dix <= max) {
                    graduations.add(n * dix);
                }
            }
        }
        return graduations;
    }

    private static String nombre(double t) {
        return t >= 1 ? String.format(Locale.FRANCE, "%.0f", t)
                : String.format(Locale.FRANCE, "%.2f", t).replaceAll("0+$", "");
    }
}
