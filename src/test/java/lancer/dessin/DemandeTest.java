package lancer.dessin;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Scene;
import lancer.commande.Option;
import lancer.commande.Options;
import lancer.contrat.Toile;
import lancer.essai.Essai;
import lancer.image.ImageMemoire;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;
import lancer.systeme.Echec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Une demande est une valeur : elle ne change pas, et deux demandes égales donnent la même image. */
class DemandeTest {

    private static final String SCENE = "scenes/scene1.ini";

    private final SceneLue lue = LecteurScene.lire(SCENE, part -> { });

    private Demande demande(String... options) {
        return new Demande(lue, Options.lire(options));
    }

    @Test
    void deuxDemandesSontEgalesSiTousLeursTermesLeSont() {
        Demande demande = demande("--taille=40x30", "--reflets=2");
        assertEquals(demande, demande("--reflets", "2", "--taille", "40x30"));
        assertEquals(demande.hashCode(), demande("--reflets", "2", "--taille", "40x30").hashCode());
        Demande[] autres = {demande.avecTaille(30, 40), demande.avecVue("normales"),
            demande.avecReglages(demande.reglages.avec(Option.REFLETS, 3)), demande.avecLecture(LecteurScene.lire(SCENE, part -> { }))};
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
        Dessin un = Dessin.preparer(demande);
        Dessin deux = Dessin.preparer(demande.avecReglages(demande.reglages.avec(Option.FILS, 1)));
        un.tracer(un.image);
        deux.tracer(deux.image);
        assertNotSame(un.image, deux.image);
        assertArrayEquals(un.image.codes, deux.image.codes);
        int[] avecReflets = un.image.codes.clone();
        un.tracer(demande.reglages.avec(Option.REFLETS, 0), un.image);
        Dessin mat = Dessin.preparer(demande("--taille=40x30", "--reflets=0"));
        mat.tracer(mat.image);
        assertArrayEquals(mat.image.codes, un.image.codes);
        assertFalse(Arrays.equals(avecReflets, un.image.codes), "l'image a changé");
    }

    /** Un fichier ne montre rien avant d'être écrit : ses rayons sont ceux de l'image. */
    @Test
    void seuleUneToileQuiMontreUnBrouillonEnADessine() {
        for (boolean montre : new boolean[] {false, true}) {
            Demande demande = demande("--taille=40x30", "--fils=1");
            int[] pixels = new int[1];
            List<Integer> fini = new ArrayList<>();
            Dessin.preparer(demande).tracer(new Toile() {
                @Override
                public void drawPixel(Couleur coul, int xe, int ye) {
                    pixels[0]++;
                }

                @Override
                public boolean montreUnBrouillon() {
                    return montre;
                }

                @Override
                public void finirBrouillon() {
                    fini.add(pixels[0]);
                }
            });
            assertEquals(montre ? "[1200]" : "[]", fini.toString());
            assertEquals(montre ? 2400 : 1200, pixels[0]);
        }
    }

    @Test
    void leModeleEstFaitUneFoisParReglage() {
        Demande demande = demande("--reflets=2");
        assertSame(demande.getScene().getModele(), demande.avecTaille(30, 40).avecVue("normales").getScene().getModele());
    }

    /** Qui mesure un dessin préparé à la main mesure celui du programme. */
    @ParameterizedTest(name = "simple : {0}")
    @ValueSource(booleans = {false, true})
    void unDessinPrepareALaMainEstCeluiDeLaLigneDeCommande(boolean simple, @TempDir Path dossier) throws IOException {
        float[] programme = Essai.dessiner(dossier, Path.of(SCENE), "--taille=64x48", simple ? "--simple" : "--fils=2");
        ImageMemoire image = new ImageMemoire(64, 48, true);
        Scene scene = new Scene(SCENE);
        Dessin.lancer(scene, 64, 48, simple).TracerImage(image, Constantes.MAX_REFLETS, 2);
        for (int k = 0; k < programme.length; k++) {
            // un fichier PFM commence par la ligne du bas
            assertEquals(programme[(47 - k / 192) * 192 + k % 192], image.lineaire[k], "pixel " + k / 3);
        }
    }
}
