package lancer.mesures.juge;

import java.awt.image.Raster;
import java.io.IOException;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import lancer.Camera;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Scene;
import lancer.sortie.ImageMemoire;
import lancer.temoins.LancerSurveille;

/** Une scène, dessinée par nous et par le juge, et ce qui les sépare. */
final class Jugement {

    final int spheres;
    final double seuil;
    final int dessins;
    final Accord accord;

    /** De chaque cause, le nombre de pixels au-delà d'un pas de 16 bits qu'elle explique. */
    final Map<Cause, Integer> causes = new EnumMap<>(Cause.class);

    /** La plus grande distance à un rayon voisin qui a servi de preuve, en pixels. */
    final double voisin;

    /** La première preuve qui manque, {@code null} si tout est expliqué. */
    final String inexplique;

    /**
     * Dessine et compare.
     *
     * @param nom celui des fichiers du juge
     * @param scene avec le seuil voulu ; si un Ks est coloré, il est mis à 0
     * @param reflets nombre de réflexions permises
     * @throws Intraduisible si le juge ne peut faire le même calcul
     * @throws IOException si le juge n'a pas pu dessiner
     */
    Jugement(Peintre peintre, String nom, Scene scene, int reflets, int largeur, int hauteur) throws Intraduisible, IOException {
        boolean grise = TraductionPov.estGrise(scene);
        if (!grise) {
            // POV-Ray multiplie les plus grandes composantes des Ks, nous prenons la plus grande de leur produit
            scene.setSeuil(0);
        }
        Lancer lancer = LancerSurveille.preparer(scene, largeur, hauteur, false);
        Set<Objet3D> derriere = Ecran.traverses(scene, new Camera(largeur, hauteur));
        TraductionPov traduction = new TraductionPov(scene, reflets, derriere);
        ImageMemoire image = new ImageMemoire(largeur, hauteur, true);
        lancer.TracerPixels(image, reflets, Runtime.getRuntime().availableProcessors());
        Composante[] composantes = Composante.values();
        dessins = grise ? 1 : composantes.length;
        Raster[] juge = new Raster[dessins];
        for (int c = 0; c < dessins; c++) {
            String suffixe = grise ? "" : "-" + composantes[c].name().toLowerCase(Locale.ROOT);
            juge[c] = peintre.dessiner(traduction.texte(largeur, hauteur, composantes[c]), nom + suffixe, largeur, hauteur);
        }
        spheres = scene.getObjets().size();
        seuil = scene.getSeuil();
        accord = new Accord(largeur, hauteur, image.getLineaire(), juge);
        double plusLoin = 0;
        String faute = null;
        for (int k : accord.auDela16) {
            Explication explication = new Explication(lancer, reflets, accord, k);
            causes.merge(explication.cause, 1, Integer::sum);
            plusLoin = Math.max(plusLoin, explication.distance);
            if (explication.cause == Cause.INEXPLIQUE && faute == null) {
                faute = decrire(k, largeur);
            }
        }
        voisin = plusLoin;
        inexplique = faute;
    }

    private String decrire(int k, int largeur) {
        StringBuilder nous = new StringBuilder();
        StringBuilder lui = new StringBuilder();
        for (Composante c : Composante.values()) {
            nous.append(String.format(Locale.ROOT, " %.5f", accord.nous(k, c)));
            lui.append(String.format(Locale.ROOT, " %.5f", accord.juge(k, c)));
        }
        return "pixel (" + k % largeur + ", " + k / largeur + ") : lancer" + nous + ", le juge" + lui;
    }

    int nombre(Cause cause) {
        return causes.getOrDefault(cause, 0);
    }
}
