package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import lancer.Couleur;
import org.junit.jupiter.api.Test;

/** L'erreur d'une image, et sa ressemblance à celle qu'il faudrait. */
class ErreurTest {

    private static final int COTE = 24;

    private interface Teinte {
        Couleur en(int i, int j);
    }

    private static ImageLineaire image(Teinte teinte) {
        ImageLineaire image = new ImageLineaire(COTE, COTE);
        for (int j = 0; j < COTE; j++) {
            for (int i = 0; i < COTE; i++) {
                image.drawPixel(teinte.en(i, j), i, j);
            }
        }
        return image;
    }

    private static ImageLineaire auHasard(long graine) {
        Random hasard = new Random(graine);
        return image((i, j) -> new Couleur(hasard.nextDouble(), hasard.nextDouble(), hasard.nextDouble()));
    }

    @Test
    void entreUneImageEtElleMemeLErreurEstNulleEtLaRessemblanceVautUn() {
        Erreur erreur = Erreur.entre(auHasard(1), auHasard(1));
        assertEquals(0, erreur.rmse);
        assertEquals(0, erreur.max);
        assertEquals(0, erreur.pas);
        assertEquals(0, erreur.pixels);
        assertEquals(1, erreur.ssim, 1e-15);
    }

    @Test
    void lErreurDUneImageDecaleeToutEntiereEstLeDecalage() {
        Erreur erreur = Erreur.entre(image((i, j) -> new Couleur(0.5)), image((i, j) -> new Couleur(0.5 + 10 / 255.0)));
        assertEquals(10 / 255.0, erreur.rmse, 1e-15);
        assertEquals(10 / 255.0, erreur.max, 1e-15);
        assertEquals(10, erreur.pas);
        assertEquals(COTE * COTE, erreur.pixels);
    }

    @Test
    void lErreurDUnSeulPixelEstSonEcartDiviseParLaRacineDuNombreDeComposantes() {
        Erreur erreur = Erreur.entre(image((i, j) -> new Couleur(0, i == 3 && j == 7 ? 0.6 : 0, 0)), image((i, j) -> new Couleur()));
        assertEquals(0.6 / Math.sqrt(3 * COTE * COTE), erreur.rmse, 1e-15);
        assertEquals(0.6, erreur.max);
        assertEquals(153, erreur.pas);
        assertEquals(1, erreur.pixels);
    }

    @Test
    void deuxCouleursPlusClairesQueLEcranOntUneErreurEtSeRessemblentToutAFait() {
        Erreur erreur = Erreur.entre(image((i, j) -> new Couleur(1.5)), image((i, j) -> new Couleur(3)));
        assertEquals(1.5, erreur.rmse, 1e-15);
        assertEquals(0, erreur.pas);
        assertEquals(1, erreur.ssim, 1e-15);
    }

    /** (2ab + C1) / (a² + b² + C1). */
    @Test
    void laRessemblanceDeDeuxAplatsEstCelleDeLArticle() {
        double c1 = 0.01 * 0.01;
        Erreur erreur = Erreur.entre(image((i, j) -> new Couleur(0.2)), image((i, j) -> new Couleur(0.6)));
        assertEquals((2 * 0.2 * 0.6 + c1) / (0.2 * 0.2 + 0.6 * 0.6 + c1), erreur.ssim, 1e-12);
    }

    @Test
    void laRessemblanceDUnNegatifEstNegativeEtCelleDUneAutreImageProcheDeZero() {
        ImageLineaire image = auHasard(2);
        ImageLineaire negatif = image((i, j) -> new Couleur(1).sub(image.getCouleur(j * COTE + i)));
        assertTrue(Erreur.entre(image, negatif).ssim < -0.8, () -> "" + Erreur.entre(image, negatif).ssim);
        assertEquals(0, Erreur.entre(image, auHasard(3)).ssim, 0.1);
    }

    @Test
    void laRessemblanceEstLaMemeDansLesDeuxSens() {
        assertEquals(Erreur.entre(auHasard(4), auHasard(5)).ssim, Erreur.entre(auHasard(5), auHasard(4)).ssim);
    }

    @Test
    void deuxTaillesNeSeComparentPasEtSousOnzePixelsRienNeRessemble() {
        assertThrows(IllegalArgumentException.class, () -> Erreur.entre(auHasard(1), new ImageLineaire(COTE, COTE + 1)));
        assertThrows(IllegalArgumentException.class, () -> Erreur.entre(new ImageLineaire(10, 30), new ImageLineaire(10, 30)));
    }
}
