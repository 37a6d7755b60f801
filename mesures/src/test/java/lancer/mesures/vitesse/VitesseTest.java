package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.imageio.ImageIO;
import lancer.mesures.stabilite.Stabilite;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** La commande {@code make mesures}. */
class VitesseTest {

    private static final List<String> COURBES = Arrays.asList("scene1-rayons", "scene1-temps", "bowling-rayons", "bowling-temps",
            "miroirs-rayons", "miroirs-temps", "tournesol-rayons", "tournesol-temps", "phong-blinn", "demandes", "spheres",
            "stabilite-loin", "stabilite-ras", "stabilite-sol", "stabilite-carte", "stabilite-defauts");

    @TempDir
    Path dossier;

    private final ByteArrayOutputStream sortie = new ByteArrayOutputStream();
    private final ByteArrayOutputStream erreurs = new ByteArrayOutputStream();

    private int vitesse(String... args) throws IOException {
        return Vitesse.executer(args, new PrintStream(sortie, true, "UTF-8"), new PrintStream(erreurs, true, "UTF-8"));
    }

    @ParameterizedTest(name = "« {0} » est refusé d'une ligne")
    @ValueSource(strings = {"--vite", "--dossier", "--rapide=1", "scenes/scene1.ini"})
    void uneDemandeFausseTientEnUneLigne(String demande) throws IOException {
        assertEquals(2, vitesse(demande));
        assertEquals("", sortie.toString("UTF-8"));
        assertTrue(erreurs.toString("UTF-8").matches("Vitesse : .+\\R"), erreurs.toString("UTF-8"));
    }

    @Test
    void lanceeHorsDuProjetElleLeDitDUneLigneEtNEcritRien() throws IOException, InterruptedException {
        Path ailleurs = Files.createDirectories(dossier.resolve("ailleurs").resolve("loin"));
        Process processus = new ProcessBuilder(Paths.get(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), Vitesse.class.getName(), "--rapide").directory(ailleurs.toFile())
                .redirectErrorStream(true).redirectOutput(dossier.resolve("sortie.txt").toFile()).start();
        assertEquals(2, processus.waitFor());
        List<String> lignes = Files.readAllLines(dossier.resolve("sortie.txt"));
        assertEquals(1, lignes.size(), lignes.toString());
        assertTrue(lignes.get(0).contains("à la racine du projet"), lignes.get(0));
        try (java.util.stream.Stream<Path> ecrits = Files.list(ailleurs)) {
            assertEquals(0, ecrits.count());
        }
    }

    @Test
    void sansMesuresADessinerElleLeDitDUneLigne() throws IOException {
        assertEquals(1, vitesse("--dessiner", "--dossier", dossier.toString()));
        assertTrue(erreurs.toString("UTF-8").matches("Vitesse : .+\\R"), erreurs.toString("UTF-8"));
    }

    @Test
    void toutesLesCourbesSeRedessinentDesMesuresNoteesMemeSiLEcranNeRepondPas() throws IOException, InterruptedException {
        for (String nom : new String[] {Ouvrier.CSV, "besoins.csv", Stabilite.CSV}) {
            Files.copy(Faux.projet("mesures/resultats").resolve(nom), dossier.resolve(nom));
        }
        ProcessBuilder commande = new ProcessBuilder(Paths.get(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), Vitesse.class.getName(), "--dessiner", "--dossier", dossier.toString());
        commande.environment().put("DISPLAY", ":987");
        assertEquals(0, commande.inheritIO().redirectOutput(dossier.resolve("sortie.txt").toFile()).start().waitFor());
        Set<Integer> differentes = new HashSet<>();
        for (String courbe : COURBES) {
            BufferedImage image = ImageIO.read(dossier.resolve(courbe + ".png").toFile());
            assertEquals(1600, image.getWidth(), courbe);
            assertTrue(image.getHeight() >= 1000, courbe);
            int[] pixels = image.getRGB(0, 0, 1600, 1000, null, 0, 1600);
            long encre = Arrays.stream(pixels).filter(p -> p != -1).count();
            assertTrue(encre > 30000 && encre < 1300000, courbe + " : " + encre + " pixels dessinés");
            differentes.add(Arrays.hashCode(pixels));
        }
        assertEquals(COURBES.size(), differentes.size());
        assertFalse(Files.exists(dossier.resolve("scene1-rayons.png.tmp")));
    }

    @Test
    void rapideElleNEcritQueDansSonDossierEtNeMesureQuUnePartieDuCatalogue() {
        OptionsVitesse rapide = OptionsVitesse.lire("--rapide");
        assertEquals(rapide.atelier, rapide.resultats);
        assertFalse(rapide.montres());
        assertNotEquals(rapide.atelier, OptionsVitesse.lire().atelier);
        assertTrue(OptionsVitesse.lire().montres());
        Set<String> toutes = new HashSet<>();
        Travail.tous(false).forEach(t -> t.methodes().forEach(m -> assertTrue(toutes.add(t.scene + m.cle()), m.cle())));
        Travail.tous(true).forEach(t -> t.methodes().forEach(m -> assertTrue(toutes.contains(t.scene + m.cle()), m.cle())));
    }

    @Test
    void chaqueReglageParDefautEstMesureUneFoisParScene() throws IOException {
        Releves releves = new Releves(new Journal(Faux.projet("mesures/resultats").resolve(Ouvrier.CSV)).lire());
        assertEquals(new Catalogue(false).scenes(), releves.de(Famille.ECHANTILLONNAGE).scenes());
        for (String scene : new Catalogue(false).scenes()) {
            assertEquals(2, releves.de(scene, Famille.ECHANTILLONNAGE).get().stream().filter(Catalogue::estParDefaut).count());
            assertEquals(1, releves.de(scene, Famille.REFLETS).get().stream().filter(Catalogue::estParDefaut).count());
        }
    }

    @Test
    void laVeriteEstConnueBienMieuxQueLesErreursQuElleJuge() throws IOException {
        Releves releves = new Releves(new Journal(Faux.projet("mesures/resultats").resolve(Ouvrier.CSV)).lire());
        for (String scene : releves.de(Famille.VERITE).scenes()) {
            double reste = releves.de(scene, Famille.VERITE).de("moyenne").get().get(0).erreurEnPas();
            Releve defaut = Constats.defaut(releves.de(scene, Famille.ECHANTILLONNAGE), Catalogue.COINS);
            assertTrue(reste < defaut.erreurEnPas() / 5, scene + " : " + reste + " pas");
            assertTrue(releves.de(scene, Famille.VERITE).de("sans limite").get().get(0).erreurEnPas() < 1e-6, scene);
        }
    }
}
