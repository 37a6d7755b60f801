package lancer.mesures.vitesse;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.IntStream;
import lancer.Scene;
import lancer.atelier.Scenes;
import lancer.mesures.Gabarit;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Intervalle;
import lancer.mesures.trace.Planche;
import lancer.mesures.trace.Style;
import lancer.mesures.trace.Vignettes;
import lancer.scene.FichierScene;

/** Où une image se trompe : l'écart de chaque pixel de la scène du cours à la vérité, en valeur absolue, amplifié. */
final class FigureDifferences {

    static final String PNG = "differences.png";

    /** Ce qui multiplie l'écart : un pas d'écran devient visible. */
    private static final int AMPLIFICATION = 16;

    private static final String SCENE = "scene1";

    private static final String[][] MONTREES = {{Catalogue.UN_RAYON, ""}, {Catalogue.PROFONDEUR, "p=0"}, {Catalogue.GRILLE, "2 × 2"},
        {Catalogue.COINS, Catalogue.COINS_DEFAUT}, {Catalogue.PARTAGE, "n=4 seuil=0.1"}};

    private final Taille taille;

    FigureDifferences(boolean rapide) {
        taille = rapide ? new Taille(100, 75) : new Taille(300, 225);
    }

    void ecrire(Path dossier) throws IOException {
        Scene scene = Scenes.lire(FichierScene.trouver("scenes/" + SCENE + ".ini"));
        Gabarit gabarit = new Gabarit(scene, taille.largeur, taille.hauteur, 1);
        ImageLineaire juste = gabarit.moyenne(taille.largeur, taille.hauteur);
        Vignettes vignettes = new Vignettes().image(image(juste), "la vérité", "128 rayons par pixel");
        for (String[] montree : MONTREES) {
            Methode methode = Catalogue.methode(Catalogue.METHODES, SCENE, montree[0] + "/" + montree[1]);
            ImageLineaire image = new ImageLineaire(taille.largeur, taille.hauteur);
            methode.new Dessin(scene, taille.largeur, taille.hauteur).faire(image, taille.fils);
            vignettes.image(image(ecart(image, juste)), methode.nom + " " + methode.parametres,
                    "erreur " + Style.nombre(Intervalle.deLaRacine(gabarit.carres(image)).valeur) + " pas");
        }
        new Planche("Scène du cours : ce qui manque à chaque image, amplifié " + AMPLIFICATION + " fois",
                taille.largeur + " × " + taille.hauteur + " : plus petite, l'image se trompe plus, car elle a plus de bords. make mesures")
                .vignettes(vignettes).ecrire(dossier.resolve(PNG));
    }

    private ImageLineaire ecart(ImageLineaire a, ImageLineaire b) {
        ImageLineaire ecart = new ImageLineaire(taille.largeur, taille.hauteur);
        Arrays.setAll(ecart.getComposantes(),
                c -> AMPLIFICATION * Math.abs(a.getComposantes()[c] - b.getComposantes()[c]));
        return ecart;
    }

    private BufferedImage image(ImageLineaire lineaire) {
        BufferedImage image = new BufferedImage(taille.largeur, taille.hauteur, BufferedImage.TYPE_INT_RGB);
        int[] codes = IntStream.range(0, taille.pixels()).map(k -> lineaire.getCouleur(k).getCode()).toArray();
        image.setRGB(0, 0, taille.largeur, taille.hauteur, codes, 0, taille.largeur);
        return image;
    }
}
