package lancer.mesures.vitesse;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import lancer.Scene;
import lancer.contrat.Compteurs;
import lancer.contrat.Pave;
import lancer.mesures.ImageLineaire;

/** Les vérifications des images que dessine un programme. */
final class Controle {

    /** Quantité de travail refaite par les boucles du cours, en nombre approché de sphères essayées. */
    private static final double BUDGET = 1e8;

    /** Coût fixe d'un rayon dans les boucles du cours, en sphères. */
    private static final int SOCLE = 20;

    private static final long GRAINE = 800600;

    private Controle() {
    }

    /**
     * Refait, par les boucles du cours, des pavés au hasard, toujours les mêmes, et les compare au bit près.
     *
     * @return le nombre de pixels refaits
     * @throws IllegalStateException si un pixel diffère
     */
    static int verifier(Methode.ScenePrete dessin, Scene scene, ImageLineaire image, Taille taille) {
        double cout = (double) dessin.lancer.getCompteurs().rayons() * (scene.getObjets().size() + SOCLE);
        int nombre = Pave.nombre(taille.largeur, taille.hauteur, Pave.COTE);
        int combien = Math.max(1, (int) (nombre * Math.min(1, BUDGET / cout)));
        List<Pave> choisis = new Random(GRAINE).ints(0, nombre).distinct().limit(combien)
                .mapToObj(k -> Pave.deRang(k, taille.largeur, taille.hauteur, Pave.COTE)).collect(Collectors.toList());
        ImageLineaire juste = new ImageLineaire(taille.largeur, taille.hauteur);
        Arrays.fill(juste.getComposantes(), Double.NaN);
        dessin.refaire(entier -> (pave, voulus, vue, toile)
                -> choisis.stream().anyMatch(p -> p.i0 == pave.i0 && p.j0 == pave.j0)
                ? entier.tracer(pave, voulus, vue, toile) : 0, juste, taille.fils);
        int refaits = 0;
        for (int k = 0; k < taille.pixels(); k++) {
            if (!Double.isNaN(juste.getComposantes()[3 * k])) {
                refaits++;
                if (!juste.getCouleur(k).equals(image.getCouleur(k))) {
                    throw new IllegalStateException("image fausse : le pixel (" + k % taille.largeur + ", " + k / taille.largeur
                            + ") est " + image.getCouleur(k) + " au lieu de " + juste.getCouleur(k));
                }
            }
        }
        return refaits;
    }

    /**
     * Compare l'image d'un programme qui calcule en {@code float}, et n'a donc pas les mêmes bits.
     *
     * @throws IllegalStateException si plus d'un pixel sur cent s'écarte de plus d'un niveau
     */
    static void comparer(Path ppm, Path png, Taille taille) throws IOException {
        byte[] octets = Files.readAllBytes(ppm);
        BufferedImage image = ImageIO.read(png.toFile());
        int entete = octets.length - 3 * taille.pixels();
        long faux = IntStream.range(0, taille.pixels()).filter(k -> IntStream.range(0, 3).anyMatch(c -> Math.abs((octets[entete + 3 * k + c]
                & 0xFF) - (image.getRGB(k % taille.largeur, k / taille.largeur) >> 16 - 8 * c & 0xFF)) > 1)).count();
        if (100 * faux > taille.pixels()) {
            throw new IllegalStateException("image fausse : " + ppm + ", " + faux + " pixels");
        }
    }

    /**
     * Refait l'image d'un programme, puis une partie par les boucles du cours.
     *
     * @return les compteurs, par noms de colonnes
     * @throws IllegalStateException si un pixel diffère
     */
    static Map<String, String> controler(Methode methode, Scene scene, Taille taille, Path png) throws IOException {
        ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
        boolean auto = methode.nom.equals(Catalogue.AUTO);
        Methode.ScenePrete dessin = auto ? null : methode.new ScenePrete(scene, taille.largeur, taille.hauteur);
        Compteurs comptes = auto ? MesureAuto.dessiner(scene, taille, 1, image).getLancer().getCompteurs()
                : dessin.faire(image, taille.fils);
        BufferedImage lue = ImageIO.read(png.toFile());
        for (int k = 0; k < taille.pixels(); k++) {
            if (lue.getRGB(k % taille.largeur, k / taille.largeur) != image.getCouleur(k).getCode()) {
                throw new IllegalStateException("image fausse : " + methode.cle() + ", pixel (" + k % taille.largeur + ", "
                        + k / taille.largeur + ")");
            }
        }
        return Releve.champs("primaires", comptes.primaires, "ombre", comptes.ombre, "reflechis", comptes.reflechis, "tests",
                comptes.testsSpheres, "noeuds", comptes.noeudsVisites, "raffines", comptes.pixelsRaffines, "pixels_verifies",
                auto ? taille.pixels() : verifier(dessin, scene, image, taille));
    }
}
