package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringReader;
import java.nio.file.Path;
import lancer.Scene;
import lancer.image.Ecriture;
import lancer.image.FichierPng;
import lancer.image.ImageMemoire;
import lancer.mesures.ImageLineaire;
import lancer.mesures.scenes.Scenes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Ce que fait la machine virtuelle d'une méthode, sans elle. */
class OuvrierTest {

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
    void ilDessineAutantDeFoisQuOnLeDemandePuisRendSesComptes() throws IOException {
        ByteArrayOutputStream sortie = new ByteArrayOutputStream();
        Ouvrier.dessiner(methode("coins/n=3 seuil=0.05"), scene(), TAILLE,
                new BufferedReader(new StringReader("1\n3\n2\nfinir\n5\n")), new PrintStream(sortie));
        String[] lignes = sortie.toString("UTF-8").split("\n");
        assertEquals(4, lignes.length);
        assertTrue(Double.parseDouble(lignes[1].split(" ")[0]) > 0);
        Methode.ScenePrete dessin = methode("coins/n=3 seuil=0.05").new ScenePrete(scene(), TAILLE.largeur, TAILLE.hauteur);
        dessin.faire(new ImageLineaire(TAILLE.largeur, TAILLE.hauteur), 1);
        assertEquals(dessin.lancer.getCompteurs().primaires, Long.parseLong(lignes[3].split(" ")[0]));
        assertEquals(TAILLE.pixels(), Integer.parseInt(lignes[3].split(" ")[6]), "tous vérifiés");
    }

    @Test
    void unBitDeTropRendLImageFausse() throws IOException {
        for (String cle : new String[] {"un rayon/", "coins/n=3 seuil=0.05",
            "partage, tous les reflets/n=4 seuil=0.1 jusqu'à 1/128"}) {
            Methode.ScenePrete dessin = methode(cle).new ScenePrete(scene(), TAILLE.largeur, TAILLE.hauteur);
            ImageLineaire image = new ImageLineaire(TAILLE.largeur, TAILLE.hauteur);
            dessin.faire(image, 2);
            assertEquals(TAILLE.pixels(), Ouvrier.verifier(dessin, scene(), image, TAILLE));
            image.getComposantes()[1000] = Math.nextUp(image.getComposantes()[1000]);
            IllegalStateException faute = assertThrows(IllegalStateException.class,
                    () -> Ouvrier.verifier(dessin, scene(), image, TAILLE));
            assertTrue(faute.getMessage().startsWith("image fausse : le pixel (13, 5) est "), faute.getMessage());
        }
    }

    @Test
    void unPngDuProgrammeEstComparePixelParPixel() throws IOException {
        ImageMemoire image = new ImageMemoire(TAILLE.largeur, TAILLE.hauteur, false);
        Methode un = methode("un rayon/");
        un.new ScenePrete(scene(), TAILLE.largeur, TAILLE.hauteur).faire(image, 1);
        assertEquals(String.valueOf(TAILLE.pixels()), Ouvrier.controler(un, scene(), TAILLE, ecrire(image)).get("primaires"));
        ImageMemoire noire = new ImageMemoire(TAILLE.largeur, TAILLE.hauteur, false);
        assertThrows(IllegalStateException.class, () -> Ouvrier.controler(un, scene(), TAILLE, ecrire(noire)));
    }

    private Path ecrire(ImageMemoire image) {
        Path png = dossier.resolve("image.png");
        new Ecriture(png.toString()).ecrire(image, new FichierPng());
        return png;
    }
}
