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
    @ValueSource(strings = {"--inconnue", "scene1", "--rapide --rapide", "--jar=absent.jar"})
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
        return Collections.singletonList(new Catalogue.Groupe(Catalogue.METHODES, "scene1",
                Arrays.asList(Catalogue.methode(Catalogue.METHODES, "scene1", "un rayon/"),
                        Catalogue.methode(Catalogue.METHODES, "scene1", "grille/2 × 2")), 1));
    }

    @Test
    void chaqueMethodeEstChronometreeVerifieeJugeeEtNotee() throws IOException {
        new Mesureur(true, true, null, dossier.resolve(Vitesse.CSV), new PrintStream(sortie)).mesurer(TAILLE, deux());
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
        assertTrue(Files.exists(dossier.resolve("scene1" + Comptes.DECOUPES)));
    }

    /** Des programmes entiers, qui dessinent la scène « tp » en tout petit. */
    private Releves enProcessus(Methode methode) throws IOException {
        Path csv = dossier.resolve(Vitesse.CSV);
        // les variantes sont sur ce chemin des classes, non dans le jar que l'on mesure
        new Mesureur(true, true, null, csv, new PrintStream(sortie), "-cp", System.getProperty("java.class.path"), "lancer.Main",
                "--sans=Brume,Antialias,Blinn").mesurer(new Taille(40, 30), Collections.singletonList(new Catalogue.Groupe(
                        Catalogue.SPHERES, Scenes.TP, new ArrayList<>(Collections.singletonList(methode)), 1)));
        return new Releves(Releves.lignes(csv));
    }

    @Test
    void unProgrammeEntierAUnTempsUnTempsDeProcesseurEtUneMemoire() throws IOException {
        Releve boucles = enProcessus(new Methode(Catalogue.BOUCLES, "").enBoucles()).le(Catalogue.BOUCLES, "");
        assertEquals(10, boucles.nombre("spheres"));
        assertEquals(1200, boucles.nombre("pixels_verifies"));
        assertTrue(boucles.nombre("rapport") > 0 && boucles.nombre("processeur_rapport") > 0 && boucles.nombre("processeur_ms") > 0);
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
        Methode autre = new Methode(Catalogue.AUTRE, "");
        autre.options = new String[] {"--reflets", "0"};
        String message = assertThrows(IllegalStateException.class, () -> enProcessus(autre)).getMessage();
        assertTrue(message.contains("image fausse : tp, 40x30, autre programme"), message);
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
        Constats constats = new Constats(Releves.lire(dossier), Collections.emptyList());
        assertEquals("aucun temps n'a été pris", constats.circonstances());
        assertTrue(constats.titre("scene1").contains(" pour 4 fois le prix d'un rayon : la grille 2 × 2"), constats.titre("scene1"));
    }

    // ---- ce qu'on en dit

    private final List<String> temps = new ArrayList<>(Collections.singletonList(String.join(",", Releve.COLONNES)));
    private final List<String> erreurs = new ArrayList<>(Collections.singletonList(String.join(",", Comptes.COLONNES)));

    private static String ligne(List<String> colonnes, Object... champs) {
        Map<String, Object> parNom = IntStream.range(0, champs.length / 2).boxed()
                .collect(Collectors.toMap(k -> (String) champs[2 * k], k -> champs[2 * k + 1]));
        return FichierCsv.ligne(colonnes.stream().map(c -> parNom.getOrDefault(c, "")).toArray());
    }

    private void noterUnTemps(String methode, String parametres, double rapport, int lancements) {
        temps.add(ligne(Releve.COLONNES, "famille", Catalogue.METHODES, "scene", "scene1", "methode", methode, "parametres", parametres,
                "lancements", lancements, "rapport", rapport, "rapport_min", rapport / 1.05, "rapport_max", rapport * 1.05));
    }

    private void noter(String methode, String parametres, double rayons, double erreur) {
        erreurs.add(ligne(Comptes.COLONNES, "famille", Catalogue.METHODES, "scene", "scene1", "methode", methode, "parametres", parametres,
                "rayons", rayons, "erreur", erreur, "erreur_min", erreur * 0.95, "erreur_max", erreur * 1.05, "visibles", 0.01));
    }

    private Releves notes() throws IOException {
        Files.write(dossier.resolve(Vitesse.CSV), temps, StandardCharsets.UTF_8);
        Files.write(dossier.resolve(Comptes.CSV), erreurs, StandardCharsets.UTF_8);
        return Releves.lire(dossier);
    }

    private Constats constats() throws IOException {
        return new Constats(notes(), Collections.emptyList());
    }

    @Test
    void unReglageNEnBatUnAutreQueSiLesDeuxIntervallesLePortent() throws IOException {
        noter(Catalogue.UN_RAYON, "", 1, 6);
        noter(Catalogue.COINS, Catalogue.COINS_DEFAUT, 4, 1.5);
        noter(Catalogue.PARTAGE, "n=4 seuil=0.1", 2, 1.45);
        assertFalse(notes().vainqueur(notes().le(Catalogue.COINS, Catalogue.COINS_DEFAUT)).isPresent());
        noter(Catalogue.PARTAGE, "n=4 seuil=0.06", 2, 1.2);
        assertEquals("n=4 seuil=0.06", notes().vainqueur(notes().le(Catalogue.COINS, Catalogue.COINS_DEFAUT)).get().parametres);
    }

    @Test
    void leTitreDitLeMoinsCherSousLArrondiDeLEcran() throws IOException {
        noter(Catalogue.UN_RAYON, "", 10, 3);
        noter(Catalogue.PARTAGE, "n=4 seuil=0.1", 20, 0.5);
        assertEquals("Scène du cours : 0,5 niveau pour 2 fois le prix d'un rayon : partage, 4 rayons là où c'est utile (seuil 0,1)",
                constats().titre("scene1"));
        noter(Catalogue.PARTAGE, "n=16 seuil=0.06", 60, 0.2);
        noter(Catalogue.PARTAGE, "n=8 seuil=0.06", 50, 0.27);
        noter(Catalogue.POVRAY, "", 30, 0.1);
        assertEquals("Scène du cours : sous l'arrondi de l'écran pour 5 fois le prix d'un rayon : partage, 8 rayons là où c'est utile "
                + "(seuil 0,06)", constats().titre("scene1"));
    }

    @Test
    void leMoinsCherPourUneErreurNEstJamaisPovRay() throws IOException {
        noter(Catalogue.UN_RAYON, "", 2, 5);
        noter(Catalogue.PARTAGE, "n=4 seuil=0.1", 6, 1.5);
        noter(Catalogue.PROFONDEUR, "p=2", 4, 1.6);
        noter(Catalogue.POVRAY, "", 2, 0.1);
        String[] paliers = constats().paliers("scene1").split(" \\| ");
        assertEquals("un rayon à 2 reflets : × 2", paliers[1]);
        assertEquals("rien", paliers[2]);
    }

    @Test
    void lesFoulesDisentDOuLeProgrammeVaPlusViteQueLesBoucles() throws IOException {
        for (int n : new int[] {10, 100, 1000}) {
            temps.add(ligne(Releve.COLONNES, "famille", Catalogue.SPHERES, "scene", "foule-" + n, "spheres", n, "methode",
                    Catalogue.BOUCLES, "lancements", 9, "rapport", n / 50.0, "rapport_min", n / 55.0, "rapport_max", n / 45.0));
        }
        assertEquals("Dès 100 sphères, le programme va plus vite que les boucles du cours : à 1 000, de 18 à 22 fois",
                constats().titreDesSpheres());
    }

    @Test
    void laPenteEstCelleDeLaDroiteQuiPasseAuPlusPres() throws IOException {
        noter(Catalogue.UN_RAYON, "", 1, 8);
        noter(Catalogue.GRILLE, "2 × 2", 4, 2);
        noter(Catalogue.GRILLE, "4 × 4", 16, 0.5);
        assertEquals(-1, constats().pente("scene1", Catalogue.GRILLE), 1e-9);
    }

    @Test
    void plusieursMachinesVirtuellesNePrennentPasLaMargeDUneSeule() throws IOException {
        noterUnTemps(Catalogue.UN_RAYON, "", 1.25, 1);
        noterUnTemps(Catalogue.COINS, "d'une machine", 2, 1);
        noterUnTemps(Catalogue.COINS, "de cinq", 2, 5);
        noter(Catalogue.COINS, "d'une machine", 1, 1);
        noter(Catalogue.COINS, "de cinq", 1, 1);
        // la référence, ailleurs, prend au moins 1,25 / 1,05 fois plus de temps
        assertEquals(2 * 1.05 * (1.25 / 1.05), notes().le(Catalogue.COINS, "d'une machine").rapport().max, 1e-9);
        assertEquals(2 * 1.05, notes().le(Catalogue.COINS, "de cinq").rapport().max, 1e-9);
    }

    @Test
    void leFrontEstCeQuiSeTrompeMoinsACoupSurQueToutCeQuiEstMoinsCher() throws IOException {
        noter(Catalogue.UN_RAYON, "", 1, 6);
        noter(Catalogue.GRILLE, "2 × 2", 4, 1.5);
        noter(Catalogue.PARTAGE, "n=4 seuil=0.1", 3, 1.5);
        noter(Catalogue.POVRAY, "", 1, 6 - 1e-4);
        noter(Catalogue.PROFONDEUR, "p=1000", 1.01, 6 - 1e-4);
        noter(Catalogue.PROFONDEUR, "p=0", 0.5, 40);
        assertEquals(Arrays.asList(Catalogue.PROFONDEUR, Catalogue.UN_RAYON, Catalogue.PARTAGE),
                notes().front().stream().map(r -> r.methode).collect(Collectors.toList()));
    }

    @Test
    void lesTempsDesIntersectionsSeDisentAuManuelSiLIntervalleLePorte() throws IOException {
        for (Regime regime : Regime.values()) {
            for (Formule f : Formule.values()) {
                temps.add(ligne(Releve.COLONNES, "famille", Catalogue.INTERSECTIONS, "scene", regime.name(), "methode", f.name(),
                        "lancements", 5, "reference_ms", Noyau.DISTANCES / 1e6 * 5, "rapport", 1 + 0.1 * f.ordinal(),
                        "rapport_min", 0.85 + 0.1 * f.ordinal(), "rapport_max", 1.15 + 0.1 * f.ordinal()));
            }
        }
        Files.write(dossier.resolve(Methodes.CSV), temps, StandardCharsets.UTF_8);
        Methodes methodes = new Methodes(new Releves(Releves.lignes(dossier.resolve(Methodes.CSV))), new Bilan(RESULTATS));
        Map<String, String> pages = methodes.pages();
        assertEquals("autant, à l'intervalle près", pages.get("methodes.perpendiculaire.loin"));
        assertEquals("× 1,3", pages.get("methodes.programme.loin"));
        methodes.planche().ecrire(dossier.resolve("methodes.png"));
        assertTrue(Files.exists(dossier.resolve("methodes.png")));
    }

    @Test
    void uneIntersectionSeChronometreCommeUnDessin() throws IOException {
        Catalogue.Groupe sol = new Catalogue.Groupe(Catalogue.INTERSECTIONS, Regime.SOL.name(),
                Arrays.asList(new Methode(Formule.MANUEL.name(), ""), new Methode(Formule.PROGRAMME.name(), "")), 1);
        new Mesureur(true, true, null, dossier.resolve(Methodes.CSV), new PrintStream(sortie)).mesurer(TAILLE,
                Collections.singletonList(sol));
        Releves releves = new Releves(Releves.lignes(dossier.resolve(Methodes.CSV)));
        assertTrue(releves.le("PROGRAMME", "").nombre("rapport") > 0 && releves.le("MANUEL", "").nombre("reference_ms") > 0);
    }

    @Test
    void chaqueMethodeDuCatalogueASonNomEtChaqueGroupeSaReference() {
        for (boolean court : new boolean[] {true, false}) {
            for (Catalogue.Groupe groupe : new Catalogue(court).groupes()) {
                assertEquals(groupe.methodes.size(), groupe.methodes.stream().map(Methode::cle).distinct().count(), groupe.scene);
                assertTrue(groupe.famille.equals(Catalogue.SPHERES) || groupe.methodes.get(0).cle().endsWith("/"), groupe.scene);
            }
        }
    }
}
