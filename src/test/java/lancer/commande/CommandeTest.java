package lancer.commande;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import javax.imageio.ImageIO;
import lancer.essai.Essai;
import lancer.essai.EssaiCommande;
import lancer.essai.Ressources;
import org.junit.jupiter.api.Test;

/** Le programme sans fenêtre : de la ligne de commande à l'image, au statut et à la ligne d'erreur. */
class CommandeTest extends EssaiCommande {

    @Test
    void lAideEtLaVersionSontSurLaSortieStandard() {
        for (String demande : new String[] {"--aide", "--help", "-h"}) {
            Essai e = Essai.executer(demande);
            assertEquals(0, e.code);
            assertEquals("", e.erreur);
            assertTrue(e.sortie.contains("--image"), e.sortie);
        }
        Essai version = Essai.executer("--version");
        assertEquals(0, version.code);
        assertTrue(version.sortie.startsWith("lancer "), version.toString());
    }

    @Test
    void uneOptionFausseDonneUneLigneEtLeStatut2() {
        verifierRefus(2, "option inconnue : « --bidule » ; attendu : une de celles que montre --aide", Essai.executer("--bidule"));
        verifierRefus(2, "aucune scène à dessiner ; attendu : un fichier, par exemple scenes/scene1.ini",
                Essai.executer("--image", png.toString()));
        verifierFichiers();
    }

    @Test
    void uneSceneAbsenteOuUnDossierEstRefuse() {
        Path absente = dossier.resolve("absente.ini");
        verifierRefus(2, absente + " : fichier introuvable ; attendu : un fichier de scène",
                Essai.executer("--image", png.toString(), absente.toString()));
        verifierRefus(2, dossier + " : c'est un dossier ; attendu : un fichier de scène",
                Essai.executer("--image", png.toString(), dossier.toString()));
        Essai relative = Essai.executer("--image", png.toString(), "nulle-part/x.ini");
        assertTrue(relative.erreur.startsWith("lancer : nulle-part/x.ini : fichier introuvable dans " + Path.of("").toAbsolutePath()),
                relative.toString());
        assertEquals(2, relative.code);
        verifierFichiers();
    }

    @Test
    void uneSceneQuOnNePeutAtteindreEstIntrouvable() throws IOException {
        Path boucle = lien("boucle", Path.of("boucle"));
        Path rompu = lien("rompu", Path.of("parti.ini"));
        for (Path scene : new Path[] {boucle, boucle.resolve("s.ini"), rompu, Path.of(SCENE, "s.ini").toAbsolutePath()}) {
            verifierRefus(2, scene + " : fichier introuvable ; attendu : un fichier de scène",
                    Essai.executer("--image", png.toString(), scene.toString()));
        }
    }

    @Test
    void laSortieNePeutEtreLaScene() throws IOException {
        Path sous = Files.createDirectory(dossier.resolve("sous"));
        Path ici = lien("ici", dossier);
        byte[] avant = Files.readAllBytes(Path.of(SCENE));
        for (String option : new String[] {"--image", "--lineaire"}) {
            String fin = option.equals("--image") ? ".png" : ".pfm";
            Path scene = Files.write(dossier.resolve("s" + fin), avant);
            String message = "la sortie est la scène elle-même : " + scene + " ; attendu : un autre fichier";
            Path[] ecritures = {scene, dossier.resolve(".").resolve("s" + fin), sous.resolve("..").resolve("s" + fin),
                lien("lien" + fin, scene), lien("lien-relatif" + fin, Path.of("s" + fin)), ici.resolve("s" + fin),
                Files.createLink(dossier.resolve("dur" + fin), scene)};
            for (Path sortie : ecritures) {
                verifierRefus(2, message, Essai.executer(option, sortie.toString(), scene.toString()));
            }
            assertArrayEquals(avant, Files.readAllBytes(scene));
        }
        verifierRefus(2, "la sortie est la scène elle-même : " + dossier.resolve("lien.png") + " ; attendu : un autre fichier",
                Essai.executer("--image", dossier.resolve("s.png").toString(), dossier.resolve("lien.png").toString()));
    }

    @Test
    void lesDeuxSortiesNePeuventEtreLeMemeFichier() throws IOException {
        Path ici = lien("ici", dossier);
        String nom = dossier.getFileName().toString();
        lien("un.pfm", png);
        lien("deux.pfm", Path.of("un.pfm"));
        Path[] ecritures = {dossier.resolve("un.pfm"), dossier.resolve("./un.pfm"), dossier.resolve("../" + nom + "/un.pfm"),
            ici.resolve("un.pfm"), dossier.resolve("deux.pfm")};
        for (Path autre : ecritures) {
            String refus = "la sortie est celle de --image et de --lineaire : " + dossier.toRealPath().resolve("image.png")
                    + " ; attendu : un autre fichier";
            Essai e = executer("--image", png.toString(), "--lineaire", autre.toString());
            verifierRefus(2, refus, e);
            e = executer("--lineaire=" + autre, "--image=" + ici.resolve("image.png"));
            verifierRefus(2, refus, e);
        }
        verifierFichiers("ici", "un.pfm", "deux.pfm");
    }

    @Test
    void unCheminParUnLienPuisPlusHautEstLeVraiChemin() throws IOException {
        Path ailleurs = Files.createDirectories(dossier.resolve("a/b"));
        Path scene = dossier.resolve("s.png");
        Files.copy(Path.of(SCENE), scene);
        Files.copy(Path.of(SCENE), dossier.resolve("a/s.png"));
        // b est a/b : b/.. est a, et non ce dossier
        Path autre = lien("b", ailleurs).resolve("../s.png");
        Essai e = Essai.executer("--taille=4x4", "--image", scene.toString(), autre.toString());
        assertEquals(0, e.code, e.toString());
        assertEquals(4, ImageIO.read(scene.toFile()).getWidth());
        assertArrayEquals(Files.readAllBytes(Path.of(SCENE)), Files.readAllBytes(dossier.resolve("a/s.png")));
    }

    @Test
    void lesRefletsEtLeSeuilChangentLImage() throws IOException {
        TreeSet<String> images = new TreeSet<>();
        for (String option : new String[] {"--reflets=0", "--reflets=1", "--reflets=5", "--seuil=0.3", "--seuil=1e9"}) {
            dessiner("--lineaire", pfm.toString(), option);
            images.add(Arrays.toString(Files.readAllBytes(pfm)));
        }
        // un seuil que rien n'atteint vaut zéro reflet
        assertEquals(4, images.size());
    }

    @Test
    void uneSectionQuePersonneNeLitEstNommeeUneFoisEtLImageDessinee() {
        String scene = Ressources.chemin("valides/avertie-brume.ini");
        Essai e = Essai.executer("--taille=8x6", "--repeter=3", "--image=" + png, "--lineaire=" + pfm, scene);
        assertEquals("lancer : " + scene + ", ligne 4, [Brume dense] : section laissée de côté ; attendu : la variante qui la lit, "
                + "java -jar brume/target/brume.jar" + System.lineSeparator(), e.erreur);
        assertEquals(0, e.code);
        verifierFichiers("image.png", "image.pfm");
        Essai pixel = Essai.executer("--pixel=1,1", scene);
        assertEquals(e.erreur, pixel.erreur);
        assertTrue(pixel.sortie.startsWith("pixel 1, 1"), pixel.toString());
    }

    private Map<String, String> statistiques(String... options) {
        Map<String, String> valeurs = new LinkedHashMap<>();
        for (String ligne : dessiner(Essai.suite(options, "--statistiques", "--image=" + png)).split("\r?\n")) {
            assertTrue(ligne.matches("[a-z]+(\\.[a-z]+)+: [0-9]+(\\.[0-9]+)?"), ligne);
            String[] moities = ligne.split(": ");
            assertEquals(null, valeurs.put(moities[0], moities[1]), ligne);
        }
        return valeurs;
    }

    @Test
    void lesStatistiquesOntUnPointDecimalDansToutesLesLangues() {
        Locale avant = Locale.getDefault();
        try {
            for (Locale langue : new Locale[] {Locale.FRANCE, Locale.ROOT, Locale.forLanguageTag("ar-EG-u-nu-arab"),
                Locale.forLanguageTag("tr-TR"), Locale.forLanguageTag("th-TH-u-nu-thai")}) {
                Locale.setDefault(langue);
                Map<String, String> valeurs = statistiques();
                for (String nom : new String[] {"rayons.primaires", "rayons.ombre", "rayons.reflechis", "tests.spheres", "noeuds.visites",
                    "pixels.raffines", "rayons.par.seconde"}) {
                    assertTrue(valeurs.get(nom).matches("[0-9]+"), nom + " : " + valeurs.get(nom));
                }
                for (String nom : new String[] {"lecture.ms", "preparation.ms", "trace.ms"}) {
                    assertTrue(valeurs.get(nom).matches("[0-9]+\\.[0-9]{3}"), nom + " : " + valeurs.get(nom));
                }
            }
        } finally {
            Locale.setDefault(avant);
        }
    }

    @Test
    void lesTempsSontVraisemblables() {
        long debut = System.nanoTime();
        Map<String, String> valeurs = statistiques("--fils=1");
        double mur = (System.nanoTime() - debut) / 1e6;
        double somme = Double.parseDouble(valeurs.get("lecture.ms")) + Double.parseDouble(valeurs.get("preparation.ms"))
                + Double.parseDouble(valeurs.get("trace.ms"));
        assertTrue(somme > 0 && somme <= mur, somme + " ms sur " + mur);
        long rayons = Long.parseLong(valeurs.get("rayons.primaires")) + Long.parseLong(valeurs.get("rayons.ombre"))
                + Long.parseLong(valeurs.get("rayons.reflechis"));
        double attendu = rayons / (Double.parseDouble(valeurs.get("trace.ms")) / 1000);
        assertEquals(1, Double.parseDouble(valeurs.get("rayons.par.seconde")) / attendu, 0.01);
    }
}
