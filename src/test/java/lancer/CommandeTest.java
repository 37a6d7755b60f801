package lancer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.TreeSet;
import javax.imageio.ImageIO;
import lancer.commande.Echec;
import lancer.sortie.Ecriture;
import lancer.sortie.FichierPfm;
import lancer.sortie.FichierPng;
import lancer.sortie.ImageMemoire;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Le programme sans fenêtre : de la ligne de commande aux fichiers, au statut et à la ligne d'erreur. */
class CommandeTest {

    private static final String SCENE = Ressources.chemin("reference/p3-miroirs.ini");

    @TempDir
    Path dossier;
    private Path png;
    private Path pfm;

    @BeforeEach
    void nommerLesSorties() throws IOException {
        dossier = dossier.toRealPath();
        png = dossier.resolve("image.png");
        pfm = dossier.resolve("image.pfm");
    }

    /** Dessine la scène en petit ; la demande doit aboutir, sans rien dire. */
    private static String dessiner(String... arguments) {
        Essai e = executer(arguments);
        assertEquals(0, e.code, e.toString());
        assertEquals("", e.erreur);
        return e.sortie;
    }

    private static Essai executer(String... arguments) {
        String[] tous = Arrays.copyOf(arguments, arguments.length + 3);
        tous[arguments.length] = "--taille";
        tous[arguments.length + 1] = "40x30";
        tous[arguments.length + 2] = SCENE;
        return Essai.executer(tous);
    }

    private static void verifierRefus(int statut, String message, Essai e) {
        assertEquals("lancer : " + message + System.lineSeparator(), e.erreur);
        assertEquals(statut, e.code);
        assertEquals("", e.sortie);
    }

    private void verifierFichiers(String... noms) {
        assertEquals(new TreeSet<>(Arrays.asList(noms)), new TreeSet<>(Arrays.asList(dossier.toFile().list())));
    }

    private static void ecrireTexte(Path fichier, String texte) throws IOException {
        Files.write(fichier, texte.getBytes(StandardCharsets.UTF_8));
    }

    private static String lireTexte(Path fichier) throws IOException {
        return new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
    }

    /** Un lien symbolique ; le test est passé là où le système n'en permet pas. */
    private Path lien(String nom, Path vers) throws IOException {
        try {
            return Files.createSymbolicLink(dossier.resolve(nom), vers);
        } catch (UnsupportedOperationException e) {
            assumeTrue(false, "pas de liens symboliques ici");
            return null;
        }
    }

    // l'aide

    @Test
    void lAideDitToutesLesOptions() {
        for (String demande : new String[] {"--aide", "--help", "-h"}) {
            Essai e = Essai.executer(demande);
            assertEquals(0, e.code);
            assertEquals("", e.erreur);
            for (String option : "--image --lineaire --taille --reflets --seuil --fils --repeter --statistiques --auto --aide --help -h --version"
                    .split(" ")) {
                assertTrue(e.sortie.contains(option), option);
            }
        }
        Essai version = Essai.executer("--version");
        assertEquals(0, version.code);
        assertTrue(version.sortie.startsWith("lancer "), version.toString());
    }

    // les demandes fausses

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
        verifierRefus(2, "nulle-part/x.ini : fichier introuvable ; attendu : un fichier de scène",
                Essai.executer("--image", png.toString(), "nulle-part/x.ini"));
        verifierFichiers();
    }

    @Test
    void laSortieNePeutEtreLaScene() throws IOException {
        Path scene = dossier.resolve("s.ini");
        Files.copy(Paths.get(SCENE), scene);
        byte[] avant = Files.readAllBytes(scene);
        String message = "la sortie est la scène elle-même : " + scene + " ; attendu : un autre fichier";
        Path sous = Files.createDirectory(dossier.resolve("sous"));
        Path[] ecritures = {scene, dossier.resolve(".").resolve("s.ini"), sous.resolve("..").resolve("s.ini"), lien("lien.png", scene),
            lien("lien-relatif.png", Paths.get("s.ini")), lien("ici", dossier).resolve("s.ini"),
            Files.createLink(dossier.resolve("dur.png"), scene)};
        for (Path sortie : ecritures) {
            verifierRefus(2, message, Essai.executer("--image", sortie.toString(), scene.toString()));
            verifierRefus(2, message, Essai.executer("--lineaire=" + sortie, scene.toString()));
        }
        assertArrayEquals(avant, Files.readAllBytes(scene));
        verifierRefus(2, "la sortie est la scène elle-même : " + dossier.resolve("lien.png") + " ; attendu : un autre fichier",
                Essai.executer("--image", scene.toString(), dossier.resolve("lien.png").toString()));
    }

    @Test
    void lesDeuxSortiesNePeuventEtreLeMemeFichier() throws IOException {
        Path ici = lien("ici", dossier);
        String nom = dossier.getFileName().toString();
        Path[] ecritures = {png, dossier.resolve("./image.png"), dossier.resolve("../" + nom + "/image.png"), ici.resolve("image.png"),
            lien("versImage", png), lien("versVers", Paths.get("versImage"))};
        for (Path autre : ecritures) {
            String attendu = " ; attendu : deux fichiers";
            Essai e = executer("--image", png.toString(), "--lineaire", autre.toString());
            verifierRefus(2, "--image et --lineaire écrivent le même fichier : " + png + attendu, e);
            e = executer("--lineaire", png.toString(), "--image", autre.toString());
            verifierRefus(2, "--image et --lineaire écrivent le même fichier : " + autre + attendu, e);
        }
        verifierFichiers("ici", "versImage", "versVers");
    }

    @Test
    void unCheminParUnLienPuisPlusHautEstLeVraiChemin() throws IOException {
        Path ailleurs = Files.createDirectories(dossier.resolve("a/b"));
        Path scene = dossier.resolve("s.ini");
        Files.copy(Paths.get(SCENE), scene);
        Files.copy(Paths.get(SCENE), dossier.resolve("a/s.ini"));
        // b est a/b : b/.. est a, et non ce dossier
        Path autre = lien("b", ailleurs).resolve("../s.ini");
        Essai e = Essai.executer("--taille=4x4", "--image", scene.toString(), autre.toString());
        assertEquals(0, e.code, e.toString());
        assertEquals(4, ImageIO.read(scene.toFile()).getWidth());
        assertArrayEquals(Files.readAllBytes(Paths.get(SCENE)), Files.readAllBytes(dossier.resolve("a/s.ini")));
    }

    // les sorties impossibles

    @Test
    void unDossierAbsentOuUnDossierEnSortieEstUnePanne() throws IOException {
        Path absent = dossier.resolve("absent").resolve("image.png");
        verifierRefus(1, absent + " : écriture impossible, le dossier n'existe pas", executer("--image", absent.toString()));
        verifierRefus(1, dossier + " : écriture impossible, c'est un dossier", executer("--lineaire", dossier.toString()));
        ecrireTexte(png, "pas un dossier");
        Path dessous = png.resolve("image.png");
        verifierRefus(1, dessous + " : écriture impossible, le dossier n'existe pas", executer("--image", dessous.toString()));
        verifierFichiers("image.png");
    }

    @Test
    void unDisquePleinSeDit() {
        assumeTrue(Files.exists(Paths.get("/dev/full")), "pas de /dev/full ici");
        verifierRefus(1, "/dev/full : écriture impossible, disque plein", executer("--image", "/dev/full"));
        verifierRefus(1, "/dev/full : écriture impossible, disque plein", executer("--statistiques", "--lineaire", "/dev/full"));
    }

    @Test
    void unEchecNeDitQueLui() throws IOException {
        assumeTrue(Files.exists(Paths.get("/dev/full")), "pas de /dev/full ici");
        String scene = Ressources.chemin("valides/avertie-brume.ini");
        verifierRefus(1, "/dev/full : écriture impossible, disque plein", Essai.executer("--taille=4x4", "--image=/dev/full", scene));
    }

    @Test
    void unDossierOuUnFichierProtegeEstUnePanne() throws IOException {
        Path protege = Files.createDirectory(dossier.resolve("protege"));
        Path sortie = protege.resolve("image.png");
        ecrireTexte(png, "avant");
        assumeTrue(protege.toFile().setWritable(false) && png.toFile().setWritable(false));
        try {
            assumeFalse(Files.isWritable(protege), "cet utilisateur peut tout écrire");
            verifierRefus(1, sortie + " : écriture impossible, écriture interdite", executer("--image", sortie.toString()));
            verifierRefus(1, png + " : écriture impossible, écriture interdite", executer("--image", png.toString()));
            assertEquals("avant", lireTexte(png));
        } finally {
            assertTrue(protege.toFile().setWritable(true));
        }
    }

    @Test
    void desLiensSansFinSontUnePanne() throws IOException {
        Path boucle = lien("boucle", Paths.get("boucle"));
        verifierRefus(1, boucle + " : écriture impossible, trop de liens symboliques", executer("--image", boucle.toString()));
    }

    @Test
    void unePanneDeLaMachineDitQuoiFaire() {
        assertEquals("trop de fils d'exécution pour cette machine ; en demander moins, par exemple --fils 2",
                Main.message(new OutOfMemoryError("unable to create native thread: possibly out of memory")));
        assertEquals("mémoire épuisée ; donner plus à Java, par exemple java -Xmx2g -jar …", Main.message(new OutOfMemoryError()));
        assertEquals("échec du programme : java.lang.IllegalStateException: a\\nb",
                Main.message(new IllegalStateException("a\nb")));
    }

    // ce qui est écrit

    @Test
    void uneImageRemplaceLAncienneEnEntierEtRienNeTraine() throws IOException {
        ecrireTexte(png, String.join("", Collections.nCopies(100_000, "vieux")));
        dessiner("--image", png.toString(), "--lineaire", pfm.toString());
        assertTrue(Files.size(png) < 10_000);
        assertEquals(40, ImageIO.read(png.toFile()).getWidth());
        verifierFichiers("image.png", "image.pfm");
    }

    @Test
    void uneEcritureQuiEchoueLaisseLeFichierCommeAvant() throws IOException {
        ecrireTexte(png, "avant");
        ImageMemoire image = new ImageMemoire(3, 2, true);
        Map<String, Ecriture.Format> pannes = new LinkedHashMap<>();
        pannes.put("disque plein", (i, sortie) -> {
            FichierPng.ecrire(i, sortie);
            throw new IOException("No space left on device");
        });
        pannes.put("la prise est débranchée", (i, sortie) -> {
            sortie.write(new byte[1 << 20]);
            throw new IOException("la prise est débranchée");
        });
        for (Map.Entry<String, Ecriture.Format> panne : pannes.entrySet()) {
            for (Path sortie : new Path[] {png, pfm}) {
                try {
                    new Ecriture(sortie.toString()).ecrire(image, panne.getValue());
                    assertTrue(false, "aucun échec");
                } catch (Echec e) {
                    assertEquals(sortie + " : écriture impossible, " + panne.getKey(), e.getMessage());
                    assertEquals(1, e.getCode());
                }
            }
        }
        try {
            new Ecriture(png.toString()).ecrire(image, (i, sortie) -> {
                throw new OutOfMemoryError();
            });
        } catch (OutOfMemoryError e) {
            assertEquals("avant", lireTexte(png));
        }
        assertEquals("avant", lireTexte(png));
        verifierFichiers("image.png");
    }

    @Test
    void unLienSymboliqueEstSuivi() throws IOException {
        Path ailleurs = Files.createDirectory(dossier.resolve("ailleurs"));
        Path vraie = ailleurs.resolve("vraie.png");
        Path lien = lien("lien.png", Paths.get("ailleurs/vraie.png"));
        for (int fois = 0; fois < 2; fois++) {
            // la première fois, il ne mène encore à rien
            dessiner("--image", lien.toString());
            assertTrue(Files.isSymbolicLink(lien));
            assertTrue(Files.isRegularFile(vraie));
            assertEquals(40, ImageIO.read(vraie.toFile()).getWidth());
        }
        assertArrayEquals(new String[] {"vraie.png"}, ailleurs.toFile().list());
    }

    @Test
    void unNomAussiLongQueLeSystemeLePermetConvient() {
        StringBuilder nom = new StringBuilder();
        while (nom.length() < 251) {
            nom.append('n');
        }
        dessiner("--image", dossier.resolve(nom + ".png").toString());
        verifierFichiers(nom + ".png");
    }

    @Test
    void leNeantEstUneSortiePermise() {
        assumeTrue(Files.exists(Paths.get("/dev/null")), "pas de /dev/null ici");
        dessiner("--image", "/dev/null");
        dessiner("--lineaire", "/dev/null", "--image", png.toString());
        assertFalse(Files.isRegularFile(Paths.get("/dev/null")));
        verifierFichiers("image.png");
    }

    @Test
    void lePngEtLePfmDisentLaMemeImage() throws IOException {
        dessiner("--image", png.toString(), "--lineaire", pfm.toString());
        BufferedImage image = ImageIO.read(png.toFile());
        float[] c = Essai.pfm(Files.readAllBytes(pfm));
        assertEquals(40, image.getWidth());
        assertEquals(30, image.getHeight());
        for (int j = 0; j < 30; j++) {
            for (int i = 0; i < 40; i++) {
                // la ligne du bas est la première du PFM
                int k = 3 * (40 * (29 - j) + i);
                assertEquals(new Couleur(c[k], c[k + 1], c[k + 2]).getCode(), image.getRGB(i, j), "pixel " + i + ", " + j);
            }
        }
    }

    @Test
    void lePngEstJusteAToutesLesTailles() throws IOException {
        for (int[] taille : new int[][] {{1, 1}, {1, 100}, {100, 1}, {3, 2}, {257, 255}, {16384, 3}, {3, 16384}}) {
            ImageMemoire memoire = new ImageMemoire(taille[0], taille[1], false);
            Random hasard = new Random(taille[0]);
            for (int k = 0; k < memoire.getCodes().length; k++) {
                memoire.getCodes()[k] = 0xFF000000 | hasard.nextInt();
            }
            new Ecriture(png.toString()).ecrire(memoire, FichierPng::ecrire);
            BufferedImage lue = ImageIO.read(png.toFile());
            assertArrayEquals(memoire.getCodes(), lue.getRGB(0, 0, taille[0], taille[1], null, 0, taille[0]), Arrays.toString(taille));
        }
    }

    @Test
    void lePfmCommenceParLeBasEtEstPetitBoutiste() throws IOException {
        ImageMemoire memoire = new ImageMemoire(2, 2, true);
        memoire.drawPixel(new Couleur(1, 2, 3), 0, 0);
        memoire.drawPixel(new Couleur(4, 5, 6), 1, 0);
        memoire.drawPixel(new Couleur(-7, 1e6, 0.1), 0, 1);
        memoire.drawPixel(new Couleur(0), 1, 1);
        new Ecriture(pfm.toString()).ecrire(memoire, FichierPfm::ecrire);
        ByteBuffer octets = ByteBuffer.wrap(Files.readAllBytes(pfm)).order(ByteOrder.LITTLE_ENDIAN);
        byte[] entete = new byte["PF\n2 2\n-1.0\n".length()];
        octets.get(entete);
        assertEquals("PF\n2 2\n-1.0\n", new String(entete, StandardCharsets.US_ASCII));
        for (float attendu : new float[] {-7, 1e6f, 0.1f, 0, 0, 0, 1, 2, 3, 4, 5, 6}) {
            assertEquals(attendu, octets.getFloat());
        }
        assertFalse(octets.hasRemaining());
    }

    @Test
    void lImageNeDependNiDesFilsNiDesRepetitions() throws IOException {
        byte[] attendue = null;
        for (String[] options : new String[][] {{}, {"--fils=1"}, {"--fils=2"}, {"--fils=7"}, {"--fils=1024"}, {"--repeter=3"}, {"--simple"}}) {
            String[] arguments = Arrays.copyOf(options, options.length + 1);
            arguments[options.length] = "--lineaire=" + pfm;
            dessiner(arguments);
            byte[] image = Files.readAllBytes(pfm);
            attendue = attendue == null ? image : attendue;
            assertArrayEquals(attendue, image, Arrays.toString(options));
        }
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
    }

    // --auto

    @Test
    void leChoixSeDitEnTroisLignesEtLImageEstEcrite() {
        Essai e = executer("--auto", "erreur=30", "--repeter=2", "--image=" + png, "--lineaire=" + pfm);
        assertEquals(0, e.code, e.toString());
        assertEquals("", e.sortie);
        String[] lignes = e.erreur.split(System.lineSeparator());
        assertEquals(3, lignes.length, e.erreur);
        assertTrue(lignes[0].matches("lancer : auto, choisi : un rayon par pixel, --reflets \\d+( --seuil [0-9.]+)?"), lignes[0]);
        assertTrue(lignes[1].matches("lancer : auto, attendu : erreur de [0-9.]+, au plus [0-9.]+ ; 1.00 rayons de l'écran par pixel, "
                + "[0-9.]+ avec les ombres et les reflets ; le moins cher de \\d+ réglages pour une erreur de 30.00"), lignes[1]);
        assertTrue(lignes[2].matches("lancer : auto, mesuré : erreur de [0-9.]+ ± [0-9.]+ sur \\d+ pixels de l'image, autres que les \\d+ "
                + "du choix ; dessin en [0-9.]+ s, essais en [0-9.]+ s ; erreur voulue tenue"), lignes[2]);
        verifierFichiers("image.png", "image.pfm");
    }

    @Test
    void leChoixEstCeluiDUnDessinALaMain() throws IOException {
        Essai e = executer("--auto", "erreur=12", "--lineaire=" + pfm);
        String choisi = e.erreur.split(System.lineSeparator())[0].replaceAll(".*(--reflets .*)", "$1");
        byte[] auto = Files.readAllBytes(pfm);
        String[] options = choisi.split(" ");
        String[] arguments = Arrays.copyOf(options, options.length + 1);
        arguments[options.length] = "--lineaire=" + pfm;
        dessiner(arguments);
        assertArrayEquals(Files.readAllBytes(pfm), auto, choisi);
    }

    @Test
    void leCheminLisibleChoisitDeMeme() {
        String choisi = executer("--auto", "erreur=12", "--image=" + png).erreur.split(System.lineSeparator())[1];
        assertEquals(choisi, executer("--auto", "erreur=12", "--simple", "--image=" + png).erreur.split(System.lineSeparator())[1]);
    }

    @Test
    void uneErreurHorsDePorteeSeDitEtLImageEstLaPlusJuste() {
        Essai e = executer("--auto", "erreur=0.01", "--image=" + png);
        assertEquals(0, e.code, e.toString());
        assertTrue(e.erreur.matches("(?s).* ; aucun de \\d+ réglages ne promet une erreur de 0.01, voici le plus juste\\R.* erreur voulue "
                + "dépassée\\R"), e.erreur);
        e = executer("--auto", "erreur=0.01", "--reflets=2", "--seuil=0", "--image=" + png);
        assertTrue(e.erreur.contains("un rayon par pixel, --reflets 2 --seuil 0" + System.lineSeparator()), e.erreur);
        assertTrue(e.erreur.contains(" ; seul réglage permis, qui ne promet pas une erreur de 0.01" + System.lineSeparator()), e.erreur);
    }

    @Test
    void unTempsVouluSeDitAussi() {
        Essai e = executer("--auto=temps=3600s", "--image=" + png);
        assertTrue(e.erreur.matches("(?s).* s de dessin ; le plus juste de \\d+ réglages pour 3600.000 s de dessin\\R.* ; temps voulu "
                + "tenu\\R"), e.erreur);
    }

    @Test
    void unEchecApresLeChoixNeDitQueLui() {
        assumeTrue(Files.exists(Paths.get("/dev/full")), "pas de /dev/full ici");
        verifierRefus(1, "/dev/full : écriture impossible, disque plein", executer("--auto=erreur=30", "--image", "/dev/full"));
    }

    @Test
    void lesStatistiquesDuChoixSAjoutentAuxAutres() {
        Essai e = executer("--auto", "erreur=30", "--statistiques", "--image=" + png);
        String[] lignes = e.sortie.split("\r?\n");
        for (String ligne : lignes) {
            assertTrue(ligne.matches("[a-z]+(\\.[a-z]+)+: [0-9]+(\\.[0-9]+)?"), ligne);
        }
        assertEquals("[auto.erreur.attendue, auto.erreur.mesuree, auto.essais.ms]",
                Arrays.toString(Arrays.stream(lignes).filter(l -> l.startsWith("auto.")).map(l -> l.replaceAll(":.*", "")).toArray()));
        // les rayons des essais n'en sont pas
        assertEquals(1200, e.statistique("rayons.primaires"));
    }

    // les statistiques

    private static Map<String, String> statistiques(String... options) {
        String[] arguments = Arrays.copyOf(options, options.length + 3);
        arguments[options.length] = "--statistiques";
        arguments[options.length + 1] = "--image";
        arguments[options.length + 2] = System.getProperty("os.name").startsWith("Windows") ? "NUL" : "/dev/null";
        Map<String, String> valeurs = new LinkedHashMap<>();
        for (String ligne : dessiner(arguments).split("\r?\n")) {
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
    void lesComptesSontCeuxDUnDessin() {
        Map<String, String> attendus = statistiques("--fils=1");
        assertEquals("1200", attendus.get("rayons.primaires"));
        assertNotEquals("0", attendus.get("rayons.ombre"));
        assertNotEquals("0", attendus.get("rayons.reflechis"));
        assertEquals("0", attendus.get("pixels.raffines"));
        for (String option : new String[] {"--fils=2", "--fils=7", "--repeter=2", "--repeter=5"}) {
            Map<String, String> valeurs = statistiques(option);
            for (String nom : new String[] {"rayons.primaires", "rayons.ombre", "rayons.reflechis", "tests.spheres", "noeuds.visites",
                "pixels.raffines"}) {
                assertEquals(attendus.get(nom), valeurs.get(nom), nom + " avec " + option);
            }
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

    @Test
    void uneSortieStandardPleineEstUnePanne() throws IOException {
        assumeTrue(Files.exists(Paths.get("/dev/full")), "pas de /dev/full ici");
        ByteArrayOutputStream erreur = new ByteArrayOutputStream();
        try (PrintStream pleine = new PrintStream("/dev/full", "UTF-8"); PrintStream e = new PrintStream(erreur, true, "UTF-8")) {
            assertEquals(1, Main.executer(new String[] {"--aide"}, pleine, e));
        }
        assertEquals("lancer : sortie standard : écriture impossible" + System.lineSeparator(), erreur.toString("UTF-8"));
    }
}
