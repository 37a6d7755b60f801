package lancer.mesures.trace;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItem;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.block.FlowArrangement;
import org.jfree.chart.plot.Plot;
import org.jfree.chart.plot.PlotRenderingInfo;
import org.jfree.chart.plot.PlotState;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.ui.HorizontalAlignment;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.VerticalAlignment;

/**
 * Une image de courbes : un titre qui énonce le constat, des volets ou des vignettes en rangées, une légende, l'origine des mesures. Elle
 * ne demande pas d'écran.
 */
public final class Planche {

    private final String titre;
    private final String note;
    /** Ce qui dessine chaque volet ou chaque vignette dans un rectangle. */
    private final List<BiConsumer<Graphics2D, Rectangle2D>> cases = new ArrayList<>();

    /** Légende commune des volets, sans doublon. */
    private final Map<String, LegendItem> legende = new LinkedHashMap<>();
    private int colonnes = Integer.MAX_VALUE;
    private int largeur = Style.LARGEUR;
    private int hauteur = Style.HAUTEUR;

    /**
     * @param titre le constat
     * @param note ce qu'il faut savoir pour comparer : machine, date, taille des images
     */
    public Planche(String titre, String note) {
        this.titre = titre;
        this.note = note;
    }

    /** Change la taille, en pixels, sans changer celle des caractères. */
    public Planche taille(int largeur, int hauteur) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        return this;
    }

    /** Change le nombre de volets ou de vignettes par rangée ; tous, si rien n'est dit. */
    public Planche colonnes(int colonnes) {
        this.colonnes = colonnes;
        return this;
    }

    public Planche volet(Volet volet) {
        JFreeChart graphique = volet.graphique();
        cases.add(graphique::draw);
        LegendItemCollection siens = graphique.getPlot().getLegendItems();
        IntStream.range(0, siens.getItemCount()).mapToObj(siens::get).forEach(s -> legende.putIfAbsent(s.getLabel(), s));
        return this;
    }

    /** Ajoute une image, sous un nom et un détail d'une ligne chacun. */
    public Planche vignette(BufferedImage image, String nom, String detail) {
        cases.add((g, place) -> dessiner(g, place, image, nom, detail));
        return this;
    }

    /** Écrit l'image en entier ou pas du tout. */
    public void ecrire(Path fichier) throws IOException {
        Path provisoire = fichier.resolveSibling(fichier.getFileName() + ".tmp");
        ImageIO.write(dessiner(), "png", provisoire.toFile());
        Files.move(provisoire, fichier, StandardCopyOption.REPLACE_EXISTING);
    }

    BufferedImage dessiner() {
        JFreeChart planche = new JFreeChart(null, null, new Rangees(), false);
        planche.setBackgroundPaint(Color.WHITE);
        planche.setTextAntiAlias(true);
        planche.setPadding(new RectangleInsets(Style.MARGE / 2.0, Style.MARGE, Style.MARGE / 2.0, Style.MARGE));
        planche.setTitle(Style.titre(titre, Style.TITRE, Style.ENCRE));
        TextTitle origine = Style.titre(note, Style.NOTE, Style.GRIS);
        origine.setPosition(RectangleEdge.BOTTOM);
        planche.addSubtitle(origine);
        if (!legende.isEmpty()) {
            planche.addSubtitle(legende());
        }
        return planche.createBufferedImage(largeur, hauteur, BufferedImage.TYPE_INT_RGB, null);
    }

    private LegendTitle legende() {
        LegendItemCollection items = new LegendItemCollection();
        legende.values().forEach(items::add);
        LegendTitle titres = new LegendTitle(() -> items,
                new FlowArrangement(HorizontalAlignment.LEFT, VerticalAlignment.CENTER, 24, 2), new FlowArrangement());
        titres.setPosition(RectangleEdge.BOTTOM);
        titres.setHorizontalAlignment(HorizontalAlignment.LEFT);
        titres.setItemFont(Style.TEXTE);
        titres.setItemPaint(Style.ENCRE);
        titres.setLegendItemGraphicPadding(new RectangleInsets(0, 6, 0, 6));
        return titres;
    }

    /** Dessine une vignette, agrandie sans lissage. */
    private static void dessiner(Graphics2D g, Rectangle2D place, BufferedImage image, String nom, String detail) {
        g.setFont(Style.TEXTE);
        int ligne = g.getFontMetrics().getHeight();
        double echelle = Math.min((place.getWidth() - 12) / image.getWidth(), (place.getHeight() - 2 * ligne - 18) / image.getHeight());
        int l = (int) (echelle * image.getWidth());
        int h = (int) (echelle * image.getHeight());
        int x = (int) (place.getX() + (place.getWidth() - l) / 2);
        int y = (int) place.getY() + ligne;
        g.setColor(Style.ENCRE);
        g.drawString(nom, x, y);
        g.setColor(Style.GRIS);
        g.drawString(detail, x, y + ligne);
        g.drawImage(image, x, y + ligne + 12, l, h, null);
        g.setStroke(Style.TRAIT_FIN);
        g.drawRect(x, y + ligne + 12, l, h);
    }

    /** Les cases, en rangées de même hauteur. */
    private final class Rangees extends Plot {

        private static final long serialVersionUID = 1;

        @Override
        public String getPlotType() {
            return "rangées";
        }

        @Override
        public void draw(Graphics2D g, Rectangle2D place, Point2D ancre, PlotState etat, PlotRenderingInfo infos) {
            int parRangee = Math.min(colonnes, cases.size());
            double l = place.getWidth() / parRangee;
            double h = place.getHeight() / ((cases.size() + parRangee - 1) / parRangee);
            for (int k = 0; k < cases.size(); k++) {
                cases.get(k).accept(g, new Rectangle2D.Double(place.getX() + k % parRangee * l, place.getY() + k / parRangee * h, l,
                        h - 10));
            }
        }
    }
}
