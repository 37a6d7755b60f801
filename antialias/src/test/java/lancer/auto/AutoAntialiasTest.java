package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import lancer.Lancer;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.contrat.Echantillonnage;
import lancer.dessin.Dessin;
import lancer.essai.Essai;
import lancer.scene.SectionLue;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code --auto} quand l'anticrénelage est là. */
class AutoAntialiasTest {

    @TempDir
    Path dossier;
    private Path scene;

    @BeforeEach
    void ecrireLaScene() throws IOException {
        scene = dossier.resolve("scene.ini");
        Files.write(scene, Essai.octets(Antialias.class, "/reference/p1-quatre.ini"));
    }

    /** Les lignes du rapport, sans ce qui les commence. */
    private static Map<String, String> rapport(Essai essai) {
        assertEquals(0, essai.code, essai.toString());
        Map<String, String> lignes = new LinkedHashMap<>();
        for (String ligne : essai.erreur.split("\r?\n")) {
            assertTrue(ligne.matches("lancer : auto, (choisi|attendu|mesuré) : .*"), ligne);
            String[] moities = ligne.substring("lancer : auto, ".length()).split(" : ", 2);
            lignes.put(moities[0], moities[1]);
        }
        assertEquals("[choisi, attendu, mesuré]", lignes.keySet().toString());
        return lignes;
    }

    /** Erreur et prix de chaque réglage, attendus de quelques pixels, contre ceux de l'image entière. */
    @Test
    void ceQuiEstAttenduDesReglagesEstCeQuIlsDessinent() {
        Lancer prepare = Dessin.lancer(new Scene(scene.toString()), 80, 60, false);
        Auto auto = new Auto(prepare, 0, null, null, 2,
                Collections.singletonMap(new Antialias(), new SectionLue("Antialias")), enCours -> { });
        assertEquals(new Antialias().getReglagesProposes(new SectionLue("Antialias")).size(), auto.essayes.size());
        double[][] juste = image(avec(prepare, Antialias.coins(16, 0), 0), 1000);
        for (Candidat reglage : auto.essayes) {
            Lancer lancer = avec(prepare, reglage.echantillonnage, reglage.seuil);
            double[][] image = image(lancer, reglage.reflets);
            assertEquals(1, reglage.prix * 80 * 60 / lancer.getCompteurs().rayons(), 0.25, reglage.toString());
            double somme = 0;
            for (int k = 0; k < image.length; k++) {
                somme += EchantillonPilote.produit(image[k], juste[k], juste[k]);
            }
            double vraie = Math.sqrt(somme / image.length);
            assertTrue(vraie > 0.7 * reglage.auMoins - 0.1 && vraie < 1.3 * reglage.auPlus + 0.1, reglage + " : de " + reglage.auMoins
                    + " à " + reglage.auPlus + ", vraie " + vraie);
        }
    }

    private static Lancer avec(Lancer prepare, Echantillonnage echantillonnage, double seuil) {
        Scene scene = prepare.getScene();
        return new Lancer(scene.avec(scene.getModele().avec(echantillonnage, seuil)), prepare.getCamera());
    }

    private static double[][] image(Lancer lancer, int reflets) {
        double[][] image = new double[80 * 60][];
        lancer.TracerPixels((couleur, i, j) -> image[j * 80 + i] = EchantillonPilote.niveaux(couleur), reflets, 2);
        return image;
    }

    @Test
    void leChoixSeRefaitALaMain() throws IOException {
        String[] communes = {"--taille=120x90", "--lineaire=" + dossier.resolve("auto.pfm"), "--auto=erreur=1"};
        Essai essai = Essai.executerAvec(Arrays.asList(Essai.origine(Antialias.class)), avec(communes, scene.toString()));
        String choisi = rapport(essai).get("choisi");
        assertTrue(choisi.matches("\\[Antialias\\] n=\\d+ methode=\\w+ seuil=[0-9.]+, --reflets \\d+ --seuil [0-9.]+"), choisi);
        String[] moities = choisi.split(", ");
        String section = moities[0].replace(" ", "\n");
        Files.write(scene, ("\n" + section + "\n").getBytes(StandardCharsets.UTF_8), StandardOpenOption.APPEND);
        String[] options = moities[1].split(" ");
        float[] alamain = Essai.dessinerAvec(Arrays.asList(Essai.origine(Antialias.class)), dossier, scene,
                avec(options, "--taille=120x90"));
        assertArrayEquals(alamain, Essai.pfm(Files.readAllBytes(dossier.resolve("auto.pfm"))));
    }

    private static String[] avec(String[] debut, String fin) {
        String[] tout = Arrays.copyOf(debut, debut.length + 1);
        tout[debut.length] = fin;
        return tout;
    }

    @Test
    void laSectionDeLaSceneEstRespectee() throws IOException {
        Files.write(scene, "\n[Antialias]\nn=2\nseuil=0\n".getBytes(StandardCharsets.UTF_8), StandardOpenOption.APPEND);
        Essai essai = Essai.executerAvec(Arrays.asList(Essai.origine(Antialias.class)), "--taille=120x90", "--auto=erreur=0.01",
                "--statistiques", "--lineaire=" + dossier.resolve("auto.pfm"), scene.toString());
        Map<String, String> rapport = rapport(essai);
        assertTrue(rapport.get("choisi").startsWith("l'échantillonnage de la scène, --reflets "), rapport.toString());
        assertEquals(4 * 120 * 90, essai.statistique("rayons.primaires"));
    }

    @Test
    void uneErreurPlusPetiteCoutePlusEtSeMesurePlusPetite() throws IOException {
        double erreur = Double.POSITIVE_INFINITY;
        long rayons = 0;
        for (String voulue : new String[] {"8", "2", "0.5"}) {
            Essai essai = Essai.executerAvec(Arrays.asList(Essai.origine(Antialias.class)), "--taille=120x90", "--auto=erreur=" + voulue,
                    "--statistiques", "--lineaire=" + dossier.resolve("auto.pfm"), scene.toString());
            assertFalse(rapport(essai).get("mesuré").contains("erreur voulue dépassée"), essai.erreur);
            String[] mesure = rapport(essai).get("mesuré").replaceAll("erreur de ([0-9.]+) ± ([0-9.]+) .*", "$1 $2").split(" ");
            double mesuree = Double.parseDouble(mesure[0]);
            assertTrue(mesuree - Double.parseDouble(mesure[1]) <= Double.parseDouble(voulue), essai.erreur);
            assertTrue(mesuree < erreur, voulue + " : " + mesuree + " après " + erreur);
            long lances = essai.statistique("rayons.primaires") + essai.statistique("rayons.ombre")
                    + essai.statistique("rayons.reflechis");
            assertTrue(lances > rayons, voulue);
            erreur = mesuree;
            rayons = lances;
        }
    }
}
