package lancer.mesures.juge;

import java.awt.image.Raster;
import java.io.IOException;
import java.util.Locale;
import lancer.Camera;
import lancer.Lancer;
import lancer.Scene;
import lancer.mesures.ImageLineaire;
import lancer.temoins.LancerSurveille;

/** Une scène prête à être dessinée, par nous et par le juge. */
public final class SceneJugee {

    private static final double NIVEAUX_16 = 65535;

    /** De quoi la dessiner nous-mêmes, au seuil que le juge peut tenir. */
    public final Lancer lancer;

    /** 1, ou 3 si un Ks est coloré : l'éclat d'une lampe est pour POV-Ray d'une seule couleur. */
    final int dessins;

    private final Peintre peintre;
    private final String nom;
    private final TraductionPov traduction;
    private final int largeur;
    private final int hauteur;
    private final String[] textes;

    /**
     * @param nom celui des fichiers du juge
     * @param scene avec le seuil voulu ; si un Ks est coloré, il est mis à 0
     * @param reflets nombre de réflexions permises
     * @throws Intraduisible si le juge ne peut faire le même calcul
     */
    public SceneJugee(Peintre peintre, String nom, Scene scene, int reflets, int largeur, int hauteur) throws Intraduisible {
        this.peintre = peintre;
        this.nom = nom;
        this.largeur = largeur;
        this.hauteur = hauteur;
        boolean grise = TraductionPov.estGrise(scene);
        if (!grise) {
            // POV-Ray multiplie les plus grandes composantes des Ks, nous prenons la plus grande de leur produit
            scene.setSeuil(0);
        }
        dessins = grise ? 1 : Composante.values().length;
        textes = new String[dessins];
        lancer = LancerSurveille.preparer(scene, largeur, hauteur, false);
        traduction = new TraductionPov(scene, reflets, Ecran.traverses(scene, new Camera(largeur, hauteur)));
    }

    /**
     * L'image du juge, linéaire, de ses composantes justes.
     *
     * @param rouge ce que {@link #dessiner} en a rendu, avec ces options
     */
    public ImageLineaire image(Raster rouge, String... options) throws IOException {
        ImageLineaire image = new ImageLineaire(largeur, hauteur);
        for (Composante c : Composante.values()) {
            Raster raster = c == Composante.ROUGE ? rouge : c.ordinal() < dessins ? dessiner(c, options) : null;
            for (int k = 0; raster != null && k < largeur * hauteur; k++) {
                for (int b = dessins == 1 ? 0 : c.ordinal(); b < (dessins == 1 ? 3 : c.ordinal() + 1); b++) {
                    image.getComposantes()[3 * k + b] = raster.getSample(k % largeur, k / largeur, b) / NIVEAUX_16;
                }
            }
        }
        return image;
    }

    /**
     * Un dessin, un seul : celui dont le juge a su les couleurs rouges, si elles ne sont pas toutes justes à la fois.
     *
     * @param options de la commande {@code povray} ; aucune pour un rayon par pixel
     */
    public Raster dessiner(String... options) throws IOException {
        return dessiner(Composante.ROUGE, options);
    }

    private Raster dessiner(Composante c, String... options) throws IOException {
        if (textes[c.ordinal()] == null) {
            textes[c.ordinal()] = traduction.texte(largeur, hauteur, c);
        }
        String suffixe = dessins == 1 ? "" : "-" + c.name().toLowerCase(Locale.ROOT);
        return peintre.dessiner(textes[c.ordinal()], nom + suffixe, largeur, hauteur, options);
    }
}
