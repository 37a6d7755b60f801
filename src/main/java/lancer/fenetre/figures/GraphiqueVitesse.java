package lancer.fenetre.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Graphics;
import java.awt.RenderingHints;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.JPanel;
import javax.swing.UIManager;
import lancer.Constantes;
import lancer.auto.Candidat;

/** Graphique des réglages : temps en abscisse, erreur en ordonnée, en échelles logarithmiques. */
@SuppressWarnings("serial")
public final class GraphiqueVitesse extends JPanel {

    /** Erreur d'arrondi de l'écran, à un niveau entier. */
    private static final double ARRONDI = 1 / Math.sqrt(12);

    private static final double Y_MIN = ARRONDI / 3;
    private static final int GAUCHE = 58;
    private static final int DROITE = 18;
    private static final int HAUT = 26;
    private static final int BAS = 42;
    private static final int RAYON = 5;
    private static final int PORTEE = 12;
    private static final double NS_PAR_S = 1e9;
    private static final Color REFLET = new Color(0xE0503C);
    private final Consumer<String> siAtteint;
    private final Predicate<Candidat> estPresent;
    private List<Candidat> points = Collections.emptyList();
    /** Réglages dont aucun autre n'est à la fois plus rapide et plus juste, du moins cher au plus cher. */
    private List<Candidat> front = Collections.emptyList();
    private final List<double[]> mesures = new ArrayList<>();
    private int choisi = -1;
    /** Durée de l'image, en secondes, pour un rayon par pixel et une nanoseconde par rayon. */
    private double parRayon = 1;
    private double xMin;
    private double xMax;
    private double yMax;

    /** @param clic reçoit le réglage choisi @param siAtteint reçoit la légende du réglage sous la souris */
    public GraphiqueVitesse(Consumer<Candidat> clic, Consumer<String> siAtteint, Predicate<Candidat> estPresent) {
        this.siAtteint = siAtteint;
        this.estPresent = estPresent;
        setName("vitesse.graphique");
        setFocusable(true);
        getAccessibleContext().setAccessibleName("réglages, par temps et par erreur");
        MouseAdapter suiveur = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                if (sous(e) != null) {
                    dire(sous(e));
                }
            }

            @Override
            public void mousePressed(MouseEvent e) {
                requestFocusInWindow();
                Candidat vise = sous(e);
                if (vise != null) {
                    choisi = front.indexOf(vise);
                    clic.accept(vise);
                }
            }
        };
        addMouseListener(suiveur);
        addMouseMotionListener(suiveur);
        addKeyListener(new KeyAdapter() {
            @Override
            public void keyPressed(KeyEvent e) {
                int touche = e.getKeyCode();
                if (touche == KeyEvent.VK_LEFT || touche == KeyEvent.VK_RIGHT) {
                    avancer(touche == KeyEvent.VK_RIGHT ? 1 : -1);
                    e.consume();
                } else if (touche == KeyEvent.VK_ENTER && choisi >= 0) {
                    // si aucun point n'est choisi, Entrée sert à l'image
                    clic.accept(front.get(choisi));
                    e.consume();
                }
            }
        });
    }

    public void vider() {
        mesures.clear();
        choisi = -1;
        montrer(Collections.emptyList(), null, 1);
    }

    /**
     * @param ici les réglages de l'image, s'ils sont évalués, ou {@code null}
     * @param pixels nombre de pixels que dessine chaque fil
     */
    public void montrer(List<Candidat> essayes, Candidat ici, double pixels) {
        parRayon = pixels / NS_PAR_S;
        points = new ArrayList<>(essayes);
        if (ici != null && !aUnPresent()) {
            points.add(ici);
        }
        front = points.stream().filter(p -> points.stream().noneMatch(
                q -> secondes(q) < secondes(p) && q.erreur <= p.erreur))
                .sorted(Comparator.comparingDouble(this::secondes)).collect(Collectors.toList());
        choisi = Math.min(choisi, front.size() - 1);
        DoubleSummaryStatistics temps = points.stream().mapToDouble(this::secondes).summaryStatistics();
        xMin = temps.getMin() / 1.3;
        xMax = temps.getMax() * 1.3;
        yMax = Math.max(1, 1.3 * Math.max(points.stream().mapToDouble(p -> p.auPlus).max().orElse(0),
                mesures.stream().mapToDouble(mesure -> mesure[1] + mesure[2]).max().orElse(0)));
        repaint();
    }

    /** Temps estimé de l'image : nombre de ses rayons, multiplié par la durée d'un rayon des essais. */
    private double secondes(Candidat p) {
        return p.prix * p.nsParRayon * parRayon;
    }

    public boolean aUnPresent() {
        return points.stream().anyMatch(estPresent);
    }

    /** Ajoute un point mesuré sur l'image dessinée. @param temps en secondes */
    public void ajouterMesure(double temps, double erreur, double incertitude) {
        mesures.add(new double[] {temps, erreur, incertitude});
        montrer(points, null, parRayon * NS_PAR_S);
    }

    private double x(double temps) {
        return GAUCHE + (getWidth() - GAUCHE - DROITE) * Math.log(temps / xMin) / Math.log(xMax / xMin);
    }

    private double y(double erreur) {
        double part = Math.log(Math.max(erreur, Y_MIN) / Y_MIN) / Math.log(yMax / Y_MIN);
        return getHeight() - BAS - (getHeight() - HAUT - BAS) * part;
    }

    private void avancer(int pas) {
        if (!front.isEmpty()) {
            choisi = Math.max(0, Math.min(front.size() - 1, choisi + pas));
            dire(front.get(choisi));
            repaint();
        }
    }

    private void dire(Candidat p) {
        siAtteint.accept(legende(p));
        getAccessibleContext().setAccessibleDescription(legende(p));
    }

    private Candidat sous(MouseEvent e) {
        return points.stream().filter(p -> e.getPoint().distance(x(secondes(p)), y(p.erreur)) < PORTEE)
                .min(Comparator.comparingDouble(p -> e.getPoint().distance(x(secondes(p)), y(p.erreur)))).orElse(null);
    }

    /** Texte du réglage : prix, erreur, et comparaison avec les réglages de l'image. */
    private String legende(Candidat p) {
        String gain = points.stream().filter(estPresent).findFirst().filter(autre -> autre != p)
                .map(autre -> String.format(Locale.FRANCE, "\u00A0; au lieu du présent, %s de temps et %s d'erreur",
                        fois(secondes(p) / secondes(autre)), fois(p.erreur / autre.erreur))).orElse("");
        String erreur = auPlus(p) ? String.format(Locale.FRANCE, "d'au plus %.2f", p.auPlus)
                : String.format(Locale.FRANCE, "de %.2f à %.2f", p.auMoins, p.auPlus);
        return enMots(p) + String.format(Locale.FRANCE, " — %s s, %.1f rayons par pixel, erreur %s niveau%s",
                nombre(secondes(p)), p.prix, erreur, p.auPlus < 2 ? "" : "x") + gain;
    }

    /** Le réglage en mots, par exemple {@code 16 rayons là où c'est utile, reflets : 10}. */
    private static String enMots(Candidat reglage) {
        String n = reglage.section == null ? null : reglage.section.valeur("n");
        String rayons = n == null ? reglage.toString().replaceFirst(", .*", "")
                : n.equals("1") ? "un rayon par pixel" : Math.round(Math.pow(Double.parseDouble(n), 2))
                + " rayons là où c'est utile, seuil " + reglage.section.valeur("seuil");
        return rayons + ", reflets : " + reglage.reflets + (reglage.seuil == Constantes.SEUIL ? ""
                : reglage.seuil == 0 ? " sans seuil" : " jusqu'au seuil 1/" + Math.round(1 / reglage.seuil));
    }

    /** Dit si l'erreur attendue peut être nulle : seule sa borne supérieure est alors affichée. */
    private static boolean auPlus(Candidat p) {
        return p.auMoins <= Y_MIN;
    }

    private static String fois(double rapport) {
        return Math.abs(Math.log(rapport)) < 0.05 ? "autant" : String.format(Locale.FRANCE,
                rapport < 1 ? "%.1f fois moins" : "%.1f fois plus", Math.max(rapport, 1 / rapport));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(UIManager.getColor("Tree.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        if (!points.isEmpty()) {
            peindreAxes(g);
            peindrePoints(g);
        }
        g.dispose();
    }

    private void peindreAxes(Graphics2D g) {
        int droite = getWidth() - DROITE;
        int bas = getHeight() - BAS;
        g.setColor(UIManager.getColor("Panel.background"));
        g.fillRect(GAUCHE, (int) y(ARRONDI), droite - GAUCHE, bas - (int) y(ARRONDI));
        g.setFont(g.getFont().deriveFont(Font.PLAIN, g.getFont().getSize2D() * 0.9f));
        for (double t : graduations(xMin, xMax)) {
            trait(g, x(t), HAUT, x(t), bas, trame());
            ecrire(g, nombre(t), x(t), bas + 15, 0.5);
        }
        for (double t : graduations(Y_MIN, yMax)) {
            trait(g, GAUCHE, y(t), droite, y(t), trame());
            ecrire(g, nombre(t), GAUCHE - 6, y(t) + 4, 1);
        }
        g.setColor(gris());
        g.drawRect(GAUCHE, HAUT, droite - GAUCHE, bas - HAUT);
        ecrire(g, "sous l'arrondi de l'écran", droite - 4, y(ARRONDI) + 14, 1);
        ecrire(g, "temps de l'image sur cette machine (secondes)", (GAUCHE + droite) / 2, bas + 33, 0.5);
        ecrire(g, "erreur attendue (niveaux sur 255)", 6, 14, 0);
    }

    private void peindrePoints(Graphics2D g) {
        g.setStroke(new BasicStroke(1.5f));
        for (int k = 1; k < front.size(); k++) {
            Candidat avant = front.get(k - 1);
            trait(g, x(secondes(avant)), y(avant.erreur), x(secondes(front.get(k))), y(front.get(k).erreur), accent());
        }
        for (Candidat p : points) {
            Color couleur = front.contains(p) ? accent() : gris();
            double x = x(secondes(p));
            double pied = auPlus(p) ? y(Y_MIN) - RAYON : y(p.auMoins);
            trait(g, x, pied, x, y(p.auPlus), couleur);
            if (auPlus(p)) {
                // borne supérieure : un trait horizontal, et une flèche vers le bas
                trait(g, x - RAYON, y(p.auPlus), x + RAYON, y(p.auPlus), couleur);
                trait(g, x - RAYON, pied - RAYON, x, pied, couleur);
                trait(g, x + RAYON, pied - RAYON, x, pied, couleur);
            }
            g.fill(disque(secondes(p), p.erreur, front.contains(p) ? RAYON : RAYON - 2));
            g.setColor(encre());
            if (estPresent.test(p)) {
                g.draw(disque(secondes(p), p.erreur, 2 * RAYON));
                nommer(g, "ici : ", p, -2 * RAYON);
            }
            if (choisi >= 0 && p == front.get(choisi)) {
                g.drawRect((int) x - 8, (int) y(p.erreur) - 8, 16, 16);
            }
        }
        front.stream().filter(p -> p.erreur <= ARRONDI).findFirst().filter(p -> !estPresent.test(p))
                .ifPresent(p -> nommer(g, "assez pour l'œil : ", p, 4 * RAYON));
        for (double[] m : mesures) {
            trait(g, x(m[0]), y(m[1] - m[2]), x(m[0]), y(m[1] + m[2]), REFLET);
            g.draw(disque(m[0], m[1], RAYON));
        }
    }

    /** Écrit le nom de ce point, décalé de {@code dy}, dans le cadre. */
    private void nommer(Graphics2D g, String debut, Candidat p, int dy) {
        String nom = debut + enMots(p).replaceFirst(",.*", "");
        double droite = getWidth() - DROITE - g.getFontMetrics().stringWidth(nom);
        ecrire(g, nom, Math.max(GAUCHE + RAYON, Math.min(droite, x(secondes(p)) + 3 * RAYON)), y(p.erreur) + dy, 0);
    }

    private static Color encre() {
        return UIManager.getColor("Tree.textForeground");
    }

    private static Color accent() {
        Color accent = UIManager.getColor("Component.accentColor");
        return accent == null ? encre() : accent;
    }

    private static Color gris() {
        return UIManager.getColor("Label.disabledForeground");
    }

    private static Color trame() {
        Color gris = gris();
        return new Color(gris.getRed(), gris.getGreen(), gris.getBlue(), 60);
    }

    private Ellipse2D disque(double temps, double erreur, int rayon) {
        return new Ellipse2D.Double(x(temps) - rayon, y(erreur) - rayon, 2 * rayon, 2 * rayon);
    }

    private static void trait(Graphics2D g, double x0, double y0, double x1, double y1, Color couleur) {
        g.setColor(couleur);
        g.draw(new Line2D.Double(x0, y0, x1, y1));
    }

    /** @param cale 0 pour écrire à partir de x, 1 pour finir en x */
    private static void ecrire(Graphics2D g, String texte, double x, double y, double cale) {
        g.setColor(encre());
        g.drawString(texte, (float) (x - cale * g.getFontMetrics().stringWidth(texte)), (float) y);
    }

    /** Les 1, 2 et 5 fois une puissance de dix entre ces bornes ; d'autres aussi si les bornes sont proches. */
    private static List<Double> graduations(double min, double max) {
        double[] fois = max < 10 * min ? new double[] {1, 2, 3, 4, 5, 7} : new double[] {1, 2, 5};
        return IntStream.range(-3, 10).boxed().flatMap(k -> Arrays.stream(fois).mapToObj(n -> n * Math.pow(10, k)))
                .filter(t -> t >= min && t <= max).collect(Collectors.toList());
    }

    private static String nombre(double t) {
        return t >= 10 ? String.format(Locale.FRANCE, "%.0f", t)
                : String.format(Locale.FRANCE, t >= 0.1 ? "%.2f" : "%.3f", t).replaceAll(",?0+$", "");
    }
}
