package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lancer.mesures.FichierCsv;
import lancer.mesures.Lancement;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.stabilite.Bilan;
import lancer.mesures.stabilite.Formule;
import lancer.mesures.stabilite.Noyau;
import lancer.mesures.stabilite.Regime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** La mesure de bout en bout, et ce qu'elle en dit. */
class VitesseTest {

    private static final Path RESULTATS = Paths.get(Files.exists(Paths.get("mesures")) ? "mesures/resultats" : "resultats");

    @TempDir
    Path dossier;

    private final ByteArrayOutputStream sortie = new ByteArrayOutputStream();

    @ParameterizedTest(name = "« {0} »")
    @ValueSource(strings = {"--inconnue", "scene1", "--rapide --rapide"})
    void uneDemandeFausseTientEnUneLigneEtLeStatut2(String args) {
        ByteArrayOutputStream erreurs = new ByteArrayOutputStream();
        assertEquals(2, Vitesse.executer(args.split(" "), new PrintStream(sortie), new PrintStream(erreurs)));
        assertEquals("", sortie.toString());
        assertTrue(erreurs.toString().startsWith("Vitesse : ") && erreurs.toString().trim().split("\n").length == 1, erreurs.toString());
    }

    @Test
    void ailleursQuALaRacineDuProjetRienNEstEcrit() {
        ByteArrayOutputStream erreurs = new ByteArrayOutputStream();
        assertEquals(2, Vitesse.executer(new String[] {"--dessiner"}, new PrintStream(sortie), new PrintStream(erreurs)));
        assertTrue(erreurs.toString().contains("à lancer à la racine du projet"), erreurs.toString());
        assertFalse(Files.exists(Paths.get("mesures")), "le dossier du module n'en a pas d'autre de ce nom");
    }

    private static final Taille TAILLE = new Taille(200, 150);

    private static List<Catalogue.Groupe> deux() {
        return Collections.singletonList(new Catalogue.Groupe(Catalogue.METHODES, Catalogue.COURS,
                Catalogue.methode(Catalogue.METHODES, Catalogue.COURS, "un rayon/"),
                Catalogue.methode(Catalogue.METHODES, Catalogue.COURS, "grille/2 × 2")));
    }

    /** Les variantes sont sur ce chemin des classes, non dans un jar. */
    private static String[] lancer(Methode methode) {
        String sans = Stream.of("Brume", "Antialias", "Blinn").filter(v -> !v.equalsIgnoreCase(methode.module))
                .collect(Collectors.joining(","));
        return new String[] {"-cp", System.getProperty("java.class.path"), "lancer.Main", "--sans=" + sans};
    }

    private Mesureur mesureur() throws IOException {
        return new Mesureur(true, null, dossier.resolve(Vitesse.CSV), new PrintStream(sortie), VitesseTest::lancer);
    }

    @Test
    void chaqueReglageEstUnProgrammeEntierChronometreVerifieEtJuge() throws IOException {
        mesureur().mesurer(TAILLE, deux());
        new Comptes(TAILLE, null, dossier, new PrintStream(sortie)).ecrire(deux());
        Releves releves = Releves.lire(dossier);
        Releve un = releves.le(Catalogue.UN_RAYON, "");
        Releve grille = releves.le(Catalogue.GRILLE, "2 × 2");
        assertEquals(30000, un.nombre("primaires"));
        assertEquals(4 * 30000, grille.nombre("primaires"));
        assertEquals(30000, un.nombre("pixels_verifies"));
        assertTrue(grille.erreur().nettementSous(un.erreur()), "quatre rayons par pixel se trompent moins qu'un");
        assertTrue(grille.nombre("visibles") < un.nombre("visibles") && un.nombre("visibles") < 1);
        assertTrue(un.nombre("reference_ms") > 0 && un.nombre("rapport") > 0 && un.nombre("manches") == 2);
        assertTrue(un.nombre("memoire_mo") > 0 == Files.isExecutable(Paths.get("/usr/bin/time")), "GNU time dit la mémoire");
    }

    @Test
    void toutReglageEcritDansUneCommandeOuUneSceneDonneLImageQuiEnEstJugee() throws IOException {
        List<Methode> methodes = new ArrayList<>();
        Catalogue.groupes(false).stream().filter(g -> g.scene.equals(Catalogue.COURS) || g.scene.equals("miroirs"))
                .flatMap(g -> g.methodes.stream()).filter(m -> !m.povray && methodes.stream().noneMatch(a -> a.nom.equals(m.nom)))
                .forEach(methodes::add);
        mesureur().mesurer(new Taille(40, 30), Collections.singletonList(new Catalogue.Groupe(Catalogue.METHODES, "miroirs",
                methodes.toArray(new Methode[0]))));
        assertEquals(methodes.size(), Releves.lignes(dossier.resolve(Vitesse.CSV)).size(), "un pixel d'un autre arrêterait la mesure");
        assertTrue(methodes.stream().map(m -> m.module).collect(Collectors.toSet())
                .containsAll(Arrays.asList("lancer", "antialias", "brume", "blinn")), "chaque programme est essayé");
    }

    /** Des programmes entiers, qui dessinent dix boules en tout petit. */
    private Releves enProcessus(Methode methode) throws IOException {
        mesureur().mesurer(new Taille(40, 30), Collections.singletonList(new Catalogue.Groupe(Catalogue.SPHERES, Scenes.FOULE + "-10",
                methode)));
        return new Releves(Releves.lignes(dossier.resolve(Vitesse.CSV)));
    }

    @Test
    void unProgrammeEntierAUnTempsEtUneMemoire() throws IOException {
        Releve boucles = enProcessus(new Methode(Catalogue.BOUCLES, "").enBoucles()).le(Catalogue.BOUCLES, "");
        assertEquals(10, boucles.nombre("spheres"));
        assertEquals(1200, boucles.nombre("pixels_verifies"));
        assertTrue(boucles.nombre("rapport") > 0);
        assertTrue(boucles.nombre("memoire_mo") > 0 == Files.isExecutable(Paths.get("/usr/bin/time")), "GNU time dit la mémoire");
    }

    @Test
    void leProgrammeEntierDitSesComptesUneFoisSesTempsPris() throws IOException {
        Releve programme = enProcessus(new Methode(Catalogue.PROGRAMME, "")).le(Catalogue.PROGRAMME, "");
        assertEquals(1200, programme.nombre("primaires"));
        assertTrue(programme.nombre("ombre") > 0 && programme.nombre("tests") > 0 && programme.nombre("rapport") > 0);
    }

    @Test
    void unProgrammeEntierDontLImageEstFausseNAPasDeTemps() {
        Methode boucles = new Methode(Catalogue.BOUCLES, "").enBoucles();
        boucles.options = new String[] {"--reflets", "0"};
        String message = assertThrows(IllegalStateException.class, () -> enProcessus(boucles)).getMessage();
        assertTrue(message.contains("image fausse : foule-10, 40x30, boucles du cours"), message);
        Methode programme = new Methode(Catalogue.PROGRAMME, "");
        programme.options = new String[] {"--reflets", "0"};
        String autre = assertThrows(IllegalStateException.class, () -> enProcessus(programme)).getMessage();
        assertTrue(autre.contains("image fausse : programme/, pixel ("), autre);
    }

    @Test
    void ceQuePrendUnProgrammeEstCeQuIlPrendVraiment() throws IOException {
        Lancement dort = new Lancement(dossier.resolve("pris"), "sh", "-c", "echo oui ; sleep 0.2").reussi();
        assertEquals("oui", dort.dit);
        assertTrue(dort.pris[Manches.REEL] >= 0.2e9 && dort.pris[Manches.PROCESSEURS] < 0.2e9, Arrays.toString(dort.pris));
        String panne = assertThrows(IOException.class,
                () -> new Lancement(dossier.resolve("pris"), "sh", "-c", "echo panne >&2 ; exit 3").reussi()).getMessage();
        assertTrue(panne.endsWith("statut 3 : panne"), panne);
    }

    @Test
    void sansAucunTempsLesErreursEtLesRayonsSeDisentEncore() throws IOException {
        new Comptes(TAILLE, null, dossier, new PrintStream(sortie)).ecrire(deux());
        Map<String, String> pages = new Tableaux(Releves.lire(dossier), Collections.emptyList()).pages();
        assertTrue(pages.get("comptes").contains("| `scene1` | grille 2 × 2 | × 3,8 | "), pages.get("comptes"));
        assertTrue(pages.get("choisir").contains("<td>un niveau au plus</td><td colspan=\"3\">rien de ce qui est mesuré</td>"),
                pages.get("choisir"));
        assertEquals("", pages.get("machine"));
    }

    // ---- ce qu'on en dit

    private final List<String> temps = new ArrayList<>(Collections.singletonList(String.join(",", Releve.COLONNES)));
    private final List<String> erreurs = new ArrayList<>(Collections.singletonList(String.join(",", Comptes.COLONNES)));

    private static String ligne(List<String> colonnes, Object... champs) {
        Map<String, Object> parNom = IntStream.range(0, champs.length / 2).boxed()
                .collect(Collectors.toMap(k -> (String) champs[2 * k], k -> champs[2 * k + 1]));
        return FichierCsv.ligne(colonnes.stream().map(c -> parNom.getOrDefault(c, "")).toArray());
    }

    private void noter(String methode, String parametres, double rapport, double erreur) {
        noter(Catalogue.COURS, methode, parametres, rapport, erreur);
    }

    private void noter(String scene, String methode, String parametres, double rapport, double erreur) {
        temps.add(ligne(Releve.COLONNES, "famille", Catalogue.METHODES, "scene", scene, "methode", methode, "parametres", parametres,
                "reference_ms", 400, "rapport", rapport, "rapport_min", rapport / 1.05, "rapport_max", rapport * 1.05, "commit", "abc",
                "date", "2026-11-25T12:00:00"));
        erreurs.add(ligne(Comptes.COLONNES, "famille", Catalogue.METHODES, "scene", scene, "methode", methode, "parametres", parametres,
                "rayons", 10 * rapport, "erreur", erreur, "erreur_min", erreur * 0.95, "erreur_max", erreur * 1.05, "visibles", 0.01,
                "commit", "abc", "date", "2026-11-24T12:00:00"));
    }

    private Releves notes() throws IOException {
        Files.write(dossier.resolve(Vitesse.CSV), temps, StandardCharsets.UTF_8);
        Files.write(dossier.resolve(Comptes.CSV), erreurs, StandardCharsets.UTF_8);
        return Releves.lire(dossier);
    }

    @Test
    void unReglageNEnBatUnAutreQueSiLesDeuxIntervallesLePortent() throws IOException {
        noter(Catalogue.UN_RAYON, "", 1, 6);
        noter(Catalogue.SANS_SECTION, "", 4, 1.5);
        noter(Catalogue.PARTAGE, "n=4 seuil=0.1", 2, 1.45);
        assertFalse(notes().vainqueur(notes().le(Catalogue.SANS_SECTION, "")).isPresent());
        noter(Catalogue.PARTAGE, "n=4 seuil=0.06", 2, 1.2);
        assertEquals("n=4 seuil=0.06", notes().vainqueur(notes().le(Catalogue.SANS_SECTION, "")).get().parametres);
    }

    @Test
    void laTableQuiDecideDonneLePlusRapideDontLErreurTientSurChaqueScene() throws IOException {
        noter(Catalogue.UN_RAYON, "", 1.1, 3);
        noter(Catalogue.PARTAGE, "n=16 seuil=0.03", 2.5, 0.2);
        noter(Catalogue.PARTAGE, "n=8 seuil=0.06", 2, 0.6);
        noter(Catalogue.PARTAGE, "n=4 seuil=0.2", 1.5, 0.9);
        noter(Catalogue.GRILLE, "2 × 2", 1.2, 0.5);
        noter(Catalogue.POVRAY, "grille adaptative", 1.1, 0.1);
        noter(Catalogue.AUTO, "erreur=1", 1.8, 0.7);
        noter("miroirs", Catalogue.UN_RAYON, "", 1, 12);
        noter("miroirs", Catalogue.PARTAGE, "n=16 seuil=0.03", 2.5, 0.27);
        noter("miroirs", Catalogue.PARTAGE, "n=8 seuil=0.06", 2, 0.94);
        noter("miroirs", Catalogue.PARTAGE, "n=4 seuil=0.2", 1.5, 1.2);
        noter("miroirs", Catalogue.AUTO, "erreur=1", 1.8, 0.9);
        String table = new Tableaux(notes(), Collections.emptyList()).pages().get("choisir");
        assertTrue(table.contains("<td>aller vite</td><td>3 niveaux</td><td>12 niveaux (miroirs)</td><td>0,4 s, l'unité</td>"), table);
        assertTrue(table.contains("<td>deux niveaux au plus</td><td>0,9 niveau</td><td>1,2 niveau (miroirs)</td>"
                + "<td>0,6 s, × 1,5 (de 1,43 à 1,58)</td>"), table);
        // l'erreur de la grille n'est connue que d'une scène ; POV-Ray n'est là que pour comparer
        assertTrue(table.contains("<td>un niveau au plus</td><td>0,6 niveau</td><td>0,94 niveau (miroirs)</td>"), table);
        assertTrue(table.contains("\n    [Antialias]\n    methode=partage\n    n=16\n    seuil=0.03\n\n"), table);
        assertTrue(table.contains("\n    java -jar antialias/target/antialias.jar --reflets 1000 --seuil 0.0078125 --image boules.png "
                + "scenes/scene1.ini\n"), table);
        assertTrue(table.contains("<td>moins que l'arrondi de l'écran</td><td>0,2 niveau</td>"), table);
        assertTrue(table.contains("<td>ne pas choisir</td><td>0,7 niveau</td><td>0,9 niveau (miroirs)</td>"), table);
        assertTrue(table.endsWith("\nMesures du commit abc, le 2026-11-25.\n"), table);
        assertEquals("× 1,1 (de 1,05 à 1,16) sur `scene1`, × 1 (de 0,952 à 1,05) sur `miroirs`",
                new Tableaux(notes(), Collections.emptyList()).pages().get("lui-meme"));
    }

    @Test
    void laCourbeDUneSceneEtSesVoisinesOntLesMemesAxes() throws IOException {
        noter(Catalogue.UN_RAYON, "", 1, 3);
        noter(Catalogue.SANS_SECTION, "", 2, 0.75);
        Planches planches = new Planches(notes());
        planches.scenes(Arrays.asList("scene1", "scene1")).ecrire(dossier.resolve("scenes.png"));
        assertEquals(Collections.singletonList("scene1"), planches.scenes());
        assertTrue(Files.size(dossier.resolve("scenes.png")) > 0);
    }

    @Test
    void lesTempsDesIntersectionsSeDisentAuManuelSiLIntervalleLePorte() throws IOException {
        for (Regime regime : Regime.values()) {
            for (Formule f : Formule.values()) {
                temps.add(ligne(Releve.COLONNES, "famille", Catalogue.INTERSECTIONS, "scene", regime.name(), "methode", f.name(),
                        "reference_ms", Noyau.DISTANCES / 1e6 * 5, "rapport", 1 + 0.1 * f.ordinal(),
                        "rapport_min", 0.85 + 0.1 * f.ordinal(), "rapport_max", 1.15 + 0.1 * f.ordinal()));
            }
        }
        Files.write(dossier.resolve(Methodes.CSV), temps, StandardCharsets.UTF_8);
        Methodes methodes = new Methodes(new Releves(Releves.lignes(dossier.resolve(Methodes.CSV))), new Bilan(RESULTATS));
        String[] lignes = methodes.tableau().trim().split("\n");
        assertEquals("| temps, divisé par celui du manuel | D'ordinaire | De loin | Au ras | Au-dessus d'un sol |", lignes[0]);
        assertTrue(lignes[2].startsWith("| perpendiculaire : \\|f − bV\\|² | autant, à l'intervalle près (de 0,95 à 1,25) |"), lignes[2]);
        assertTrue(lignes[4].startsWith("| le programme | × 1,3 (de 1,15 à 1,45) |"), lignes[4]);
        methodes.planche().ecrire(dossier.resolve("methodes.png"));
        assertTrue(Files.exists(dossier.resolve("methodes.png")));
    }

    @Test
    void uneIntersectionSeChronometreCommeUnDessin() throws IOException {
        Catalogue.Groupe sol = new Catalogue.Groupe(Catalogue.INTERSECTIONS, Regime.SOL.name(),
                new Methode(Formule.MANUEL.name(), ""), new Methode(Formule.PROGRAMME.name(), ""));
        new Mesureur(true, null, dossier.resolve(Methodes.CSV), new PrintStream(sortie), VitesseTest::lancer).mesurer(TAILLE,
                Collections.singletonList(sol));
        Releves releves = new Releves(Releves.lignes(dossier.resolve(Methodes.CSV)));
        assertTrue(releves.le("PROGRAMME", "").nombre("rapport") > 0 && releves.le("MANUEL", "").nombre("reference_ms") > 0);
    }

    @Test
    void lesOptionsMesureesSontCellesQueMakeDonne() throws IOException {
        Path commun = Paths.get(Files.exists(Paths.get("mesures")) ? "commun.mk" : "../commun.mk");
        String lignes = new String(Files.readAllBytes(commun), StandardCharsets.UTF_8);
        assertTrue(lignes.contains(" " + String.join(" ", Catalogue.OPTIONS_DE_MAKE) + ","), lignes);
    }

    @Test
    void chaqueMethodeDuCatalogueASonNomEtChaqueGroupeSaReference() {
        for (boolean court : new boolean[] {true, false}) {
            for (Catalogue.Groupe groupe : Catalogue.groupes(court)) {
                assertEquals(groupe.methodes.size(), groupe.methodes.stream().map(Methode::cle).distinct().count(), groupe.scene);
                assertTrue(!groupe.famille.equals(Catalogue.METHODES) || groupe.methodes.get(0).cle().endsWith("/"), groupe.scene);
            }
        }
    }
}
