package lancer.mesures.trace;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import javax.imageio.ImageIO;
import org.jfree.chart.JFreeChart;

/** Une image de plusieurs cases, en rangées : des graphiques, ou d'autres images sous leurs noms. Elle ne demande pas d'écran. */
public final class Planche {

    static {
        // à fixer avant la première couleur : si l'écran ne répond pas, Java refuserait de dessiner
        System.setProperty("java.awt.headless", "true");
    }

    /** Largeur, en pixels ; les pages la montrent deux fois plus petite. */
    static final int LARGEUR = 1600;

    private static final int MARGE = 12;
    private static final int LIGNE = 30;

    private final int colonnes;
    private final int hauteurDUneCase;

    /** Ce qui dessine chaque case dans un rectangle. */
    private final List<BiConsumer<Graphics2D, Rectangle2D>> cases = new ArrayList<>();

    private final List<Volet> volets = new ArrayList<>();

    public Planche(int colonnes, int hauteurDUneCase) {
        this.colonnes = colonnes;
        this.hauteurDUneCase = hauteurDUneCase;
    }

    public Planche volet(Volet volet) {
        volets.add(volet);
        JFreeChart graphique = volet.graphique();
        cases.add(graphique::draw);
        return this;
    }

    /** Faux si l'un des graphiques n'a aucun point entre ses axes. */
    public boolean seVoit() {
        return volets.stream().allMatch(Volet::aUnPoint);
    }

    /** Ajoute une image, agrandie sans lissage, sous un nom et un détail d'une ligne chacun. */
    public Planche vignette(BufferedImage image, String nom, String detail) {
        cases.add((g, place) -> {
            double echelle = Math.min((place.getWidth() - 2 * MARGE) / image.getWidth(),
                    (place.getHeight() - 2 * LIGNE - 2 * MARGE) / image.getHeight());
            int l = (int) (echelle * image.getWidth());
            int h = (int) (echelle * image.getHeight());
            int x = (int) place.getX() + MARGE;
            int y = (int) place.getY() + 2 * LIGNE + MARGE;
            g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 22));
            g.setStroke(new BasicStroke(2));
            g.setColor(Color.DARK_GRAY);
            g.drawString(nom, x, y - MARGE - LIGNE);
            g.drawString(detail, x, y - MARGE);
            g.drawImage(image, x, y, l, h, null);
            g.drawRect(x, y, l, h);
        });
        return this;
    }

    /** Écrit l'image en entier ou pas du tout. */
    public void ecrire(Path fichier) throws IOException {
        Path provisoire = fichier.resolveSibling(fichier.getFileName() + ".tmp");
        ImageIO.write(dessiner(), "png", provisoire.toFile());
        Files.move(provisoire, fichier, StandardCopyOption.REPLACE_EXISTING);
    }

    BufferedImage dessiner() {
        int rangees = (cases.size() + colonnes - 1) / colonnes;
        BufferedImage image = new BufferedImage(LARGEUR, rangees * hauteurDUneCase, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        int largeur = LARGEUR / colonnes;
        for (int k = 0; k < cases.size(); k++) {
            cases.get(k).accept(g, new Rectangle2D.Double(k % colonnes * largeur, k / colonnes * hauteurDUneCase, largeur,
                    hauteurDUneCase));
        }
        g.dispose();
        return image;
    }
}
