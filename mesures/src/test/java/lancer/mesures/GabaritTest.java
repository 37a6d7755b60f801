package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Modele;
import lancer.dessin.Dessin;
import lancer.mesures.scenes.Scenes;
import lancer.scene.LecteurScene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** L'erreur d'une image, contre deux images au hasard. */
class GabaritTest {

    private static final int LARGEUR = 160;
    private static final int HAUTEUR = 120;

    /** Celle dont la vérité coûte plus : mille réflexions. */
    private static final int L = 56;
    private static final int H = 42;

    /** Points par côté d'un pixel, pour la grille qui tient lieu de vérité. */
    private static final int FIN = 16;
    private static final int REFLETS = 40;

    private static Scene scene(String nom) {
        return Scenes.lire(LecteurScene.trouver("scenes/" + nom + ".ini"));
    }

    private static ImageLineaire image(Scene scene, int largeur, int hauteur, int reflets) {
        return ImageLineaire.de(Dessin.lancer(scene, largeur, hauteur, false), reflets, 2);
    }

    private static double erreur(Gabarit gabarit, ImageLineaire image) {
        return Intervalle.deLaRacine(gabarit.carres(image)).valeur;
    }

    @Test
    void lesPixelsSemesDonnentLErreurDeTouteLImage() {
        Scene scene = scene("bowling");
        ImageLineaire image = image(scene, LARGEUR, HAUTEUR, 5);
        Gabarit seme = new Gabarit(scene, LARGEUR, HAUTEUR, 3, Gabarit.COTE, (i, j) -> true);
        assertEquals(54 * 40, seme.carres(image).length, "un par carré");
        assertEquals(1, erreur(seme, image) / erreur(new Gabarit(scene, LARGEUR, HAUTEUR, 1, Gabarit.COTE, (i, j) -> true), image), 0.15);
    }

    @Test
    void laVeriteNAPasDeLimiteDeReflexions() {
        Scene miroirs = scene("miroirs");
        Gabarit gabarit = new Gabarit(miroirs, L, H, 2, Gabarit.COTE, (i, j) -> true);
        double cinq = erreur(gabarit, image(miroirs, L, H, 5));
        double cent = erreur(gabarit, image(miroirs, L, H, 100));
        assertTrue(cent < 0.7 * cinq, cent + " contre " + cinq);
    }

    /** Une lampe forte sature l'écran : ce qui en dépasse n'est pas une erreur. */
    @ParameterizedTest(name = "{0}, lampes × {1}, {2} point(s) par côté")
    @CsvSource({"scene1, 1, 3", "scene1, 12, 1", "bowling, 12, 2"})
    void lErreurEstLEcartAUneGrilleFine(String nom, double eclat, int cote) {
        Scene lue = scene(nom);
        Scene scene = new Scene(lue.getObjets(), lue.getLampes().stream()
                .map(l -> new Lampe(l.getPosition(), l.getCouleur().mul(eclat))).collect(Collectors.toList()))
                .avec(new Modele().avecSeuil(0));
        ImageLineaire image = grille(scene, cote);
        double[] x = image.getComposantes();
        ImageLineaire fine = grille(scene, FIN);
        double[] juste = fine.getComposantes();
        double carre = IntStream.range(0, x.length).mapToDouble(c -> Math.pow(255 * (Math.min(1, x[c]) - Math.min(1, juste[c])), 2))
                .average().getAsDouble();
        Gabarit gabarit = new Gabarit(scene, L, H, 1, Gabarit.COTE, (i, j) -> true);
        assertEquals(1, erreur(gabarit, image) / Math.sqrt(carre), 0.03);
        assertEquals(0, Arrays.stream(gabarit.carres(fine)).average().getAsDouble() / carre, 0.02,
                "la grille fine n'a presque pas d'erreur");
    }

    /** La moyenne, dans chaque pixel, de {@code cote} fois {@code cote} points. */
    private static ImageLineaire grille(Scene scene, int cote) {
        Lancer lancer = new Lancer(scene, new Camera(L, H));
        ImageLineaire image = new ImageLineaire(L, H);
        for (int k = 0; k < L * H; k++) {
            Couleur somme = new Couleur();
            for (int q = 0; q < cote * cote; q++) {
                somme = somme.add(lancer.getCouleurPixel(k % L + (q % cote + 0.5) / cote, k / L + (q / cote + 0.5) / cote, REFLETS));
            }
            image.drawPixel(somme.div(cote * cote), k % L, k / L);
        }
        return image;
    }
}
