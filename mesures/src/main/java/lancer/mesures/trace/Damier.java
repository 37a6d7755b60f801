package lancer.mesures.trace;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.jfree.chart.ui.RectangleEdge;

/** Une part, de 0 à 1, en chaque case de deux axes logarithmiques : blanche si elle est nulle, d'autant plus sombre qu'elle est grande. */
public final class Damier implements Contenu {

    /** Dégradé d'une part non nulle : le plus clair se distingue encore du blanc. */
    private static final Color CLAIR = new Color(0xF9D9BF);
    private static final Color SOMBRE = new Color(0x7A1F00);
    private static final double BAS = 100;
    private static final double GAUCHE = 116;

    private final String constat;
    private final String sujet;
    private final Axe axeX;
    private final Axe axeY;
    private final double pasX;
    private final double pasY;
    private final List<double[]> cases = new ArrayList<>();

    /**
     * @param constat ce que montre le damier, en une phrase
     * @param xs bornes de l'axe horizontal
     * @param ys bornes de l'axe vertical, dont la plus petite est en haut
     * @param pasX rapport des bornes d'une case
     */
    public Damier(String constat, String sujet, String nomX, double[] xs, double pasX, String nomY, double[] ys, double pasY) {
        this.constat = constat;
        this.sujet = sujet;
        this.pasX = pasX;
        this.pasY = pasY;
        axeX = new Axe(nomX, xs[0], xs[1], 0);
        axeY = new Axe(nomY, ys[0], ys[1], 0);
        axeY.setInverted(true);
    }

    /** @param x centre de la case (moyenne géométrique de ses bornes) */
    public Damier caseEn(double x, double y, double part) {
        cases.add(new double[] {x, y, part});
        return this;
    }

    @Override
    public List<Serie> series() {
        return Arrays.asList(signe("quelquefois", couleur(0.02)), signe("une fois sur deux", couleur(0.5)), signe("toujours", couleur(1)),
                signe("sans objet : les deux réponses se valent", Style.GRILLE));
    }

    private static Serie signe(String nom, Color couleur) {
        return new Serie(nom, couleur, FormeDePoint.CARRE, false, Collections.emptyList());
    }

    @Override
    public double enTete(Graphics2D g, double largeur) {
        return phrase(g, largeur).hauteur() + g.getFontMetrics(Style.SOUS_TITRE).getHeight() + 16;
    }

    private Paragraphe phrase(Graphics2D g, double largeur) {
        return new Paragraphe(g, constat, Style.CONSTAT, largeur - 24);
    }

    @Override
    public void dessiner(Graphics2D g, Rectangle2D place, double enTete) {
        Paragraphe phrase = phrase(g, place.getWidth());
        phrase.dessiner(g, place.getX() + 8, place.getY(), Style.ENCRE);
        new Paragraphe(g, sujet, Style.SOUS_TITRE, place.getWidth()).dessiner(g, place.getX() + 8, place.getY() + phrase.hauteur() + 2,
                Style.GRIS);
        double haut = place.getY() + enTete;
        Rectangle2D cadre = new Rectangle2D.Double(place.getX() + GAUCHE, haut, place.getWidth() - GAUCHE - 24,
                place.getMaxY() - haut - BAS);
        g.setColor(Style.GRILLE);
        g.fill(cadre);
        for (double[] c : cases) {
            double x0 = axeX.valueToJava2D(c[0] / Math.sqrt(pasX), cadre, RectangleEdge.BOTTOM);
            double x1 = axeX.valueToJava2D(c[0] * Math.sqrt(pasX), cadre, RectangleEdge.BOTTOM);
            double y0 = axeY.valueToJava2D(c[1] / Math.sqrt(pasY), cadre, RectangleEdge.LEFT);
            double y1 = axeY.valueToJava2D(c[1] * Math.sqrt(pasY), cadre, RectangleEdge.LEFT);
            g.setColor(couleur(c[2]));
            g.fill(new Rectangle2D.Double(Math.rint(x0), Math.rint(y0), Math.rint(x1) - Math.rint(x0), Math.rint(y1) - Math.rint(y0)));
        }
        axeX.draw(g, cadre.getMaxY(), place, cadre, RectangleEdge.BOTTOM, null);
        axeY.draw(g, cadre.getMinX(), place, cadre, RectangleEdge.LEFT, null);
        g.setStroke(Style.TRAIT_FIN);
        g.setColor(Style.GRIS);
        g.draw(cadre);
    }

    /** La couleur d'une part. */
    static Color couleur(double part) {
        return part <= 0 ? Color.WHITE : new Color(entre(CLAIR.getRed(), SOMBRE.getRed(), part),
                entre(CLAIR.getGreen(), SOMBRE.getGreen(), part), entre(CLAIR.getBlue(), SOMBRE.getBlue(), part));
    }

    private static int entre(int a, int b, double part) {
        return (int) Math.round(a + (b - a) * Math.min(1, part));
    }
}
