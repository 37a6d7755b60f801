package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
import lancer.atelier.FichierCsv;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** La mesure de bout en bout, et ce qu'elle en dit. */
class VitesseTest {

    @TempDir
    Path dossier;

    private final ByteArrayOutputStream sortie = new ByteArrayOutputStream();

    @ParameterizedTest(name = "« {0} »")
    @ValueSource(strings = {"--inconnue", "--dossier", "scene1", "--rapide --rapide"})
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

    @Test
    void chaqueMethodeEstMesureeVerifieeJugeeEtNotee() throws IOException {
        List<Methode> deux = Arrays.asList(Catalogue.methode(Catalogue.METHODES, "scene1", "un rayon/"),
                Catalogue.methode(Catalogue.METHODES, "scene1", "grille/2 × 2"));
        Path csv = dossier.resolve("vitesse.csv");
        new Mesureur(true, true, csv, new PrintStream(sortie)).mesurer(
                Collections.singletonList(new Catalogue.Groupe(Catalogue.METHODES, "scene1", deux, 1)));
        Releves releves = Releves.lire(csv);
        Releve un = releves.le(Catalogue.UN_RAYON, "");
        Releve grille = releves.le(Catalogue.GRILLE, "2 × 2");
        assertEquals(30000, un.nombre("primaires"));
        assertEquals(4 * 30000, grille.nombre("primaires"));
        assertEquals(30000, un.nombre("pixels_verifies"));
        assertTrue(grille.erreur().nettementSous(un.erreur()), "quatre rayons par pixel se trompent moins qu'un");
        assertTrue(un.nombre("reference_ms") > 0 && un.nombre("rapport") > 0 && un.nombre("manches") == 2);
    }

    // ---- ce qu'on en dit

    private final List<String> lignes = new ArrayList<>(Collections.singletonList(String.join(",", Releve.COLONNES)));

    private void noter(String methode, String parametres, double rapport, double erreur) {
        List<String> champs = Arrays.asList("famille", Catalogue.METHODES, "scene", "scene1", "methode", methode, "parametres", parametres,
                "rapport", "" + rapport, "rapport_min", "" + rapport / 1.05, "rapport_max", "" + rapport * 1.05, "erreur", "" + erreur,
                "erreur_min", "" + erreur * 0.95, "erreur_max", "" + erreur * 1.05, "reference_ms", "40");
        lignes.add(FichierCsv.ligne(Releve.COLONNES.stream()
                .map(c -> champs.indexOf(c) < 0 ? "" : champs.get(champs.indexOf(c) + 1)).toArray()));
    }

    private Releves notes() throws IOException {
        return Releves.lire(Files.write(dossier.resolve("faux.csv"), lignes, StandardCharsets.UTF_8));
    }

    private String titre() throws IOException {
        return new Constats(notes(), Collections.emptyList()).titre("scene1");
    }

    @Test
    void unReglageNEnBatUnAutreQueSiLesDeuxIntervallesLePortent() throws IOException {
        noter(Catalogue.COINS, Catalogue.COINS_DEFAUT, 4, 1.5);
        noter(Catalogue.PARTAGE, "n=4 seuil=0.1", 2, 1.45);
        assertTrue(titre().contains("aucune différence"), titre());
        noter(Catalogue.PARTAGE, "n=4 seuil=0.06", 2, 1.2);
        assertEquals("Scène du cours : « partage » (4 ; 0,06) bat « coins » (3 ; 0,05), de 1,65 à 2,43 fois moins de temps", titre());
    }

    @Test
    void leMoinsCherPourUneErreurPeutEtreUnChoixDAutoMaisPasPovRay() throws IOException {
        noter(Catalogue.PARTAGE, "n=4 seuil=0.1", 6, 1.5);
        noter(Catalogue.AUTO, "erreur=2", 4, 1.6);
        noter(Catalogue.POVRAY, "-A", 2, 0.1);
        String[] paliers = new Constats(notes(), Collections.emptyList()).paliers("scene1").split(" \\| ");
        assertEquals("le choix de --auto erreur=2 : × 4 (de 3,63 à 4,41)", paliers[1]);
        assertEquals("rien", paliers[2]);
    }

    @Test
    void leTempsDUneFouleEstCompareACeluiDUnePlusPetite() throws IOException {
        for (int n : new int[] {1, 100}) {
            noter(Catalogue.PROGRAMME, "", n == 1 ? 1 : 3, 0);
            lignes.add(lignes.remove(lignes.size() - 1).replace("methodes,scene1,,", "spheres,foule-" + n + "," + n + ","));
        }
        assertEquals("De 1 à 100 sphères, tout compris, le programme prend de 2,47 à 3,65 fois plus de temps",
                new Constats(notes(), Collections.emptyList()).titreDesSpheres());
    }

    @Test
    void ceDontDeuxMachinesVirtuellesDifferentNEstPasUneDifference() throws IOException {
        noter(Catalogue.COINS, Catalogue.COINS_DEFAUT, 4, 1.5);
        noter(Catalogue.PARTAGE, "n=4 seuil=0.06", 3, 1.2);
        assertFalse(titre().contains("aucune différence"), titre());
        noter(Catalogue.UN_RAYON, "", 1.04, 6);
        assertFalse(titre().contains("aucune différence"), "la même chose, ailleurs, va peut-être aussi vite");
        // et là, elle va au moins un sixième plus lentement : trois quarts ne se distinguent plus de un
        noter(Catalogue.UN_RAYON, "", 1.25, 6);
        assertTrue(titre().contains("aucune différence"), titre());
    }

    @Test
    void lesPromessesDAutoSontComptees() {
        String[] colonnes = {"scene", "promise", "tenue", "erreur", "erreur_voulue", "rayons_attendus", "rayons", "rayons_des_essais"};
        List<Map<String, String>> lues = new ArrayList<>();
        for (String ligne : new String[] {"diffus oui oui 1 2 10 10 1", "sort-1 oui non 3 2 9 10 30", "sort-2 non non 9 2 5 10 19"}) {
            lues.add(IntStream.range(0, colonnes.length).boxed().collect(Collectors.toMap(k -> colonnes[k], k -> ligne.split(" ")[k])));
        }
        assertEquals("{auto.livrees=1 fois sur 1, auto.pire=1,5, auto.plus_cher=1,64, auto.prix=1 fois sur 2, "
                + "auto.sort=0 fois sur 2}", Rapport.promesses(lues).toString());
    }

    @Test
    void plusieursMachinesVirtuellesNePrennentPasLaMargeDUneSeule() throws IOException {
        noter(Catalogue.UN_RAYON, "", 1.25, 6);
        noter(Catalogue.COINS, "d'une machine", 2, 1);
        noter(Catalogue.COINS, "de cinq", 2, 1);
        int colonne = Releve.COLONNES.indexOf("lancements");
        List<String> champs = new ArrayList<>(Arrays.asList(lignes.get(3).split(",", -1)));
        champs.set(colonne, "5");
        lignes.set(3, String.join(",", champs));
        // la référence, ailleurs, prend au moins 1,25 / 1,05 fois plus de temps
        assertEquals(2 * 1.05 * (1.25 / 1.05), notes().le(Catalogue.COINS, "d'une machine").rapport().max, 1e-9);
        assertEquals(2 * 1.05, notes().le(Catalogue.COINS, "de cinq").rapport().max, 1e-9);
    }

    @Test
    void leFrontEstCeQueRienNeBatEnTempsEtEnErreur() throws IOException {
        noter(Catalogue.BROUILLON, "4 × 4", 0.1, 20);
        noter(Catalogue.UN_RAYON, "", 1, 6);
        noter(Catalogue.GRILLE, "2 × 2", 4, 1.5);
        noter(Catalogue.PARTAGE, "n=4 seuil=0.1", 3, 1.5);
        noter(Catalogue.PROFONDEUR, "p=0", 0.5, 40);
        assertEquals(Arrays.asList(Catalogue.BROUILLON, Catalogue.UN_RAYON, Catalogue.PARTAGE),
                notes().front().stream().map(r -> r.methode).collect(Collectors.toList()));
    }

    @Test
    void chaqueMethodeDuCatalogueASonNomEtChaqueGroupeSaReference() {
        for (boolean court : new boolean[] {true, false}) {
            for (Catalogue.Groupe groupe : new Catalogue(court).groupes()) {
                assertEquals(groupe.methodes.size(), groupe.methodes.stream().map(Methode::cle).distinct().count(), groupe.scene);
                assertTrue(groupe.enProcessus() || groupe.methodes.get(0).cle().endsWith("/"), groupe.scene);
            }
        }
    }
}
