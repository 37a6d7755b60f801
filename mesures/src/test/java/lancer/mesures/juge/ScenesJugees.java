package lancer.mesures.juge;

import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.util.Arrays;
import java.util.List;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.mesures.ImageLineaire;

/** De petites scènes, et des images de 16 bits faites de nos couleurs. */
final class ScenesJugees {

    static final int LARGEUR = 40;
    static final int HAUTEUR = 30;
    static final int REFLETS = 3;

    private ScenesJugees() {
    }

    static Sphere boule(double x, double y, double z, double rayon, Couleur Kd, Couleur Ks) {
        Sphere sphere = new Sphere(new Point(x, y, z), rayon);
        sphere.setKd(Kd);
        sphere.setKs(Ks);
        sphere.setNs(50);
        return sphere;
    }

    static Scene scene(Objet3D... objets) {
        List<Lampe> lampes = Arrays.asList(new Lampe(new Point(-4, 6, -3), new Couleur(0.8, 0.8, 0.75)),
                new Lampe(new Point(5, 3, -2), new Couleur(0.25, 0.25, 0.5)));
        return new Scene(Arrays.asList(objets), lampes);
    }

    /** Deux boules qui se reflètent. */
    static Scene deuxBoules(Couleur Ks) {
        return scene(boule(-0.5, 0, 6, 0.8, new Couleur(0.75, 0.25, 0.125), Ks), boule(0.75, 0.25, 5, 0.5, new Couleur(0.5), Ks));
    }

    static Lancer lancer(Scene scene) {
        return new Lancer(scene, new Camera(LARGEUR, HAUTEUR));
    }

    static ImageLineaire couleurs(Scene scene) {
        return ImageLineaire.de(lancer(scene), REFLETS, 1);
    }

    /** Ces couleurs, limitées et arrondies comme dans un PNG de 16 bits. */
    static WritableRaster image(ImageLineaire couleurs) {
        WritableRaster image = Raster.createInterleavedRaster(DataBuffer.TYPE_USHORT, LARGEUR, HAUTEUR, 3, null);
        double[] composantes = couleurs.getComposantes();
        for (int k = 0; k < composantes.length; k++) {
            image.setSample(k / 3 % LARGEUR, k / 3 / LARGEUR, k % 3,
                    (int) Math.round(65535 * Math.max(0, Math.min(1, composantes[k]))));
        }
        return image;
    }
}
