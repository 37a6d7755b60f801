package lancer.antialias;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.DoubleFunction;
import lancer.Camera;
import lancer.Scene;
import lancer.blinn.Blinn;
import lancer.brume.Brume;
import lancer.essai.Essai;
import lancer.essai.EssaiPixel;
import lancer.essai.EssaiVariante;
import lancer.inspection.EssaiSegments;
import lancer.inspection.Inspection;
import lancer.inspection.Recit;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** La variante par la ligne de commande, seule ou avec les deux autres. */
class AntialiasTest extends EssaiVariante {

    private static final List<Path> SEULE = List.of(Essai.origine(Antialias.class));

    @Tag("reference")
    @ParameterizedTest
    @CsvSource({"p1-quatre.ini, p1-quatre.antialias-3.pfm, 3", "p4-foule.ini, p4-foule.antialias-4.pfm, 4"})
    void lesImagesDeReferenceSontRetrouvees(String ini, String pfm, int n) throws IOException {
        Path scene = scene(ini(ini), "[Antialias]", "n=" + n, "seuil=0");
        Essai.dessinerAvec(SEULE, dossier, scene, "--taille", "120x90", "--seuil", "0");
        Essai.verifierReference(pfm, dossier);
    }

    @Tag("reference")
    @Test
    void lesTroisVariantesSeCombinent() throws IOException {
        Path scene = scene(ini("p2-sol.ini"), "[Antialias]", "n=2", "seuil=0", "[Blinn]", "facteur=1", "[Brume]", "couleur=0.8 0.8 0.8",
                "debut=3", "fin=40");
        List<Path> toutes = new ArrayList<>(List.of(Essai.origine(Antialias.class), Essai.origine(Brume.class),
                Essai.origine(Blinn.class)));
        for (int ordre = 0; ordre < 2; ordre++) {
            Essai.dessinerAvec(toutes, dossier, scene, "--taille", "120x90", "--seuil", "0");
            Essai.verifierReference("p2-sol.tout.pfm", dossier);
            Collections.reverse(toutes);
        }
    }

    @ParameterizedTest
    @CsvSource({"p4-foule, coins, 3, 0.05", "p4-foule, coins, 4, 0", "p4-foule, coins, 1, 0.05", "p4-foule, coins, 2, 0.05",
        "p1-quatre, partage, 8, 0.1", "p4-foule, partage, 3, 0.02", "p1-quatre, partage, 3, 0", "p4-foule, partage, 1, 0.1"})
    void unPixelDemandeSeulEstCeluiDeLImage(String nom, String methode, int n, double seuil) throws IOException {
        Path scene = scene(ini(nom + ".ini"), "[Antialias]", "n=" + n, "methode=" + methode, "seuil=" + seuil);
        EssaiPixel.verifier(SEULE, dossier, scene, 40, 36);
    }

    /** Aucune équation n'est ici celle des variantes : tout est refait à part. */
    @ParameterizedTest
    @CsvSource({"n=3|seuil=0, 2, 0.05, 5", "n=4|seuil=0.05, 0.5, 0.2, 1", "n=1, 1, 0, 3",
        "n=4|methode=partage|seuil=0.06, 1, 0.05, 2", "n=8|methode=partage, 1, 0.3, 2"})
    void chaqueTermeDesTroisVariantesEstCeluiDesEquationsEtChaqueSommeSeFerme(String echantillons, double facteur, double densite,
            int reflets) throws IOException {
        List<String> lignes = new ArrayList<>(List.of(ini("p2-sol.ini"), "[Antialias]"));
        lignes.addAll(List.of(echantillons.split("[|]")));
        lignes.addAll(List.of("[Blinn]", "facteur=" + facteur, "[Brume]", "couleur=0.8 0.7 0.6", "debut=1.5", "densite=" + densite));
        Path scene = scene(lignes.toArray(new String[0]));
        SceneLue lue = LecteurScene.lire(scene.toString(), part -> { });
        Scene lues = new Scene(lue.objets, lue.lampes).avec(lue.getModele());
        EssaiSegments essai = new EssaiSegments(lues, reflets, d -> 1 - Math.exp(-densite * Math.max(0, d - 1.5)),
                new double[] {0.8, 0.7, 0.6}, facteur);
        int pesees = 0;
        for (int k = 0; k < 60; k++) {
            Inspection pixel = new Inspection(lues, lue::getOrigine, new Camera(40, 30), reflets, 7 * k % 40, k % 30);
            pixel.faire(() -> false);
            String dit = String.join("\n", essai.verifier(pixel));
            pesees += dit.contains("\nleur moyenne = ") ? 1 : 0;
        }
        assertTrue(essai.eclairees > 20 && essai.contacts > 30, essai.eclairees + " lampes, " + essai.contacts + " contacts");
        assertTrue(echantillons.contains("partage") ? pesees > 20 : pesees == 0, pesees + " pixels pesés");
    }

    /** Le texte entier, à quatre décimales : les échantillons, la brume, la bissectrice. */
    @ParameterizedTest
    @ValueSource(strings = {"coins", "partage"})
    void lImageEtLesComptesNeDependentPasDuNombreDeFils(String methode) throws IOException {
        String scene = scene(ini("p1-quatre.ini"), "[Antialias]", "methode=" + methode).toString();
        Set<String> obtenus = new HashSet<>();
        for (String fils : List.of("1", "2", "3", "7", "64")) {
            Essai essai = Essai.executer("--lineaire", dossier.resolve("image.pfm").toString(), "--taille", "120x90", "--statistiques",
                    "--fils", fils, scene);
            assertEquals("", essai.erreur);
            obtenus.add(Arrays.hashCode(Files.readAllBytes(dossier.resolve("image.pfm")))
                    + essai.sortie.substring(0, essai.sortie.indexOf("lecture.ms")));
        }
        assertEquals(1, obtenus.size(), obtenus.toString());
    }

    @Test
    void leTexteEstCeluiQueLOnARelu() throws IOException {
        SceneLue lue = LecteurScene.lire(scene(ini("recit.ini"), "[Antialias]", "n=2", "[Blinn]", "[Brume]").toString(), part -> { });
        Inspection pixel = new Inspection(new Scene(lue.objets, lue.lampes).avec(lue.getModele()), lue::getOrigine, new Camera(80, 60), 1,
                40, 24);
        pixel.faire(() -> false);
        DoubleFunction<String> court = x -> String.format(Locale.ROOT, "%.4f", x);
        assertEquals(ini("recit-variantes.txt").trim(), String.join("\n", new Recit(pixel, court, court).raconter().lignes()));
    }

    @Test
    void lesStatistiquesDisentCeQuiAEteRaffine() throws IOException {
        Path scene = scene(ini("p1-quatre.ini"), "[Antialias]", "n=5");
        Essai quatre = Essai.executerAvec(SEULE, "--lineaire", dossier.resolve("image.pfm").toString(), "--taille", "40x30",
                "--statistiques", scene.toString());
        long raffines = quatre.statistique("pixels.raffines");
        assertTrue(raffines > 50 && raffines < 600, () -> raffines + " pixels raffinés");
        assertEquals(4 * 40 * 30 + 21 * raffines, quatre.statistique("rayons.primaires"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "n=0          | n | hors limites : « 0 » ; attendu : un nombre de 1 à 64",
        "n=65         | n | hors limites : « 65 » ; attendu : un nombre de 1 à 64",
        "n=2.5        | n | n'est pas un nombre entier : « 2.5 » ; attendu : un entier de 1 à 64",
        "n=trois      | n | n'est pas un nombre : « trois » ; attendu : un nombre de 1 à 64",
        "seuil=-0.1   | seuil | hors limites : « -0.1 » ; attendu : un nombre d'au moins 0",
        "seuil=0.1 0.1| seuil | 2 nombres au lieu de 1 : « 0.1 0.1 » ; attendu : un nombre d'au moins 0",
        "methode=Halton | methode | méthode inconnue : « Halton » ; attendu : coins ou partage",
        "methode=       | methode | méthode inconnue : «  » ; attendu : coins ou partage",
        "rayons=9     | rayons | clé inconnue ; attendu : n, seuil, methode"})
    void uneValeurImpossibleEstRefuseeEnUneLigne(String ligne, String cle, String faute) throws IOException {
        verifierRefus("ligne 2, [Antialias], " + cle + " : " + faute, "[Antialias]", ligne);
    }

    @Test
    void ceQuiSeRegleALaSourisEstAccepteParLaSection() {
        verifierParametres(new Antialias(), "n", "seuil", "methode");
    }
}
