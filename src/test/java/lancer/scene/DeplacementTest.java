package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Changer une valeur, c'est lire de nouveau la section du fichier : rien d'autre ne s'y perd. */
class DeplacementTest {

    private static final String SCENE = "; des boules\n[SPHERE  \t a]\nCentre=0 0.2 6\nrayon=1\nKD=0.9 0.15 0.1\n"
            + "; un commentaire\nKr=0.3 0.3 0.3\nns=40\n\n[Lampe]\nposition=-4 6 -3\ncouleur=0.9 0.9 0.85\n"
            + "[Sphere é]\ncentre=1 1 7\nrayon=.5\n";

    @TempDir
    Path dossier;

    private SceneLue lire(String texte) throws IOException {
        Path fichier = Files.createTempFile(dossier, "s", ".ini");
        Files.write(fichier, texte.getBytes(StandardCharsets.UTF_8));
        return LecteurScene.lire(fichier.toString(), part -> { });
    }

    @Test
    void uneBouleDeplaceeGardeToutesLesClesDeSaSection() throws IOException {
        SceneLue lue = lire(SCENE);
        SceneLue changee = Deplacement.avec(lue, 0, "centre", "1 2 6.5");
        Sphere boule = (Sphere) changee.objets.get(0);
        assertEquals(new Point(1, 2, 6.5), boule.getCentre());
        assertEquals(1, boule.getRayon());
        assertEquals(new Couleur(0.9, 0.15, 0.1), boule.getKd());
        assertEquals(new Couleur(0.3), boule.getKs());
        assertEquals(40, boule.getNs());
        assertEquals(new Point(0, 0.2, 6), ((Sphere) lue.objets.get(0)).getCentre(), "la scène d'avant n'a pas changé");
        assertSame(lue.objets.get(1), changee.objets.get(1));
        assertEquals("[SPHERE a] ligne 2", changee.origines.de(boule));
        assertEquals(0, changee.origines.getRang(boule));
    }

    @Test
    void lesChosesSontDansLOrdreDuFichierEtUneSectionSansNomSeDitParSaLigne() throws IOException {
        Origines origines = lire(SCENE).origines;
        assertEquals(3, origines.getNombre());
        assertEquals("[SPHERE a]", origines.getNom(0));
        assertEquals("[Lampe] ligne 10", origines.getNom(1));
        assertEquals("[Sphere é]", origines.getNom(2));
        assertEquals("0 0.2 6", Deplacement.section(origines, 0).valeur("centre"));
        assertEquals(new Point(-4, 6, -3), Deplacement.place(Deplacement.section(origines, 1)));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "0|rayon|-1|[SPHERE a], rayon : hors limites : « -1 » ; attendu : un nombre de 1e-100 à 1e100",
        "0|rayon|0,5|[SPHERE a], rayon : une virgule dans un nombre : « 0,5 » ; attendu : un nombre de 1e-100 à 1e100, "
            + "avec un point décimal",
        "0|rayon|1e999|[SPHERE a], rayon : nombre trop grand : « 1e999 » ; attendu : un nombre de 1e-100 à 1e100",
        "0|centre|1 2|[SPHERE a], Centre : 2 nombres au lieu de 3 : « 1 2 » ; attendu : 3 nombres séparés par des blancs, "
            + "chacun de -1e100 à 1e100",
        "0|Kd|2 0 0|[SPHERE a], KD : hors limites : « 2 » ; attendu : 3 nombres séparés par des blancs, chacun de 0 à 1",
        "1|couleur|''|[Lampe], couleur : valeur absente ; attendu : 3 nombres séparés par des blancs, chacun de 0 à 1000000",
        "1|rayon|1|[Lampe], rayon : clé inconnue ; attendu : position, couleur"})
    void uneValeurQuUneSceneRefuseraitEstRefuseeParLaMemePhrase(int rang, String cle, String valeur, String phrase) throws IOException {
        SceneLue lue = lire(SCENE);
        SceneFautive refus = assertThrows(SceneFautive.class, () -> Deplacement.avec(lue, rang, cle, valeur));
        assertEquals("valeur refusée, " + phrase, refus.getMessage());
    }

    private static int[] dessiner(SceneLue lue) {
        ImageMemoire image = new ImageMemoire(40, 30, false);
        new Lancer(new Scene(lue.objets, lue.lampes), new Camera(40, 30)).TracerPixels(image, 5, 1);
        return image.codes;
    }

    @Test
    void lesSectionsChangeesMisesALaPlaceDesAutresDonnentLaMemeScene() throws IOException {
        SceneLue lue = lire(SCENE);
        SceneLue ailleurs = Deplacement.avec(lue, 1, "position", "3 3 0");
        SceneLue changee = Deplacement.avec(Deplacement.avec(ailleurs, 0, "centre", "0.25 0.2 6"), 0, "Kd", "0.1 0.2 1");
        changee = Deplacement.avec(changee, 2, "Ks", "0.1 0 0");
        String sections = Deplacement.getChanges(changee, lue);
        assertEquals("[SPHERE a]\nCentre=0.25 0.2 6\nrayon=1\nKD=0.1 0.2 1\nKr=0.3 0.3 0.3\nns=40\n\n[Lampe]\nposition=3 3 0\n"
                + "couleur=0.9 0.9 0.85\n\n[Sphere é]\ncentre=1 1 7\nrayon=.5\nKs=0.1 0 0\n\n", sections);
        assertArrayEquals(dessiner(changee), dessiner(lire(sections)));
        assertEquals("", Deplacement.getChanges(Deplacement.avec(ailleurs, 1, "position", "-4 6 -3"), lue),
                "une valeur remise n'est plus un changement");
        assertNotSame(lue.lampes.get(0), changee.lampes.get(0));
    }

    @ParameterizedTest
    @CsvSource({"0.123456789, 40, 0.123", "-0.0001, 1, 0", "1234.56, 0.01, 1230", "1e-7, 1e9, 1e-7"})
    void unePlaceSEcritAuDixiemeDePixel(double x, double pixels, String ecrit) {
        assertEquals(ecrit + " 0 0", Deplacement.ecrire(new Point(x, 0, 0), pixels));
    }

    @Test
    void uneLampeChangeeEstLueCommeUneAutre() throws IOException {
        Lampe lampe = Deplacement.avec(lire(SCENE), 1, "couleur", "0 0 1e6").lampes.get(0);
        assertEquals(new Couleur(0, 0, 1e6), lampe.getCouleur());
        assertEquals(new Point(-4, 6, -3), lampe.getPosition());
    }
}
