package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import lancer.Scene;
import lancer.image.Ecriture;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.mesures.ImageLineaire;
import lancer.mesures.scenes.Scenes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les vérifications d'une image dessinée. */
class ControleTest {

    private static final Taille TAILLE = new Taille(64, 48);

    @TempDir
    Path dossier;

    private Scene scene() throws IOException {
        return Scenes.lire(Scenes.fichier("foule-30", dossier));
    }

    private Methode methode(String cle) {
        return Catalogue.methode(Catalogue.METHODES, "miroirs", cle);
    }

    @Test
    void unBitDeTropRendLImageFausse() throws IOException {
        for (String cle : new String[] {"un rayon/", "coins par défaut/", "partage/n=4 seuil=0.2"}) {
            Methode.ScenePrete dessin = methode(cle).new ScenePrete(scene(), TAILLE.largeur, TAILLE.hauteur);
            ImageLineaire image = new ImageLineaire(TAILLE.largeur, TAILLE.hauteur);
            dessin.faire(image, 2);
            assertEquals(TAILLE.pixels(), Controle.verifier(dessin, scene(), image, TAILLE));
            image.getComposantes()[1000] = Math.nextUp(image.getComposantes()[1000]);
            IllegalStateException faute = assertThrows(IllegalStateException.class,
                    () -> Controle.verifier(dessin, scene(), image, TAILLE));
            assertTrue(faute.getMessage().startsWith("image fausse : le pixel (13, 5) est "), faute.getMessage());
        }
    }

    @Test
    void unPngDuProgrammeEstComparePixelParPixel() throws IOException {
        ImageMemoire image = new ImageMemoire(TAILLE.largeur, TAILLE.hauteur, false);
        Methode un = methode("un rayon/");
        un.new ScenePrete(scene(), TAILLE.largeur, TAILLE.hauteur).faire(image, 1);
        assertEquals(String.valueOf(TAILLE.pixels()), Controle.controler(un, scene(), TAILLE, ecrire(image)).get("primaires"));
        ImageMemoire noire = new ImageMemoire(TAILLE.largeur, TAILLE.hauteur, false);
        assertThrows(IllegalStateException.class, () -> Controle.controler(un, scene(), TAILLE, ecrire(noire)));
    }

    private Path ecrire(ImageMemoire image) {
        Path png = dossier.resolve("image.png");
        new Ecriture(png.toString()).ecrire(image, new FichierPng());
        return png;
    }
}
