package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import lancer.Lampe;
import lancer.Point;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.essai.Ressources;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Écrire dans la scène : la valeur d'une ligne {@code centre} ou {@code position} change, et pas un autre octet. */
class PlacesEcritesTest {

    /** Une scène où {@code @1}, {@code @2} et {@code @3} sont les places, entourées de ce qui leur ressemble. */
    private static final String SCENE = "; centre=9 9 9\n[SPHERE  \t a]\n\t CENTRE \t=  @1 \t\n# centre=8 8 8\nrayon = 1\nKd=1 0 0\n\n"
            + "[Lampe]\ncouleur:1 1 1\n;position=0 0 0\nposition:@2\n[Sphere é œ 😀]\nrayon=.5\n  ; position=7 7 7\ncentre=@3";

    @TempDir
    Path dossier;
    private Path fichier;

    @BeforeEach
    void nommer() {
        fichier = dossier.resolve("s.ini");
    }

    private static byte[] scene(String modele, String... places) {
        String texte = modele;
        for (int k = 0; k < places.length; k++) {
            texte = texte.replace("@" + (k + 1), places[k]);
        }
        return texte.getBytes(StandardCharsets.UTF_8);
    }

    private SceneLue lire(byte[] octets) throws IOException {
        Files.write(fichier, octets);
        return LecteurScene.lireEtGarder(fichier.toString(), part -> { });
    }

    private static SceneLue avec(SceneLue lue, Object chose, Point place) {
        return lue.avec(lue.getNomDeSection(chose), chose instanceof Lampe ? "position" : "centre", SceneLue.ecrire(place));
    }

    /** Celles qui se changent dans la fenêtre. */
    @Test
    void lesClesDUneSectionSontCellesDeSonTypeEtKrParSonNom() throws IOException {
        SceneLue lue = lire(scene("[Sphere a]\ncentre=0 0 1\nrayon=1\nKr=1 1 1\n[Sphere b]\ncentre=0 0 2\nrayon=1\n"
                + "[Lampe]\nposition=0 0 0\ncouleur=1 1 1\n"));
        assertEquals("[centre, rayon, Kd, Kr, ns]", lue.getSection("Sphere a").getCles().toString());
        assertEquals("[centre, rayon, Kd, Ks, ns]", lue.getSection("Sphere b").getCles().toString());
        assertEquals("[position, couleur]", lue.getSection("Lampe").getCles().toString());
    }

    private static byte[] ecrits(SceneLue lue, SceneLue voulue) {
        return voulue.ecrireDans(lue.getTexte(), lue).getOctets();
    }

    private static void verifier(byte[] attendus, byte[] ecrits) {
        assertEquals(new String(attendus, StandardCharsets.UTF_8), new String(ecrits, StandardCharsets.UTF_8));
        assertArrayEquals(attendus, ecrits);
    }

    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r\n", "\r"})
    void seulesLesLignesDeplaceesChangent(String fin) throws IOException {
        for (String debut : new String[] {"", "\uFEFF"}) {
            for (String bout : new String[] {"", fin, fin + fin, " " + fin, fin + "; fin"}) {
                String modele = debut + SCENE.replace("\n", fin) + bout;
                SceneLue lue = lire(scene(modele, "0 0.2 6", "-4 6 -3", "1  1\t7"));
                SceneLue voulue = avec(lue, lue.lampes.get(0), new Point(3, 3, 0));
                verifier(scene(modele, "0 0.2 6", "3 3 0", "1  1\t7"), ecrits(lue, voulue));
                voulue = avec(avec(voulue, lue.objets.get(1), new Point(1e-7, -2, .5)), lue.objets.get(0), new Point(0.25, 0.2, 6));
                byte[] ecrits = ecrits(lue, voulue);
                verifier(scene(modele, "0.25 0.2 6", "3 3 0", SceneLue.ecrire(new Point(1e-7, -2, .5))), ecrits);
                SceneLue relue = lire(ecrits);
                assertEquals(new Point(0.25, 0.2, 6), ((Sphere) relue.objets.get(0)).getCentre());
                assertEquals(new Point(1e-7, -2, .5), ((Sphere) relue.objets.get(1)).getCentre());
                assertEquals(new Point(3, 3, 0), relue.lampes.get(0).getPosition());
            }
        }
    }

    @Test
    void lesFinsDeLigneMeleesRestentMelees() throws IOException {
        String modele = "\n\r\n\r[Sphere 1]\r\r\ncentre=@1\rrayon=1\n[Lampe 1]\r\nposition=@2\r\ncouleur=1 1 1";
        SceneLue lue = lire(scene(modele, "0 0 6", "1 2 3"));
        SceneLue voulue = avec(avec(lue, lue.lampes.get(0), new Point(4, 5, 6)), lue.objets.get(0), new Point(1, 0, 6));
        verifier(scene(modele, "1 0 6", "4 5 6"), ecrits(lue, voulue));
    }

    static Stream<Path> scenes() {
        return Stream.of("scenes", Ressources.chemin("valides")).flatMap(dossier -> Ressources.scenes(Path.of(dossier)).stream());
    }

    private static List<Object> choses(SceneLue lue) {
        List<Object> choses = new ArrayList<>(lue.objets);
        choses.addAll(lue.lampes);
        return choses;
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void uneSceneDeplaceePuisRemiseEstCelleDAvant(Path scene) throws IOException {
        byte[] avant = Files.readAllBytes(scene);
        SceneLue lue = lire(avant);
        verifier(avant, ecrits(lue, lue));
        for (int rang = 0; rang < choses(lue).size(); rang += 1 + choses(lue).size() / 10) {
            Object chose = choses(lue).get(rang);
            if (chose instanceof Lampe || chose.getClass() == Sphere.class) {
                Point place = new Point(1, 2, 3);
                byte[] ecrits = ecrits(lue, avec(lue, chose, place));
                Object deplacee = choses(lire(ecrits)).get(rang);
                assertEquals(place, SceneLue.place(deplacee));
                lue = lire(avant);
            }
        }
    }

    @Test
    void uneBouleDeplaceeGardeSonRayonEtSaMatiere() throws IOException {
        SceneLue lue = lire(scene(SCENE, "0 0.2 6", "-4 6 -3", "1 1 7"));
        Sphere boule = (Sphere) lue.objets.get(0);
        SceneLue voulue = avec(lue, boule, new Point(1, 2, 3));
        Sphere deplacee = (Sphere) voulue.objets.get(0);
        assertEquals(List.of(new Point(1, 2, 3), boule.getRayon(), boule.getKd(), boule.getKs(), boule.getNs()),
                List.of(deplacee.getCentre(), deplacee.getRayon(), deplacee.getKd(), deplacee.getKs(), deplacee.getNs()));
        assertEquals(new Point(0, 0.2, 6), boule.getCentre(), "celle d'avant reste à sa place");
    }

    private static final String BOULE = "[Sphere 1]\ncentre=0 0.2 6\nrayon=1\n";

    private String fichier() throws IOException {
        return Files.readString(fichier);
    }

    @Test
    void uneCleChangeeSEcritDansLeFichierQueDAutresOntChange() throws IOException {
        SceneLue lue = lire(scene(BOULE));
        SceneLue voulue = lue.avec("Sphere 1", "rayon", "2");
        Files.write(fichier, scene("; neuf\n[Lampe 1]\nposition=0 0 0\ncouleur=1 1 1\n\n" + BOULE.replace("0.2", "0.3")));
        EcritureScene.remplacer(voulue, lue, lue.getTexte());
        assertEquals("; neuf\n[Lampe 1]\nposition=0 0 0\ncouleur=1 1 1\n\n[Sphere 1]\ncentre=0 0.3 6\nrayon=2\n", fichier());
    }

    @ParameterizedTest
    @ValueSource(strings = {"[Lampe 1]\nposition=0 0 0\ncouleur=1 1 1\n", "[Sphere 1]\ncentre=0 0 0\nrayon=-1\n",
        "[Sphere 1]\ncentre=0 0 0\nrayon=1\n[sphere  1]\ncentre=1 0 0\nrayon=1\n", "rien"})
    void unFichierQuiNEstPlusUneSceneOuPlusLaMemeNEstPasTouche(String change) throws IOException {
        SceneLue lue = lire(scene(BOULE));
        SceneLue voulue = lue.avec("Sphere 1", "rayon", "2");
        Files.write(fichier, scene(change));
        assertThrows(SceneFautive.class, () -> EcritureScene.remplacer(voulue, lue, lue.getTexte()));
        assertEquals(change, fichier());
        Files.delete(fichier);
        assertThrows(SceneFautive.class, () -> EcritureScene.remplacer(voulue, lue, lue.getTexte()));
        Files.createDirectory(fichier);
        assertThrows(SceneFautive.class, () -> EcritureScene.remplacer(voulue, lue, lue.getTexte()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r\n", ""})
    void uneCleAbsenteSAjouteASaSectionEtSEnOte(String fin) throws IOException {
        String avant = "; a\r\n[Sphere 1]\r\ncentre=0 0 6\r\n; b\r\nrayon=1" + fin;
        SceneLue lue = lire(scene(avant));
        SceneLue voulue = lue.avec("Sphere 1", "ns", "40");
        EcritureScene.remplacer(voulue, lue, lue.getTexte());
        String debut = avant.substring(0, avant.length() - fin.length());
        assertEquals(debut + (fin.isEmpty() ? "\r\n" : fin) + "ns=40" + fin, fichier());
        assertEquals(40, lire(Files.readAllBytes(fichier)).objets.get(0).getNs());
        TexteScene present = new TexteScene(Files.readAllBytes(fichier));
        EcritureScene.remplacer(lue, voulue, present);
        assertEquals(debut + (fin.isEmpty() ? "\r\n" : fin), fichier());
    }

    @Test
    void uneValeurImpossibleEstRefuseeCommeALaLecture() throws IOException {
        SceneLue lue = lire(scene(BOULE));
        String faute = assertThrows(SceneFautive.class, () -> lue.avec("Sphere 1", "rayon", "-1")).getMessage();
        Files.write(fichier, scene(BOULE.replace("rayon=1", "rayon=-1")));
        assertEquals(assertThrows(SceneFautive.class, () -> LecteurScene.lire(fichier.toString(), p -> { })).getMessage(), faute);
        assertThrows(SceneFautive.class, () -> lue.avec("Sphere 1", "Kd", "1 1 2"));
        assertThrows(SceneFautive.class, () -> lue.avec("Sphere 1", "Ks", "1 1 1").avec("Sphere 1", "Kr", "1 1 1"));
    }

    @Test
    void kSGardeLeNomQueLuiDonneLeFichier() throws IOException {
        SceneLue lue = lire(scene(BOULE + "Kr = .5 .5 .5\n"));
        SceneLue voulue = lue.avec("Sphere 1", "Kr", "1 1 1");
        EcritureScene.remplacer(voulue, lue, lue.getTexte());
        assertEquals(BOULE + "Kr = 1 1 1\n", fichier());
        assertEquals(1, voulue.objets.get(0).getKs().r);
    }
}
