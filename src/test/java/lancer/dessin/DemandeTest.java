package lancer.dessin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import lancer.Constantes;
import lancer.Scene;
import lancer.commande.Echec;
import lancer.commande.Options;
import lancer.contrat.Compteurs;
import lancer.essai.Essai;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Une demande est une valeur : elle ne change pas, et deux demandes égales donnent la même image. */
class DemandeTest {

    private static final String SCENE = "scenes/scene1.ini";

    private final Lecture lecture = Lecture.lire(SCENE, part -> { });

    private Demande demande(String... options) {
        return new Demande(lecture, Options.lire(options));
    }

    @Test
    void deuxDemandesSontEgalesSiTousLeursTermesLeSont() {
        Demande demande = demande("--taille=40x30", "--reflets=2");
        assertEquals(demande, demande("--reflets", "2", "--taille", "40x30"));
        assertEquals(demande.hashCode(), demande("--reflets", "2", "--taille", "40x30").hashCode());
        Demande[] autres = {demande.avecTaille(30, 40), demande.avecVue("normales"),
            demande.avecReglages(demande.reglages.avecReflets(3)), demande.avecLecture(Lecture.lire(SCENE, part -> { }))};
        for (Demande autre : autres) {
            assertNotEquals(demande, autre);
        }
        assertEquals(demande, demande.avecTaille(30, 40).avecTaille(40, 30).avecVue("rayons").avecVue(null));
    }

    @Test
    void laCommandeRedemandeLaMemeChose() {
        String commande = demande("--taille=40x30", "--etape=ombres", "--simple").getCommande(" --image a.png");
        assertTrue(commande.endsWith(" --image a.png --taille 40x30 --etape ombres --simple " + SCENE), commande);
    }

    @Test
    void uneVarianteInconnueNePeutEtreDebranchee() {
        Echec e = assertThrows(Echec.class, () -> demande("--sans=Brume,Truc"));
        assertEquals("valeur impossible pour --sans : « Truc » ; attendu : une variante, par exemple Brume", e.getMessage());
    }

    @Test
    void deuxDessinsDUneDemandeOntLaMemeImageEtDAutresReglagesNeRepreparentPas() {
        Demande demande = demande("--taille=40x30");
        Dessin un = new Dessin(demande);
        Dessin deux = new Dessin(demande);
        un.lancer.TracerPixels(un.image, 5, 2);
        deux.lancer.TracerPixels(deux.image, 5, 1);
        assertNotSame(un.image, deux.image);
        assertEquals(java.nio.IntBuffer.wrap(un.image.codes), java.nio.IntBuffer.wrap(deux.image.codes));
        Dessin mat = un.avecReglages(demande.reglages.avecReflets(0));
        assertEquals(un.lancer.getScene().getObjets(), mat.lancer.getScene().getObjets());
        mat.lancer.TracerPixels(mat.image, mat.demande.reglages.getProfondeur(), 2);
        Compteurs comptes = mat.lancer.getAtelier().getCompteurs();
        assertEquals(0, comptes.reflechis);
        assertEquals(40 * 30, comptes.primaires);
    }

    /** Qui mesure un dessin préparé à la main mesure celui du programme. */
    @ParameterizedTest(name = "simple : {0}")
    @ValueSource(booleans = {false, true})
    void unDessinPrepareALaMainEstCeluiDeLaLigneDeCommande(boolean simple, @TempDir Path dossier) throws IOException {
        float[] programme = Essai.dessiner(dossier, Paths.get(SCENE), "--taille=64x48", simple ? "--simple" : "--fils=2");
        ImageMemoire image = new ImageMemoire(64, 48, true);
        Scene scene = new Scene(SCENE);
        Dessin.lancer(scene, 64, 48, simple).TracerPixels(image, Constantes.MAX_REFLETS, 2);
        for (int k = 0; k < programme.length; k++) {
            // un fichier PFM commence par la ligne du bas
            assertEquals(programme[(47 - k / 192) * 192 + k % 192], image.lineaire[k], "pixel " + k / 3);
        }
    }
}
