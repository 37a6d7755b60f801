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
import java.util.List;
import java.util.Map;
import lancer.Couleur;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.contrat.Pave;
import lancer.contrat.Variante;
import lancer.essai.Essai;
import lancer.fils.Traceur;
import lancer.dessin.LancerSurveille;
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

    @Test
    void ceQuiEstEssayeEstCeQuiSeraDessine() {
        Scene lue = new Scene(scene.toString());
        Traceur prepare = LancerSurveille.preparer(lue, 90, 70, false);
        Essais essais = new Essais(prepare, 2);
        List<Finesse> finesses = Finesse.possibles(lue, Collections.<Variante>singletonList(new Antialias()));
        assertEquals(9, finesses.size());
        for (Finesse finesse : finesses) {
            Couleur[][] image = new Couleur[70][90];
            prepare.avec(finesse.echantillonnage, 0).TracerPixels((c, i, j) -> image[j][i] = c, 3, 2);
            int[] vus = new int[1];
            // les quatre blocs autour d'un coin de pavés, un du bord de l'image, et un de l'intérieur
            for (int k : new int[] {15 + 15 * 45, 16 + 15 * 45, 15 + 16 * 45, 16 + 16 * 45, 44 + 34 * 45, 22 + 20 * 45}) {
                Pave bloc = Pave.deRang(k, 90, 70, Essais.COTE);
                essais.passer(Collections.singletonList(bloc), (rang, b, fil) ->
                        finesse.echantillonnage.tracer(essais.entoure(b), b, fil.vue(3, 0), (c, i, j) -> {
                            if (bloc.contient(i, j)) {
                                assertEquals(image[j][i], c, finesse + ", pixel " + i + ", " + j);
                                vus[0]++;
                            }
                        }));
            }
            assertEquals(6 * 4, vus[0]);
        }
    }

    @Test
    void lesRayonsAttendusSontCeuxDuDessin() {
        Scene lue = new Scene(scene.toString());
        Traceur prepare = LancerSurveille.preparer(lue, 80, 60, false);
        Essais essais = new Essais(prepare, 2);
        List<Finesse> finesses = Finesse.possibles(lue, Collections.<Variante>singletonList(new Antialias()));
        EssaiFinesses essai = new EssaiFinesses(essais, essais.semer(4000, false), limites(), 1e7);
        for (Finesse finesse : finesses) {
            assertTrue(essai.essayer(finesse, 1e7, dessinee -> 1e7));
            Traceur lancer = prepare.avec(finesse.echantillonnage, 1.0 / 1024);
            lancer.TracerPixels((couleur, xe, ye) -> { }, 5, 2);
            double rayons = lancer.getCompteurs().primaires / (80.0 * 60);
            assertEquals(1, finesse.rayons / rayons, 0.2, finesse.toString());
        }
    }

    private static LimitesDesReflets limites() {
        return new LimitesDesReflets(5, 1.0 / 1024, new Estimation(0, 0), 1);
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
        assertTrue(rapport.get("attendu").contains("4.00 rayons de l'écran par pixel"), rapport.toString());
        assertEquals(4 * 120 * 90, essai.statistique("rayons.primaires"));
    }

    @Test
    void uneErreurPlusPetiteCoutePlusEtSeMesurePlusPetite() throws IOException {
        double erreur = Double.POSITIVE_INFINITY;
        long rayons = 0;
        for (String voulue : new String[] {"8", "2", "0.5"}) {
            Essai essai = Essai.executerAvec(Arrays.asList(Essai.origine(Antialias.class)), "--taille=120x90", "--auto=erreur=" + voulue,
                    "--statistiques", "--lineaire=" + dossier.resolve("auto.pfm"), scene.toString());
            assertFalse(rapport(essai).get("mesuré").endsWith("erreur voulue dépassée"), essai.erreur);
            double mesuree = Double.parseDouble(rapport(essai).get("mesuré").replaceAll("erreur de ([0-9.]+) .*", "$1"));
            assertTrue(mesuree <= Double.parseDouble(voulue) && mesuree < erreur, voulue + " : " + mesuree + " après " + erreur);
            long lances = essai.statistique("rayons.primaires") + essai.statistique("rayons.ombre")
                    + essai.statistique("rayons.reflechis");
            assertTrue(lances > rayons, voulue);
            erreur = mesuree;
            rayons = lances;
        }
    }

    @Test
    void unPaveEstUnNombreEntierDeBlocs() {
        assertEquals(0, Pave.COTE % Essais.COTE);
    }
}
