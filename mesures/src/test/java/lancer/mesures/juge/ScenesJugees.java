package lancer.mesures.juge;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.mesures.ImageLineaire;

/** De petites scènes, des images de 16 bits faites de nos couleurs, et une fausse commande povray qui les rend. */
final class ScenesJugees {

    static final int LARGEUR = 40;
    static final int HAUTEUR = 30;
    static final int REFLETS = 3;

    private ScenesJugees() {
    }

    /** Une commande qui note dans « demandes » ce qu'on lui demande, et rend « image.png » après les échecs que dit « echecs ». */
    static String commande(Path dossier) throws IOException {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")));
        Path commande = dossier.resolve("povray");
        Files.write(commande, List.of("#!/bin/sh", "d='" + dossier + "'",
                "[ \"$1\" = --version ] && { echo 'POV-Ray 3.9.1.unofficial'; exit; }",
                "echo \"$@\" >> \"$d/demandes\"",
                "[ $(wc -l < \"$d/demandes\") -gt $(cat \"$d/echecs\") ] || { echo; echo 'Fatal error: en retard'; exit 3; }",
                "cp \"$d/image.png\" \"${2#+O}\""),
                StandardCharsets.UTF_8);
        assertTrue(commande.toFile().setExecutable(true));
        return commande.toString();
    }

    /** Ce que rendra {@link #commande}. */
    static void preparer(Path dossier, int echecs, WritableRaster image) throws IOException {
        Files.write(dossier.resolve("echecs"), String.valueOf(echecs).getBytes(StandardCharsets.US_ASCII));
        int type = image.getDataBuffer().getDataType();
        ComponentColorModel couleurs = new ComponentColorModel(ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false, 1, type);
        ImageIO.write(new BufferedImage(couleurs, image, false, null), "png", dossier.resolve("image.png").toFile());
    }

    static Sphere boule(double x, double y, double z, double rayon, Couleur Kd, Couleur Ks) {
        Sphere sphere = new Sphere(new Point(x, y, z), rayon);
        sphere.setKd(Kd);
        sphere.setKs(Ks);
        sphere.setNs(50);
        return sphere;
    }

    static Scene scene(Objet3D... objets) {
        List<Lampe> lampes = List.of(new Lampe(new Point(-4, 6, -3), new Couleur(0.8, 0.8, 0.75)),
                new Lampe(new Point(5, 3, -2), new Couleur(0.25, 0.25, 0.5)));
        return new Scene(List.of(objets), lampes);
    }

    /** Deux boules qui se reflètent. */
    static Scene deuxBoules(Couleur Ks) {
        return scene(boule(-0.5, 0, 6, 0.8, new Couleur(0.75, 0.25, 0.125), Ks), boule(0.75, 0.25, 5, 0.5, new Couleur(0.5), Ks));
    }

    /** Ce que nous en dessinons, limité et arrondi comme dans un PNG de 16 bits. */
    static WritableRaster image(Scene scene) {
        WritableRaster image = Raster.createInterleavedRaster(DataBuffer.TYPE_USHORT, LARGEUR, HAUTEUR, 3, null);
        double[] composantes = ImageLineaire.de(new Lancer(scene, new Camera(LARGEUR, HAUTEUR)), REFLETS, 1).getComposantes();
        for (int k = 0; k < composantes.length; k++) {
            image.setSample(k / 3 % LARGEUR, k / 3 / LARGEUR, k % 3,
                    (int) Math.round(65535 * Math.max(0, Math.min(1, composantes[k]))));
        }
        return image;
    }
}
