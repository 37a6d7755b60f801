package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.awt.Point;
import java.awt.event.InputEvent;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;

/** Le menu Affichage : la taille où l'image se dessine, la loupe. */
class FenetreAffichageTest extends EssaiFenetre {

    private void attendreTaille(String quoi, int largeur, int hauteur) throws Exception {
        attendre(quoi, () -> {
            ImageMemoire image = banc.etat().getImageEntiere();
            return image != null && image.largeur == largeur && image.hauteur == hauteur;
        });
    }

    @Test
    void remplirLaFenetreDessineALaPlusGrandeTailleDeMemesProportionsEtLaTailleDemandeeRevient() throws Exception {
        ouvrir();
        banc.frapperCtrl('r');
        retailler(500, 300);
        attendreTaille("aussi haute que la place", 400, 300);
        banc.attendreImage("dessinée, et non étirée", attendue(400, 300));
        retailler(200, 300);
        attendreTaille("aussi large que la place", 200, 150);
        retailler(480, 360);
        banc.frapperCtrl('r');
        attendreTaille("celle demandée", L, H);
        banc.attendreImage("au milieu", attendue(L, H));
    }

    @Test
    void laMoletteGrossitSansLisserNiRedessinerAutourDeLaSouris() throws Exception {
        ouvrir();
        ImageMemoire image = banc.imageAchevee();
        banc.attendreImage("à l'écran", image.codes);
        Point coin = Ecran.trouver(image.codes, L);
        attendre("la souris est là", () -> {
            banc.robot.mouseMove(coin.x + 51, coin.y + 60);
            banc.robot.mouseMove(coin.x + 50, coin.y + 60);
            return banc.pixel.getText().startsWith("pixel 50, 60 : ");
        });
        banc.robot.mouseWheel(-1);
        banc.robot.mouseWheel(-1);
        attendre("le grossissement se dit", () -> banc.resume().startsWith("320 × 240 pixels à la loupe × 4, "));
        attendre("le même pixel reste sous la souris", () -> banc.pixel.getText().startsWith("pixel 50, 60 : "));
        banc.robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.mouseMove(coin.x + 100, coin.y + 70);
        banc.robot.mouseMove(coin.x + 80, coin.y + 80);
        banc.robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        banc.robot.mouseMove(coin.x + 81, coin.y + 80);
        attendre("et suit la souris qui le tire", () -> banc.pixel.getText().startsWith("pixel 50, 60 : "));
        int[] grossie = new int[4 * 20 * 4 * 20];
        for (int k = 0; k < grossie.length; k++) {
            grossie[k] = image.codes[(60 + k / 80 / 4) * L + 50 + k % 80 / 4];
        }
        attendre("chaque pixel est un carré de quatre", () -> Ecran.trouver(grossie, 80) != null);
        for (int k = 0; k < 6; k++) {
            banc.robot.mouseWheel(-1);
        }
        attendre("seize au plus", () -> banc.resume().startsWith("320 × 240 pixels à la loupe × 16, "));
        for (int k = 0; k < 4; k++) {
            banc.robot.mouseWheel(1);
        }
        banc.attendreImage("et on en revient", image.codes);
        assertSame(image, banc.etat().getImageEntiere());
    }
}
