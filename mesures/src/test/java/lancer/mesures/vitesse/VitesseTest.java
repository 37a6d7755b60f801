package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.mesures.Intervalle;
import lancer.mesures.Lancement;
import lancer.mesures.scenes.Scenes;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** La mesure de bout en bout, et ce qu'elle en dit. */
class VitesseTest {

    private static final Taille PETITE = new Taille(40, 30);

    @TempDir
    Path dossier;

    private final ByteArrayOutputStream sortie = new ByteArrayOutputStream();
    private final Resultats resultats = new Resultats(new ArrayList<>());

    @ParameterizedTest(name = "« {0} »")
    @ValueSource(strings = {"--inconnue", "scene1", "--temps --temps"})
    void uneDemandeFausseTientEnUneLigneEtLeStatut2(String args) {
        ByteArrayOutputStream erreurs = new ByteArrayOutputStream();
        assertEquals(2, Vitesse.executer(args.split(" "), new PrintStream(sortie), new PrintStream(erreurs)));
        assertEquals("", sortie.toString());
        assertTrue(erreurs.toString().startsWith("Vitesse : ") && erreurs.toString().trim().split("\n").length == 1, erreurs.toString());
    }

    // ---- des commandes entières, en petit

    /** Les variantes sont sur ce chemin des classes, non dans un jar. */
    static List<String> programme(Reglage reglage) {
        String sans = Stream.of("Brume", "Antialias", "Blinn").filter(v -> !v.equalsIgnoreCase(reglage.module))
                .collect(Collectors.joining(","));
        return List.of("-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"), "lancer.Main", "--sans=" + sans);
    }

    private Mesureur mesureur() {
        return new Mesureur(dossier, null, new PrintStream(sortie), PETITE, true, VitesseTest::programme);
    }

    /** Les rayons, comptés dans ce processus sur un pavé sur quatre, sont à peu près ceux que la commande entière dit. */
    @Test
    void lesRayonsComptesSontCeuxDeLaCommandeEntiere() throws IOException {
        Taille taille = new Taille(320, 240);
        Mesureur mesureur = new Mesureur(dossier, null, new PrintStream(sortie), taille, true, VitesseTest::programme);
        Groupe deux = new Groupe(Catalogue.CHOIX, Catalogue.COURS, Catalogue.COURS).avec(Reglage.UN_RAYON, 0)
                .avec(Reglage.coins(3, 0.05), 0);
        mesureur.compter(deux, resultats);
        Mesure un = resultats.de(Reglage.UN_RAYON).get();
        Mesure coins = resultats.de(Reglage.coins(3, 0.05)).get();
        assertTrue(coins.erreur.max < un.erreur.min, "quatre rayons par pixel se trompent moins qu'un");
        assertTrue(coins.visibles < un.visibles && un.visibles < 1 && un.examens > un.rayons, un.ligne());
        for (Mesure m : resultats.toutes) {
            Reglage reglage = m == un ? Reglage.UN_RAYON : Reglage.coins(3, 0.05);
            Matcher rayons = Pattern.compile("(?m)^rayons\\.[a-z]+: (\\d+)$").matcher(mesureur.lancer(reglage,
                    Scenes.fichier(Catalogue.COURS, dossier), "--lineaire", dossier.resolve("i.pfm"), "--statistiques").dit);
            double somme = 0;
            while (rayons.find()) {
                somme += Double.parseDouble(rayons.group(1));
            }
            assertEquals(somme, m.rayons, 0.15 * somme, m.ligne());
        }
    }

    /** D'un module, le premier réglage ; tous, si l'on demande les tests longs. */
    @Tag("long")
    @Test
    void toutReglageDuCatalogueSeLanceEtSeChronometre() throws IOException {
        Function<Reglage, String> nom = System.getProperty("tests.longs") != null ? Reglage::nom : reglage -> reglage.module;
        Set<String> deja = new HashSet<>();
        Groupe tous = new Groupe(Catalogue.CHOIX, "bowling", Catalogue.COURS);
        Catalogue.temps().stream().filter(g -> !g.volet.equals(Catalogue.SPHERES)).flatMap(g -> g.essais.stream())
                .map(e -> e.reglage).filter(reglage -> deja.add(nom.apply(reglage))).forEach(reglage -> tous.avec(reglage, 0));
        mesureur().chronometrer(tous, resultats);
        assertEquals(tous.essais.size(), resultats.toutes.size());
        for (Mesure m : resultats.toutes) {
            assertTrue(m.rapport() > 0 && m.mur > 0, m.ligne());
            assertTrue(m.memoire > 0 == Files.isExecutable(Path.of("/usr/bin/time")), "GNU time dit la mémoire");
        }
    }

    @Test
    void uneMesureSeRelitTelleQuElleEstEcrite() throws IOException {
        mesureur().chronometrer(new Groupe(Catalogue.FILS, Catalogue.COURS, Catalogue.COURS).avec(Reglage.UN_RAYON, 3), resultats);
        resultats.ecrire(dossier);
        assertEquals(resultats.toutes.get(0).ligne(), Resultats.lire(dossier).toutes.get(0).ligne());
        assertEquals(0, Resultats.lire(dossier.resolve("ailleurs")).toutes.size());
    }

    @Test
    void ceQuePrendUnProgrammeEstCeQuIlPrendVraiment() throws IOException {
        Lancement dort = new Lancement(dossier.resolve("pris"), "sh", "-c", "echo oui ; sleep 0.2").reussi();
        assertEquals("oui", dort.dit);
        assertTrue(dort.pris[0] >= 0.2e9 && dort.pris[1] < 0.2e9, Arrays.toString(dort.pris));
        String panne = assertThrows(IOException.class,
                () -> new Lancement(dossier.resolve("pris"), "sh", "-c", "echo panne >&2 ; exit 3").reussi()).getMessage();
        assertTrue(panne.endsWith("statut 3 : panne"), panne);
    }

    // ---- ce qu'on en dit

    private void noter(String scene, Reglage reglage, double rapport, double erreur) {
        Mesure m = new Mesure(Catalogue.CHOIX, scene, reglage.methode, reglage.parametres, 0);
        m.rayons = 10 * rapport;
        m.erreur = new Intervalle(erreur, erreur * 0.95, erreur * 1.05);
        m.visibles = 0.01;
        m.compte = "abc 2026-11-2" + resultats.toutes.size();
        m.unite = 0.4;
        m.processeurs = 0.4 * rapport;
        m.chronometre = "abc 2026-11-25";
        resultats.toutes.add(m);
    }

    @Test
    void chaqueSouhaitAUneReponseParSorteDeScene() {
        noter("scene1", Reglage.UN_RAYON, 1, 3);
        noter("scene1", Reglage.partage(16, 0.02), 2.5, 0.2);
        noter("scene1", Catalogue.UN_NIVEAU, 1.9, 0.6);
        noter("scene1", Reglage.partage(4, 0.07), 1.5, 0.9);
        noter("scene1", Reglage.grille(2), 1.2, 0.5);
        noter("poussiere", Reglage.UN_RAYON, 1, 12);
        noter("poussiere", Reglage.partage(16, 0.02), 2.5, 0.27);
        noter("poussiere", Catalogue.UN_NIVEAU, 2, 0.94);
        noter("poussiere", Reglage.partage(4, 0.07), 1.5, 1.2);
        String table = new Tableaux(resultats).pages().get("choisir");
        assertTrue(table.contains("<tr><td>aller au plus vite</td><td><b>un rayon</b><br>au pire 3 niveaux (de 2,8 à 3,2, scene1)<br>1 % "
                + "des pixels visiblement faux<br>rayons × 1, temps × 1</td><td><b>un rayon</b><br>au pire 12 niveaux (de 11 à 13, "),
                table);
        // l'erreur de la grille n'est pas connue de la poussière ; ce qui suffit sans détail ne suffit pas avec
        assertTrue(table.contains("<tr><td>le mieux, en deux fois ce temps ; un niveau au plus</td><td><b>grille 2 × 2</b>"), table);
        assertTrue(table.contains("rayons × 1,2, temps × 1,2</td><td><b>partage n=12 seuil=0.045</b><br>au pire 0,94 niveau"), table);
        assertTrue(table.contains("<tr><td>moins que l'arrondi de l'écran</td><td><b>partage n=16 seuil=0.02</b>"), table);
        assertTrue(table.contains("\n    [Antialias]\n    methode=partage\n    n=16\n    seuil=0.02\n\n"), table);
        assertTrue(table.contains("\n    java -jar antialias/target/antialias.jar --reflets 1000 --image boules.png scenes/scene1.ini\n"),
                table);
        assertEquals(1, table.split("n=16\n", -1).length - 1, "ce qui est à écrire l'est une fois");
        assertTrue(table.endsWith("\nLa plus ancienne de ces mesures : commit abc, le 2026-11-20 ; abc, le 2026-11-25.\n"), table);
    }

    @Test
    void deuxSouhaitsQuiOntLaMemeReponseSontUneLigne() {
        noter("scene1", Reglage.UN_RAYON, 1, 3);
        noter("scene1", Reglage.partage(16, 0.02), 1.5, 0.1);
        assertTrue(new Tableaux(resultats).pages().get("choisir").contains("<tr><td>le mieux, en deux fois ce temps ; un niveau au plus ; "
                + "moins que l'arrondi de l'écran</td><td><b>partage"));
    }

    @Test
    void sansAucunTempsLaTableLeDit() {
        noter("scene1", Reglage.UN_RAYON, 1, 3);
        resultats.toutes.get(0).processeurs = Double.NaN;
        Map<String, String> pages = new Tableaux(resultats).pages();
        assertTrue(pages.get("choisir").contains("l'arrondi de l'écran</td><td>rien de ce qui est mesuré</td>"), pages.get("choisir"));
        assertEquals("pas encore mesuré", pages.get("machine"));
    }

    @Test
    void unTempsNEstDitPlusLongQuAuDelaDUnDixieme() {
        assertEquals("autant, à un dixième près", Tableaux.rapport(0.92));
        assertEquals("× 3", Tableaux.rapport(3));
    }

    @Test
    void laPenteDUneDroiteEstLaSienne() {
        for (int x : new int[] {2, 4, 8}) {
            Mesure m = new Mesure(Catalogue.FILS, Catalogue.COURS, "fils", "" + x, x);
            m.processeurs = 0.5 + 0.1 * x;
            resultats.toutes.add(m);
        }
        assertEquals(0.1, Planches.pente(resultats.toutes, m -> m.x, m -> m.processeurs), 1e-12);
    }
}
