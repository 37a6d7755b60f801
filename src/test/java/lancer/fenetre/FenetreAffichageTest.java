package lancer.fenetre;

import static lancer.fenetre.BancFenetre.attendre;
import static lancer.fenetre.BancFenetre.surFilEvenements;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;

/** Le menu Affichage : la taille où l'image se dessine, le plein écran, la loupe. */
class FenetreAffichageTest extends EssaiFenetre {

    private void attendreTaille(String quoi, int largeur, int hauteur) throws Exception {
        attendre(quoi, () -> {
            ImageMemoire image = banc.controleur.etat.getImageEntiere();
            return image != null && image.largeur == largeur && image.hauteur == hauteur;
        });
    }

    @Test
    void remplirLaFenetreDessineALaPlusGrandeTailleDeMemesProportionsEtLaTailleDemandeeRevient() throws Exception {
        ouvrir();
        banc.frapperCtrl('0');
        retailler(500, 300);
        attendreTaille("aussi haute que la place", 400, 300);
        banc.attendreImage("dessinée, et non étirée", attendue(400, 300));
        retailler(200, 300);
        attendreTaille("aussi large que la place", 200, 150);
        retailler(480, 360);
        banc.frapperCtrl('1');
        attendreTaille("celle demandée", L, H);
        banc.attendreImage("au milieu", attendue(L, H));
    }

    @Test
    void lePleinEcranNeGardeQueLImageEtLesMessages() throws Exception {
        int[] deuxReflets = attendue("--reflets=2");
        ouvrir();
        Dimension ecran = Toolkit.getDefaultToolkit().getScreenSize();
        Dimension avant = surFilEvenements(banc.cadre::getSize);
        banc.frapper(KeyEvent.VK_F11);
        attendre("l'image prend tout l'écran", () -> banc.panneau.getSize().equals(ecran));
        int largeur = (int) Math.round(ecran.height * (double) L / H);
        attendreTaille("à ses proportions", largeur, ecran.height);
        banc.attendreImage("dessinée, et non étirée", attendue(largeur, ecran.height));
        BufferedImage vue = banc.robot.createScreenCapture(new Rectangle(ecran));
        assertEquals(banc.panneau.getBackground().getRGB(), vue.getRGB(5, 5), "du gris autour");
        banc.frapper(KeyEvent.VK_SUBTRACT);
        attendre("les touches répondent", () -> banc.controleur.etat.getReglages().getReflets() == 2);
        banc.imageAchevee();
        banc.frapperCtrl('c');
        banc.attendreMessage("image copiée");
        ecrire(FAUTIVE);
        banc.attendreMessage(scene + ", ligne 3, [Sphere 1], rayon : ");
        attendre("rien ne se dessine plus", () -> !banc.controleur.etat.enCours);
        banc.frapper(KeyEvent.VK_ESCAPE);
        attendre("Échap en sort", () -> banc.cadre.getSize().equals(avant));
        // la faute en couvre le bas
        banc.attendreCodes("l'image revient à sa taille", deuxReflets);
    }

    @Test
    void enPleinEcranUneLigneDitLeDessinPuisSEfface() throws Exception {
        banc = new BancFenetre(lente().lent());
        attendre("le brouillon se voit", () -> banc.panneau.montree != null);
        banc.frapper(KeyEvent.VK_F11);
        attendre("elle dit le fichier et où il en est", () -> banc.panneau.ligne.matches("lancer — boule.ini — dessin \\d+ % — .*"));
        banc.main.lent = false;
        attendre("elle s'efface", () -> !banc.controleur.etat.enCours && banc.panneau.ligne.isEmpty());
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
        attendre("le grossissement se dit", () -> banc.resume.getText().startsWith("320 × 240 pixels à la loupe × 4, "));
        attendre("le même pixel reste sous la souris", () -> banc.pixel.getText().startsWith("pixel 50, 60 : "));
        int[] grossie = new int[4 * 20 * 4 * 20];
        for (int k = 0; k < grossie.length; k++) {
            grossie[k] = image.codes[(60 + k / 80 / 4) * L + 50 + k % 80 / 4];
        }
        attendre("chaque pixel est un carré de quatre", () -> Ecran.trouver(grossie, 80) != null);
        for (int k = 0; k < 6; k++) {
            banc.robot.mouseWheel(-1);
        }
        attendre("seize au plus", () -> banc.resume.getText().startsWith("320 × 240 pixels à la loupe × 16, "));
        for (int k = 0; k < 4; k++) {
            banc.robot.mouseWheel(1);
        }
        banc.attendreImage("et on en revient", image.codes);
        assertSame(image, banc.controleur.etat.getImageEntiere());
    }
}
