package lancer.mesures.trace;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.block.FlowArrangement;
import org.jfree.chart.block.RectangleConstraint;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.ui.HorizontalAlignment;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.VerticalAlignment;

/**
 * Une image de courbes : un titre qui énonce le constat, des volets ou des vignettes, une légende, l'origine des mesures. Elle ne demande
 * pas d'écran.
 */
public final class Planche {

    private final String titre;
    private final String note;
    private final List<Volet> volets = new ArrayList<>();

    /** Vignettes en rangées, avec pour chacune un nom et un détail, d'une ligne chacun. */
    private final List<BufferedImage> vignettes = new ArrayList<>();
    private final List<String[]> noms = new ArrayList<>();
    private int vignettesParRangee = 3;
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

    /** Change le nombre de volets par rangée. */
    public Planche colonnes(int colonnes) {
        this.colonnes = colonnes;
        return this;
    }

    /** Change le nombre de vignettes par rangée. */
    public Planche vignettes(int parRangee) {
        vignettesParRangee = parRangee;
        return this;
    }

    public Planche volet(Volet volet) {
        volets.add(volet);
        return this;
    }

    public Planche vignette(BufferedImage image, String nom, String detail) {
        vignettes.add(image);
        noms.add(new String[] {nom, detail});
        return this;
    }

    /** Écrit l'image en entier ou pas du tout. */
    public void ecrire(Path fichier) throws IOException {
        BufferedImage image = dessiner();
        Path provisoire = fichier.resolveSibling(fichier.getFileName() + ".tmp");
        ImageIO.write(image, "png", provisoire.toFile());
        Files.move(provisoire, fichier, StandardCopyOption.REPLACE_EXISTING);
    }

    BufferedImage dessiner() {
        BufferedImage image = new BufferedImage(largeur, hauteur, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, largeur, hauteur);
        double utile = largeur - 2 * Style.MARGE;
        double haut = Style.MARGE / 2.0;
        haut += Style.texte(g, titre, Style.TITRE, Style.ENCRE, Style.MARGE, haut, utile, true) + 12;
        double bas = hauteur - Style.MARGE / 2.0;
        bas -= Style.texte(g, note, Style.NOTE, Style.GRIS, Style.MARGE, bas, utile, false);
        Style.texte(g, note, Style.NOTE, Style.GRIS, Style.MARGE, bas, utile, true);
        bas -= legender(g, bas, utile) + 10;
        montrer(g, haut, utile / vignettesParRangee, bas - haut - 10);
        int parRangee = Math.min(colonnes, volets.size());
        double h = volets.isEmpty() ? 0 : (bas - haut) / ((volets.size() + parRangee - 1) / parRangee);
        for (int k = 0; k < volets.size(); k += parRangee) {
            rangee(g, volets.subList(k, Math.min(volets.size(), k + parRangee)), haut, h - 10);
            haut += h;
        }
        g.dispose();
        return image;
    }

    /** Dessine les vignettes, agrandies sans lissage. */
    private void montrer(Graphics2D g, double haut, double largeur, double place) {
        double hauteur = place / ((vignettes.size() + vignettesParRangee - 1) / vignettesParRangee);
        double ligne = g.getFontMetrics(Style.TEXTE).getHeight();
        g.setStroke(Style.TRAIT_FIN);
        for (int k = 0; k < vignettes.size(); k++) {
            BufferedImage image = vignettes.get(k);
            double echelle = Math.min((largeur - 12) / image.getWidth(), (hauteur - 2 * ligne - 18) / image.getHeight());
            int l = (int) (echelle * image.getWidth());
            int h = (int) (echelle * image.getHeight());
            int x = (int) (Style.MARGE + k % vignettesParRangee * largeur + (largeur - l) / 2);
            double y = haut + k / vignettesParRangee * hauteur;
            Style.texte(g, noms.get(k)[0], Style.TEXTE, Style.ENCRE, x, y, largeur, true);
            Style.texte(g, noms.get(k)[1], Style.TEXTE, Style.GRIS, x, y + ligne, largeur, true);
            g.drawImage(image, x, (int) (y + 2 * ligne + 4), l, h, null);
            g.setColor(Style.GRIS);
            g.drawRect(x, (int) (y + 2 * ligne + 4), l, h);
        }
    }

    /** Dessine des volets côte à côte, avec la même hauteur d'en-tête. */
    private void rangee(Graphics2D g, List<Volet> siens, double haut, double h) {
        double l = (largeur - 2.0 * Style.MARGE) / siens.size();
        double enTete = siens.stream().mapToDouble(v -> v.enTete(g, l)).max().orElse(0);
        for (int k = 0; k < siens.size(); k++) {
            siens.get(k).dessiner(g, new Rectangle2D.Double(Style.MARGE + k * l, haut, l, h), enTete);
        }
    }

    /** Dessine la légende commune des volets, sans doublon, au-dessus de {@code bas}. @return sa hauteur */
    private double legender(Graphics2D g, double bas, double utile) {
        LegendItemCollection tous = new LegendItemCollection();
        volets.forEach(v -> tous.addAll(v.legende()));
        LegendItemCollection items = new LegendItemCollection();
        Set<String> noms = new HashSet<>();
        IntStream.range(0, tous.getItemCount()).mapToObj(tous::get).filter(s -> noms.add(s.getLabel())).forEach(items::add);
        LegendTitle legende = new LegendTitle(() -> items,
                new FlowArrangement(HorizontalAlignment.LEFT, VerticalAlignment.CENTER, 24, 2), new FlowArrangement());
        legende.setItemFont(Style.TEXTE);
        legende.setItemPaint(Style.ENCRE);
        legende.setLegendItemGraphicPadding(new RectangleInsets(0, 6, 0, 6));
        double h = items.getItemCount() == 0 ? 0 : legende.arrange(g, RectangleConstraint.NONE.toFixedWidth(utile)).getHeight();
        if (h > 0) {
            legende.draw(g, new Rectangle2D.Double(Style.MARGE, bas - h, utile, h));
        }
        return h;
    }
}
