package lancer.mesures.trace;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
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
import javax.imageio.ImageIO;

/**
 * Une image de courbes : un titre qui dit ce qu'on y voit, des volets côte à côte, une légende, et d'où viennent les mesures.
 * Toutes ont la même taille. Ne demande pas d'écran.
 */
public final class Planche {

    private static final int LARGEUR_SIGNE = 44;
    private static final int ENTRE_NOMS = 36;

    private final String titre;
    private final String note;
    private final List<Contenu> contenus = new ArrayList<>();
    private final List<Double> parts = new ArrayList<>();

    /**
     * @param titre le constat
     * @param note machine, date, taille des images : ce qu'il faut savoir pour comparer
     */
    public Planche(String titre, String note) {
        this.titre = titre;
        this.note = note;
    }

    /** @param part de la largeur, comparée aux autres volets */
    public Planche volet(Contenu contenu, double part) {
        contenus.add(contenu);
        parts.add(part);
        return this;
    }

    /** Écrit l'image, d'un coup : un fichier à moitié écrit ne remplace pas l'ancien. */
    public void ecrire(Path fichier) throws IOException {
        BufferedImage image = dessiner();
        Path provisoire = fichier.resolveSibling(fichier.getFileName() + ".tmp");
        ImageIO.write(image, "png", provisoire.toFile());
        Files.move(provisoire, fichier, StandardCopyOption.REPLACE_EXISTING);
    }

    BufferedImage dessiner() {
        BufferedImage image = new BufferedImage(Style.LARGEUR, Style.HAUTEUR, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, Style.LARGEUR, Style.HAUTEUR);
        double largeur = Style.LARGEUR - 2 * Style.MARGE;
        Paragraphe titreEcrit = new Paragraphe(g, titre, Style.TITRE, largeur);
        titreEcrit.dessiner(g, Style.MARGE, Style.MARGE / 2.0, Style.ENCRE);
        Paragraphe pied = new Paragraphe(g, note, Style.NOTE, largeur);
        double bas = Style.HAUTEUR - Style.MARGE / 2.0 - pied.hauteur();
        pied.dessiner(g, Style.MARGE, bas, Style.GRIS);
        List<List<Signe>> legende = legende(g, largeur);
        double hauteurLigne = 1.35 * g.getFontMetrics(Style.LEGENDE).getHeight();
        bas -= legende.size() * hauteurLigne + 6;
        for (int k = 0; k < legende.size(); k++) {
            ligneDeLegende(g, legende.get(k), bas + (k + 0.5) * hauteurLigne);
        }
        volets(g, Style.MARGE / 2.0 + titreEcrit.hauteur() + 12, bas - 6);
        g.dispose();
        return image;
    }

    /** Côte à côte, tous sous la même hauteur de texte. */
    private void volets(Graphics2D g, double haut, double bas) {
        double largeur = Style.LARGEUR - 2 * Style.MARGE;
        double somme = parts.stream().mapToDouble(Double::doubleValue).sum();
        double enTete = 0;
        for (int k = 0; k < contenus.size(); k++) {
            enTete = Math.max(enTete, contenus.get(k).enTete(g, parts.get(k) / somme * largeur));
        }
        double x = Style.MARGE;
        for (int k = 0; k < contenus.size(); k++) {
            double part = parts.get(k) / somme * largeur;
            contenus.get(k).dessiner(g, new Rectangle2D.Double(x, haut, part, bas - haut), enTete);
            x += part;
        }
    }

    /** Un dessin et son nom. */
    private static final class Signe {
        private final String nom;
        private final Serie serie;
        private final double largeur;

        Signe(Graphics2D g, String nom, Serie serie) {
            this.nom = nom;
            this.serie = serie;
            largeur = LARGEUR_SIGNE + g.getFontMetrics(Style.LEGENDE).stringWidth(nom) + ENTRE_NOMS;
        }
    }

    private static final String FRONT = "le front : rien ne le bat";
    private static final String DEFAUT = "défaut";

    private List<List<Signe>> legende(Graphics2D g, double largeur) {
        Map<String, Signe> signes = new LinkedHashMap<>();
        for (Contenu contenu : contenus) {
            for (Serie serie : contenu.series()) {
                if (!serie.nom.isEmpty()) {
                    signes.putIfAbsent(serie.nom, new Signe(g, serie.nom, serie));
                }
            }
        }
        if (contenus.stream().anyMatch(Contenu::aUnFront)) {
            signes.put(FRONT, new Signe(g, FRONT, null));
        }
        if (contenus.stream().anyMatch(Contenu::aDesDefauts)) {
            signes.put(DEFAUT, new Signe(g, DEFAUT, null));
        }
        List<List<Signe>> lignes = new ArrayList<>();
        double x = largeur;
        for (Signe signe : signes.values()) {
            if (x + signe.largeur - ENTRE_NOMS > largeur) {
                lignes.add(new ArrayList<>());
                x = 0;
            }
            lignes.get(lignes.size() - 1).add(signe);
            x += signe.largeur;
        }
        return lignes;
    }

    private static void ligneDeLegende(Graphics2D g, List<Signe> signes, double y) {
        double total = signes.stream().mapToDouble(s -> s.largeur).sum() - ENTRE_NOMS;
        double x = (Style.LARGEUR - total) / 2;
        FontMetrics mesures = g.getFontMetrics(Style.LEGENDE);
        for (Signe signe : signes) {
            double cx = x + LARGEUR_SIGNE / 2.0 - 6;
            if (signe.serie == null) {
                g.setColor(signe.nom.equals(FRONT) ? Style.FRONT : Style.NOIR);
                g.setStroke(signe.nom.equals(FRONT) ? new BasicStroke(11) : Style.TRAIT);
                g.draw(signe.nom.equals(FRONT) ? new Line2D.Double(x, y, x + LARGEUR_SIGNE - 12, y)
                        : deplacee(FormeDePoint.ANNEAU, cx, y, 0.75));
            } else {
                g.setColor(signe.serie.couleur);
                if (signe.serie.reliee) {
                    g.setStroke(Style.TRAIT);
                    g.draw(new Line2D.Double(x, y, x + LARGEUR_SIGNE - 12, y));
                }
                g.fill(deplacee(signe.serie.forme.dessin, cx, y, 1));
            }
            g.setFont(Style.LEGENDE);
            g.setColor(Style.ENCRE);
            g.drawString(signe.nom, (float) (x + LARGEUR_SIGNE), (float) (y + mesures.getAscent() / 2.0 - 3));
            x += signe.largeur;
        }
    }

    private static Shape deplacee(Shape forme, double x, double y, double echelle) {
        AffineTransform t = AffineTransform.getTranslateInstance(x, y);
        t.scale(echelle, echelle);
        return t.createTransformedShape(forme);
    }
}
