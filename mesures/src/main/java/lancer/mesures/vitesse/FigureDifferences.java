package lancer.mesures.vitesse;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Verite;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Vignettes;

/** Où une image se trompe : l'écart de chaque pixel à la vérité, en valeur absolue, amplifié. */
final class FigureDifferences {

    /** Ce qui multiplie l'écart : un pas d'écran devient visible. */
    static final int AMPLIFICATION = 16;

    /** Les réglages montrés, par leurs clés. */
    private static final List<String> MONTREES = Arrays.asList("echantillonnage/un rayon/", "echantillonnage/grille/3 × 3",
            "echantillonnage/coins/n=3 seuil=0.05", "echantillonnage/partage/n=8 seuil=0.06", "reflets/profondeur/p=5 seuil=1/1024");

    private final String scene;
    private final Releves releves;
    private final Path dossier;
    private final String note;

    /** @param dossier où {@link #noter} a écrit */
    FigureDifferences(String scene, Releves releves, Path dossier, String note) {
        this.scene = scene;
        this.releves = releves;
        this.dossier = dossier;
        this.note = note;
    }

    /** Garde l'écart de cette image, si elle est de celles que l'on montre. */
    static void noter(Path dossier, String scene, Methode methode, ImageLineaire image, ImageLineaire verite) throws IOException {
        int rang = MONTREES.indexOf(methode.cle());
        if (rang < 0) {
            return;
        }
        BufferedImage ecarts = new BufferedImage(image.getLargeur(), image.getHauteur(), BufferedImage.TYPE_INT_RGB);
        double[] a = image.getComposantes();
        double[] b = verite.getComposantes();
        for (int k = 0; k < image.getLargeur() * image.getHauteur(); k++) {
            int code = 0;
            for (int c = 3 * k; c < 3 * k + 3; c++) {
                code = code << 8 | (int) Math.round(255 * Math.min(1, AMPLIFICATION * Math.abs(a[c] - b[c])));
            }
            ecarts.setRGB(k % image.getLargeur(), k / image.getLargeur(), code);
        }
        Files.createDirectories(dossier);
        ImageIO.write(ecarts, "png", fichier(dossier, scene, rang).toFile());
    }

    /** Garde l'image juste. */
    static void noterLaVerite(Path dossier, String scene, ImageLineaire verite) throws IOException {
        BufferedImage image = new BufferedImage(verite.getLargeur(), verite.getHauteur(), BufferedImage.TYPE_INT_RGB);
        for (int k = 0; k < verite.getLargeur() * verite.getHauteur(); k++) {
            image.setRGB(k % verite.getLargeur(), k / verite.getLargeur(), verite.getCouleur(k).getCode());
        }
        Files.createDirectories(dossier);
        ImageIO.write(image, "png", fichierDeLaVerite(dossier, scene).toFile());
    }

    private static Path fichierDeLaVerite(Path dossier, String scene) {
        return dossier.resolve(scene + "-verite.png");
    }

    private static String nom(Releve r) {
        return r.famille.equals(Famille.REFLETS.nom()) ? Noms.valeur(r, "p") + " reflets au lieu de " + Verite.PROFONDEUR
                : Noms.methode(r);
    }

    private static Path fichier(Path dossier, String scene, int rang) {
        return dossier.resolve(scene + "-" + rang + ".png");
    }

    /** Vrai si toutes les images sont là : elles ne sont pas gardées avec les mesures. */
    boolean possible() {
        if (!Files.exists(fichierDeLaVerite(dossier, scene))) {
            return false;
        }
        for (int rang = 0; rang < MONTREES.size(); rang++) {
            if (!Files.exists(fichier(dossier, scene, rang))) {
                return false;
            }
        }
        return true;
    }

    Planche planche() throws IOException {
        Vignettes vignettes = new Vignettes(3);
        vignettes.image(ImageIO.read(fichierDeLaVerite(dossier, scene).toFile()), "la vérité", "la moyenne sur chaque pixel");
        for (int rang = 0; rang < MONTREES.size(); rang++) {
            String cle = scene + "/" + MONTREES.get(rang);
            Releve r = releves.get().stream().filter(a -> a.cle().equals(cle)).findFirst()
                    .orElseThrow(() -> new IllegalStateException("pas de mesure de " + cle));
            vignettes.image(ImageIO.read(fichier(dossier, scene, rang).toFile()), nom(r),
                    "erreur " + Style.arrondi(r.erreurEnPas()) + " pas, SSIM " + Style.decimales(r.nombre("ssim"), 4));
        }
        return new Planche(Noms.scene(scene) + " : ce qui manque à chaque image, amplifié " + AMPLIFICATION + " fois", note)
                .volet(vignettes, 1);
    }
}
