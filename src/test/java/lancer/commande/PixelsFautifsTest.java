package lancer.commande;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.essai.Plan;
import lancer.rapide.Preparation;
import lancer.texte.Pile;
import org.junit.jupiter.api.Test;

/** Un dessin qui échoue nomme son pixel, sa cause et la commande qui le redessine. */
class PixelsFautifsTest {

    private static final Camera CAMERA = new Camera(40, 30);

    /** Un mur dont la normale échoue d'un seul côté. */
    private static final class Mur extends Plan {

        private final Vecteur normale;

        Mur(Vecteur normale) {
            super(new Point(0, 0, 8), new Vecteur(0, 0, -1));
            this.normale = normale;
            setKd(new Couleur(1));
        }

        @Override
        public Vecteur getNormale(Point contact) {
            if (contact.x < 0) {
                return super.getNormale(contact);
            }
            if (normale == null) {
                throw new IllegalStateException("pas encore écrit");
            }
            return normale;
        }
    }

    private static PixelFautif faute(Vecteur normale, int fils) {
        Scene scene = new Scene(Collections.singletonList(new Mur(normale)),
                Collections.singletonList(new Lampe(new Point(0, 0, -5), new Couleur(1))));
        scene.getModele().setRecherche(Preparation.pour(scene, CAMERA, part -> { }));
        Toile toile = (couleur, i, j) -> assertTrue(i < 20, "un pixel faux est arrivé à l'image");
        return assertThrows(PixelFautif.class, () -> new Lancer(scene, CAMERA).TracerPixels(toile, 5, fils));
    }

    @Test
    void leMessageNommeLePixelLaSceneLaCauseLaLigneEtLaCommande() {
        PixelFautif faute = faute(null, 1);
        assertTrue(faute.x >= 20, faute.getMessage());
        String message = Messages.duPixel(faute.x, faute.y, Pile.cause(faute, Pile.HORS_DE_JAVA), " --reflets 2", "ma scène.ini", 40, 30);
        String pixel = faute.x + "," + faute.y;
        assertTrue(message.startsWith("pixel " + pixel.replace(",", ", ") + " de ma scène.ini : "
                + "java.lang.IllegalStateException: pas encore écrit (lancer.commande.PixelsFautifsTest$Mur.getNormale, "
                + "PixelsFautifsTest.java:"), message);
        assertTrue(message.endsWith(" --pixel " + pixel + " --taille 40x30 --reflets 2 'ma scène.ini'"), message);
        assertEquals(1, message.split("\n").length);
    }

    @Test
    void uneReponseQuiNEstPasUnNombreNArriveJamaisALImage() {
        for (double faux : Arrays.asList(Double.NaN, Double.POSITIVE_INFINITY)) {
            PixelFautif faute = faute(new Vecteur(0, 0, faux), 2);
            assertTrue(faute.x >= 20, faute.getMessage());
        }
    }
}
