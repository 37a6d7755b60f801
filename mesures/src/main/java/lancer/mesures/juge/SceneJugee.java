package lancer.mesures.juge;

import java.awt.image.Raster;
import java.io.IOException;
import lancer.Camera;
import lancer.Lancer;
import lancer.Scene;
import lancer.dessin.Dessin;
import lancer.mesures.ImageLineaire;

/** Une scène prête à être dessinée, par nous et par le juge. */
public final class SceneJugee {

    private static final double NIVEAUX_16 = 65535;

    /** Lancer pour la dessiner nous-mêmes, au seuil que le juge peut tenir. */
    public final Lancer lancer;

    /** 1, ou 3 si un Ks est coloré : l'éclat d'une lampe est pour POV-Ray d'une seule couleur. */
    final int dessins;

    /** Le nom de chacun. */
    private final String[] noms;
    private final PovRay povray;
    private final Camera camera;

    /**
     * @param nom celui des fichiers du juge
     * @param scene avec le seuil voulu ; si un Ks est coloré, il est mis à 0
     * @throws lancer.commande.Echec si le juge ne peut faire le même calcul
     */
    public SceneJugee(PovRay povray, String nom, Scene scene, int reflets, int largeur, int hauteur) throws IOException {
        this.povray = povray;
        noms = TraductionPov.estGrise(scene) ? new String[] {nom} : new String[] {nom + "-rouge", nom + "-verte", nom + "-bleue"};
        dessins = noms.length;
        if (dessins > 1) {
            // POV-Ray multiplie les plus grandes composantes des Ks, nous prenons la plus grande de leur produit
            scene.getModele().setSeuil(0);
        }
        lancer = Dessin.lancer(scene, largeur, hauteur, false);
        camera = lancer.getCamera();
        TraductionPov traduction = new TraductionPov(scene, reflets, camera);
        for (int c = 0; c < dessins; c++) {
            povray.ecrire(noms[c], traduction.texte(c));
        }
    }

    /**
     * L'image du juge, linéaire, de ses composantes justes.
     *
     * @param rouge ce que {@link #dessiner} en a rendu, avec ces options
     */
    public ImageLineaire image(Raster rouge, String... options) throws IOException {
        int largeur = camera.getLargeur();
        ImageLineaire image = new ImageLineaire(largeur, camera.getHauteur());
        Raster[] rasters = {rouge, rouge, rouge};
        for (int c = 1; c < dessins; c++) {
            rasters[c] = dessiner(c, options);
        }
        for (int k = 0; k < image.getComposantes().length; k++) {
            image.getComposantes()[k] = rasters[k % 3].getSample(k / 3 % largeur, k / 3 / largeur, k % 3) / NIVEAUX_16;
        }
        return image;
    }

    /**
     * Un dessin, un seul : celui dont le juge a su les couleurs rouges, si elles ne sont pas toutes justes à la fois.
     *
     * @param options de la commande {@code povray} ; aucune pour un rayon par pixel
     */
    public Raster dessiner(String... options) throws IOException {
        return dessiner(0, options);
    }

    private Raster dessiner(int c, String... options) throws IOException {
        return povray.dessiner(noms[c], camera.getLargeur(), camera.getHauteur(), options);
    }
}
