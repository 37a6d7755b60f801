package lancer.mesures.trace;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jfree.chart.LegendItem;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.LookupPaintScale;
import org.jfree.chart.renderer.xy.XYBlockRenderer;
import org.jfree.data.xy.DefaultXYZDataset;

/** Une part, de 0 à 1, en chaque case de deux axes logarithmiques : blanche si elle est nulle, d'autant plus sombre qu'elle est grande. */
public final class Damier extends Courbe {

    /** Dégradé d'une part non nulle : le plus clair se distingue encore du blanc. */
    private static final Color CLAIR = new Color(0xF9D9BF);
    private static final Color SOMBRE = new Color(0x7A1F00);

    private final String nomX;
    private final String nomY;
    private final double cote;
    private final List<double[]> cases = new ArrayList<>();

    /** @param cote rapport des bornes d'une case, sur chaque axe ; celui des ordonnées croît vers le bas */
    public Damier(String constat, String sujet, String nomX, String nomY, double cote) {
        super(constat, sujet);
        this.nomX = nomX;
        this.nomY = nomY;
        this.cote = Math.log10(cote);
    }

    /** @param x centre de la case (moyenne géométrique de ses bornes) */
    public Damier caseEn(double x, double y, double part) {
        cases.add(new double[] {Math.log10(x), Math.log10(y), part});
        return this;
    }

    @Override
    public List<LegendItem> legende() {
        return Arrays.asList(signe("quelquefois", couleur(0.02)), signe("une fois sur deux", couleur(0.5)), signe("toujours", couleur(1)),
                signe("sans objet : les deux réponses se valent", Style.GRILLE));
    }

    private static LegendItem signe(String nom, Color couleur) {
        return new LegendItem(nom, null, null, null, FormeDePoint.CARRE.dessin, couleur);
    }

    @Override
    XYPlot plot() {
        double[][] xyz = new double[3][cases.size()];
        for (int k = 0; k < 3 * cases.size(); k++) {
            xyz[k % 3][k / 3] = cases.get(k / 3)[k % 3];
        }
        DefaultXYZDataset donnees = new DefaultXYZDataset();
        donnees.addSeries("", xyz);
        XYBlockRenderer carres = new XYBlockRenderer();
        carres.setBlockWidth(cote);
        carres.setBlockHeight(cote);
        LookupPaintScale echelle = new LookupPaintScale(0, 1, Color.WHITE);
        for (int k = 1; k <= 100; k++) {
            echelle.add(k == 1 ? Double.MIN_VALUE : k / 100.0, couleur(k / 100.0));
        }
        carres.setPaintScale(echelle);
        NumberAxis axeY = axe(nomY, xyz[1]);
        axeY.setInverted(true);
        XYPlot plot = new XYPlot(donnees, axe(nomX, xyz[0]), axeY, carres);
        plot.setBackgroundPaint(Style.GRILLE);
        return plot;
    }

    private NumberAxis axe(String nom, double[] exposants) {
        NumberAxis axe = new NumberAxis(nom);
        axe.setRange(Arrays.stream(exposants).min().orElse(0) - cote / 2, Arrays.stream(exposants).max().orElse(1) + cote / 2);
        axe.setTickUnit(new NumberTickUnit(2) {
            private static final long serialVersionUID = 1;

            @Override
            public String valueToString(double exposant) {
                return exposant == 0 ? "1" : Style.puissance(Math.pow(10, exposant));
            }
        });
        return axe;
    }

    /** La couleur d'une part non nulle. */
    private static Color couleur(double part) {
        float[] clair = CLAIR.getRGBComponents(null);
        float[] sombre = SOMBRE.getRGBComponents(null);
        for (int k = 0; k < 3; k++) {
            clair[k] += (sombre[k] - clair[k]) * part;
        }
        return new Color(clair[0], clair[1], clair[2]);
    }
}
