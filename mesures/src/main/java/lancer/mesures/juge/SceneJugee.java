package lancer.mesures.juge;

import java.awt.image.Raster;
import java.io.IOException;
import lancer.Camera;
import lancer.Lancer;
import lancer.Scene;
import lancer.dessin.Dessin;
import lancer.mesures.ImageLineaire;

/** Une scène que ce programme et POV-Ray dessinent. */
public final class SceneJugee {

    private static final double NIVEAUX_16 = 65535;

    /** Lancer qui la dessine par ce programme, au seuil que POV-Ray peut appliquer. */
    public final Lancer lancer;

    /** Nombre de dessins : 1, ou 3 si un Ks est coloré, car le reflet d'une lampe n'a qu'une composante pour POV-Ray. */
    final int dessins;

    /** Nom de chaque dessin. */
    private final String[] noms;
    private final PovRay povray;
    private final Camera camera;

    /**
     * @param nom celui des fichiers de POV-Ray
     * @param donnee son seuil est mis à 0 si un Ks est coloré
     * @throws lancer.systeme.Echec si POV-Ray ne peut faire le même calcul
     */
    public SceneJugee(PovRay povray, String nom, Scene donnee, int reflets, int largeur, int hauteur) throws IOException {
        this.povray = povray;
        noms = TraductionPov.estGrise(donnee) ? new String[] {nom} : new String[] {nom + "-rouge", nom + "-verte", nom + "-bleue"};
        dessins = noms.length;
        // POV-Ray multiplie les plus grandes composantes des Ks ; ce programme prend la plus grande du produit
        Scene scene = dessins > 1 ? donnee.avec(donnee.getModele().avecSeuil(0)) : donnee;
        lancer = Dessin.lancer(scene, largeur, hauteur, false);
        camera = lancer.getCamera();
        TraductionPov traduction = new TraductionPov(scene, reflets, camera);
        for (int c = 0; c < dessins; c++) {
            povray.ecrire(noms[c], traduction.texte(c));
        }
    }

    /** L'image linéaire de POV-Ray, faite des composantes justes de chaque dessin. */
    public ImageLineaire image() throws IOException {
        int largeur = camera.getLargeur();
        ImageLineaire image = new ImageLineaire(largeur, camera.getHauteur());
        Raster[] rasters = new Raster[3];
        for (int c = 0; c < 3; c++) {
            rasters[c] = c < dessins ? dessiner(c) : rasters[0];
        }
        for (int k = 0; k < image.getComposantes().length; k++) {
            image.getComposantes()[k] = rasters[k % 3].getSample(k / 3 % largeur, k / 3 / largeur, k % 3) / NIVEAUX_16;
        }
        return image;
    }

    /** Fait le premier dessin seulement. */
    public void dessiner() throws IOException {
        dessiner(0);
    }

    private Raster dessiner(int c) throws IOException {
        return povray.dessiner(noms[c], camera.getLargeur(), camera.getHauteur());
    }
}
