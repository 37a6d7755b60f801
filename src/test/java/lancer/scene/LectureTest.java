package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Essai;
import lancer.essai.Ressources;
import lancer.fenetre.etat.Prise;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * La lecture des scènes, par le programme entier. Ajouter un cas, c'est ajouter un fichier : {@code fautives/x.ini} et, à
 * côté, {@code x.message}, la ligne attendue sur l'erreur standard ({@link Essai#message}).
 */
class LectureTest {

    @TempDir
    Path dossier;

    private static final Path FAUTIVES = Path.of(Ressources.chemin("fautives"));
    private static final Path VALIDES = Path.of(Ressources.chemin("valides"));

    static List<Path> fautives() {
        return Ressources.scenes(FAUTIVES);
    }

    static List<Path> valides() {
        return Ressources.scenes(VALIDES);
    }

    /** Ce que le programme doit dire de cette scène, rien si aucun message n'est à côté d'elle. */
    private static String attendu(Path scene) throws IOException {
        Path message = scene.resolveSibling(scene.getFileName().toString().replace(".ini", ".message"));
        return Files.exists(message) ? Essai.message(Files.readString(message), scene) : "";
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("fautives")
    void uneSceneFautiveEstRefuseeEnUneLigne(Path scene) throws IOException {
        Path png = dossier.resolve("image.png");
        Path pfm = dossier.resolve("image.pfm");
        Essai e = Essai.executer("--image", png.toString(), "--lineaire", pfm.toString(), "--statistiques", scene.toString());
        assertEquals(attendu(scene), e.sansAutresFormes("aucune"));
        assertEquals(1, e.erreur.split("\r?\n").length, e.erreur);
        assertEquals(2, e.code);
        assertEquals("", e.sortie);
        assertEquals(0, dossier.toFile().list().length, "des fichiers sont restés");
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("valides")
    void uneSceneInhabituelleMaisJusteEstDessinee(Path scene) throws IOException {
        Path pfm = dossier.resolve("image.pfm");
        Essai e = Essai.executer("--lineaire", pfm.toString(), "--taille", "20x15", scene.toString());
        assertEquals(attendu(scene), e.erreur);
        assertEquals(0, e.code);
        for (float composante : Essai.pfm(Files.readAllBytes(pfm))) {
            assertTrue(Math.abs(composante) <= Float.MAX_VALUE, "un nombre de l'image n'est pas fini");
        }
    }

    @Test
    void toutMessageAttenduASaScene() {
        for (Path dossier : List.of(FAUTIVES, VALIDES)) {
            for (Path message : Ressources.fichiers(dossier, aucun -> false)) {
                assertTrue(Files.exists(Path.of(message.toString().replace(".message", ".ini"))), message + " n'a pas de scène");
            }
        }
        assertTrue(fautives().size() > 100);
    }

    @Test
    void lesScenesEgalesSontToutesLaMeme() throws IOException {
        Scene simple = new Scene(Ressources.chemin("valides/egale-simple.ini"));
        float[] attendue = Ressources.image(simple, 40, 30, 5, 1).composantes;
        for (Path chemin : valides()) {
            if (chemin.getFileName().toString().startsWith("egale-")) {
                Scene scene = new Scene(chemin.toString());
                assertEquals("1, 1", scene.getObjets().size() + ", " + scene.getLampes().size(), chemin.toString());
                assertArrayEquals(attendue, Ressources.image(scene, 40, 30, 5, 1).composantes, chemin.toString());
            }
        }
    }

    @Test
    void lesValeursSontCellesDuFichier() {
        Scene scene = new Scene(Ressources.chemin("valides/egale-simple.ini"));
        Sphere sphere = (Sphere) scene.getObjets().get(0);
        assertEquals(new Point(0, 0.5, 6), sphere.getCentre());
        assertEquals(1, sphere.getRayon());
        assertEquals(new Couleur(0.9, 0.15, 0.1), sphere.getKd());
        assertEquals(new Couleur(0.25), sphere.getKs());
        assertEquals(40, sphere.getNs());
        Lampe lampe = scene.getLampes().get(0);
        assertEquals(new Point(-4, 6, -3), lampe.getPosition());
        assertEquals(new Couleur(0.8, 0.8, 0.75), lampe.getCouleur());
    }

    @Test
    void laLectureDitDOuVientChaqueObjetEtChaqueLampe() throws IOException {
        Path fichier = dossier.resolve("s.ini");
        Files.write(fichier, List.of("; un commentaire", "[SPHERE  \t a]", "centre=0 0 6", "rayon=1", "", "[Lampe]",
                "position=1 2 3", "couleur=1 1 1", "[Sphere é b]", "centre=0 0 6", "rayon=1"));
        SceneLue lue = LecteurScene.lire(fichier.toString(), part -> { });
        assertEquals("[SPHERE a] ligne 2", lue.getOrigine(lue.objets.get(0)));
        assertEquals("[Lampe] ligne 6", lue.getOrigine(lue.lampes.get(0)));
        // sa jumelle : seule la scène la laisse de côté
        assertEquals("[Sphere é b] ligne 9", lue.getOrigine(lue.objets.get(1)));
        assertNull(lue.getOrigine(new Sphere(new Point(0, 0, 6), 1)));
    }

    @Test
    void lesClesDUneMatiereSontCellesDuCours() {
        assertEquals(List.of("Kd", "Ks", "Kr", "ns"), LecteurSections.CLES_MATIERE);
    }

    @Test
    void unMateriauNonDitEstNoirEtMat() {
        Objet3D objet = new Scene(Ressources.chemin("valides/materiau-par-defaut.ini")).getObjets().get(0);
        assertEquals(new Couleur(), objet.getKd());
        assertEquals(new Couleur(), objet.getKs());
        assertEquals(1, objet.getNs());
    }

    @Test
    void lesSectionsGardentLOrdreDuFichier() {
        List<Objet3D> objets = new Scene(Ressources.chemin("valides/noms-voisins.ini")).getObjets();
        assertEquals(13, objets.size());
        for (int k = 0; k < objets.size(); k++) {
            assertEquals(k, ((Sphere) objets.get(k)).getCentre().x);
        }
    }

    @Test
    void unNombreTropPetitVautZero() {
        Sphere sphere = (Sphere) new Scene(Ressources.chemin("valides/nombres-minuscules.ini")).getObjets().get(0);
        assertEquals(Double.MIN_VALUE, sphere.getCentre().x);
        assertEquals(-1e-310, sphere.getCentre().y);
        assertEquals(new Couleur(0, 0, Double.MIN_VALUE), sphere.getKd());
        assertEquals(0, sphere.getNs());
    }

    @Test
    void laPremiereDesJumellesResteSeule() throws IOException {
        Path fichier = dossier.resolve("jumelles.ini");
        Files.write(fichier, List.of(
                "[Sphere a]", "centre=0 -0.0 6", "rayon=1", "Kd=1 0 0",
                "[Sphere b]", "centre=-0 0 6", "rayon=1.000", "Kd=0 1 0",
                "[Sphere c]", "centre=0 0 6", "rayon=1.0000000000000002"));
        List<Objet3D> objets = new Scene(fichier.toString()).getObjets();
        assertEquals(2, objets.size());
        assertEquals(new Couleur(1, 0, 0), objets.get(0).getKd());
        assertEquals(1.0000000000000002, ((Sphere) objets.get(1)).getRayon());
    }

    @Test
    void leNomDuFichierEstDitEnEntierEtSansCaractereDeControle() throws IOException {
        assumeTrue(File.separatorChar == '/', "Windows n'a pas de tels noms");
        Path fichier = Files.write(dossier.resolve("scene \u001b[31m\t" + "longue ".repeat(20) + ".ini"), List.of("[Cube]"));
        String message = assertThrows(SceneFautive.class, () -> new Scene(fichier.toString())).getMessage();
        assertTrue(message.contains("scene \\u001b[31m\\tlongue longue"), message);
        assertTrue(message.contains("longue .ini, ligne 1, [Cube] : type de section inconnu"), message);
        assertFalse(message.contains("\u001b"), message);
    }

    @Test
    void uneLigneSeDonneParMorceauxDeToutesLesTailles() throws IOException {
        byte[] fichier = "\uFEFF0123456789\nab\r\n\r; é\nc".getBytes(StandardCharsets.UTF_8);
        for (int taille = 1; taille < 12; taille++) {
            Lignes lignes = new Lignes(new ByteArrayInputStream(fichier), 0, part -> { });
            StringBuilder lu = new StringBuilder();
            char[] tampon = new char[taille];
            for (int n = lignes.read(tampon, 0, taille); n >= 0; n = lignes.read(tampon, 0, taille)) {
                lu.append(tampon, 0, n);
            }
            assertEquals("0123456789\nab\n\n\nc\n", lu.toString(), "par " + taille);
        }
    }

    // la caméra d'une section

    private static final String BOULE = "[Sphere devant]\ncentre=0 0 6\nrayon=1\n[Sphere derrière]\ncentre=0 0 9\nrayon=1\n";

    private Camera lire(String... section) throws IOException {
        Path scene = Essai.scene(dossier.resolve("s.ini"), String.join("\n", section), BOULE);
        return LecteurScene.lire(scene.toString(), part -> { }).getCadrage().apply(80, 60);
    }

    @Test
    void laSectionCameraPlaceLOeilLeTourneEtOuvreSonChamp() throws IOException {
        Camera camera = lire("[CAMERA de côté]", "Cible=4 1 -3", "champ=90", "OEIL=1 2 3");
        assertEquals(new Point(1, 2, 3), camera.getOeil());
        assertEquals(0, camera.getRayon(40, 30).getV().sub(new Vecteur(3, -1, -6).normalized()).norme(), 1e-15);
        assertEquals(0, camera.getRayon(0, 30).getV().dot(camera.getRayon(80, 30).getV()), 1e-15);
        Point cible = Prise.projeter(camera, new Point(4, 1, -3));
        assertEquals(40, cible.x, 1e-12);
        assertEquals(30, cible.y, 1e-12);
    }

    @Test
    void sansOeilNiCibleSeulLeChampChange() throws IOException {
        Camera camera = lire("[Camera]", "champ=90");
        assertEquals(-1, camera.getOeil().z, 1e-15);
        assertEquals(0, camera.getEcran(12, 34).z, 1e-15);
        assertEquals(camera.getX(12), camera.getEcran(12, 34).x);
        assertEquals(Camera.class, lire("; aucune section").getClass());
    }

    @Test
    void leRecitDUnPixelEstVuDeCetOeil() throws IOException {
        lire("[Camera]", "oeil=0 0 20", "cible=0 0 6");
        String scene = dossier.resolve("s.ini").toString();
        Essai recit = Essai.executer("--pixel=40,30", "--taille=80x60", scene);
        assertTrue(recit.sortie.contains("[Sphere derrière]") && !recit.sortie.contains("1  [Sphere devant]"), recit.sortie);
    }
}
