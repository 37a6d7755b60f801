package lancer.commande;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Collections;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.PixelFautif;
import lancer.contrat.Toile;
import lancer.essai.Essai;
import lancer.essai.Modification;
import lancer.essai.Plan;
import lancer.rapide.Preparation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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
        scene.getModele().setRecherche(new Preparation(scene, CAMERA));
        Toile toile = (couleur, i, j) -> assertTrue(i < 20, "un pixel faux est arrivé à l'image");
        return assertThrows(PixelFautif.class, () -> new Lancer(scene, CAMERA).TracerPixels(toile, 5, fils));
    }

    @Test
    void leMessageNommeLePixelLaSceneLaCauseLaLigneEtLaCommande(@TempDir Path dossier) throws IOException {
        Path scene = Files.copy(Paths.get("scenes/scene1.ini"), dossier.resolve("ma scène.ini"));
        try (Essai.Isole programme = Modification.de(dossier, "Lancer", "Rayon initial =",
                "if (xe > 20) { throw new IllegalStateException(\"pas encore écrit\"); } Rayon initial =")) {
            Essai essai = programme.executer("--taille=40x30", "--reflets=2", "--fils=1", "--image", dossier.resolve("i.png").toString(),
                    scene.toString());
            assertEquals(1, essai.code, essai.toString());
            Matcher pixel = Pattern.compile("lancer : pixel (\\d+), (\\d+) de .*ma scène.ini : java.lang.IllegalStateException: "
                    + "pas encore écrit \\(lancer.Lancer.getCouleurPixel, Lancer.java:\\d+\\) ; pour le revoir : .* --pixel (\\d+,\\d+) "
                    + "--taille 40x30 --reflets 2 '.*/ma scène.ini'").matcher(essai.erreur.trim());
            assertTrue(pixel.matches(), essai.erreur);
            assertTrue(Integer.parseInt(pixel.group(1)) >= 20, essai.erreur);
            assertEquals(pixel.group(1) + "," + pixel.group(2), pixel.group(3));
        }
    }

    @Test
    void uneReponseQuiNEstPasUnNombreNArriveJamaisALImage() {
        for (double faux : Arrays.asList(Double.NaN, Double.POSITIVE_INFINITY)) {
            PixelFautif faute = faute(new Vecteur(0, 0, faux), 2);
            assertTrue(faute.x >= 20, faute.getMessage());
        }
    }
}
