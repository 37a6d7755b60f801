package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.mesures.Intervalle;
import lancer.mesures.Lancement;
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
    @ValueSource(strings = {"--inconnue", "scene1", "--rapide --rapide"})
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
        return Arrays.asList("-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"), "lancer.Main", "--sans=" + sans);
    }

    private Mesureur mesureur() {
        return new Mesureur(dossier, null, new PrintStream(sortie), PETITE, true, VitesseTest::programme);
    }

    @Test
    void lesRayonsEtLErreurDUneCommandeSontCeuxDeSonImage() throws IOException {
        Groupe deux = new Groupe(Catalogue.CHOIX, Catalogue.COURS, Catalogue.COURS).avec(Reglage.UN_RAYON, 0, PETITE)
                .avec(Reglage.grille(2), 0, PETITE).avec(Reglage.auto(4), 0, PETITE);
        mesureur().compter(deux, resultats);
        Mesure un = resultats.de(Reglage.UN_RAYON).get();
        Mesure grille = resultats.de(Reglage.grille(2)).get();
        assertTrue(un.rayons > 1200 && grille.rayons > 4 * 1200 && un.examens > un.rayons, un.ligne() + "\n" + grille.ligne());
        assertTrue(grille.erreur.nettementSous(un.erreur), "quatre rayons par pixel se trompent moins qu'un");
        assertTrue(grille.visibles < un.visibles && un.visibles < 1);
        assertTrue(resultats.de(Reglage.auto(4)).get().rayons > grille.rayons, "les rayons des essais comptent");
    }

    /** D'un module, le premier réglage ; tous, si l'on demande les tests longs. */
    @Tag("long")
    @Test
    void toutReglageDuCatalogueSeLanceEtSeChronometre() throws IOException {
        Function<Reglage, String> nom = System.getProperty("tests.longs") != null ? Reglage::nom : reglage -> reglage.module;
        Set<String> deja = new HashSet<>();
        Groupe tous = new Groupe(Catalogue.CHOIX, "bowling", Catalogue.COURS);
        new Catalogue(true).temps().stream().filter(g -> !g.volet.equals(Catalogue.SPHERES)).flatMap(g -> g.essais.stream())
                .map(e -> e.reglage).filter(reglage -> deja.add(nom.apply(reglage))).forEach(reglage -> tous.avec(reglage, 0, PETITE));
        mesureur().chronometrer(tous, resultats);
        assertEquals(tous.essais.size(), resultats.toutes.size());
        for (Mesure m : resultats.toutes) {
            assertTrue(m.rapport.valeur > 0 && m.unite > 0 && m.processeurs > 0, m.ligne());
            assertTrue(m.memoire > 0 == Files.isExecutable(Paths.get("/usr/bin/time")), "GNU time dit la mémoire");
            assertTrue(m.rapport.max == Double.POSITIVE_INFINITY, "d'une seule manche, rien ne se sait");
        }
    }

    @Test
    void uneMesureSeRelitTelleQuElleEstEcrite() throws IOException {
        mesureur().chronometrer(new Groupe(Catalogue.FILS, Catalogue.COURS, Catalogue.COURS).avec(Reglage.UN_RAYON, 3, PETITE), resultats);
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
        m.compte = "abc 2026-11-24";
        m.unite = 0.4;
        m.rapport = new Intervalle(rapport, rapport / 1.05, rapport * 1.05);
        m.chronometre = "abc 2026-11-25";
        resultats.toutes.add(m);
    }

    @Test
    void laPremiereTableRepondAUneQuestionParLeReglageLeMoinsCherSurToutesLesScenes() {
        noter("scene1", Reglage.UN_RAYON, 1, 3);
        noter("scene1", Reglage.partage(16, 0.03), 2.5, 0.2);
        noter("scene1", Reglage.partage(8, 0.06), 2, 0.6);
        noter("scene1", Reglage.partage(4, 0.2), 1.5, 0.9);
        noter("scene1", Reglage.grille(2), 1.2, 0.5);
        noter("scene1", Reglage.auto(1), 1.8, 0.7);
        noter("miroirs", Reglage.UN_RAYON, 1, 12);
        noter("miroirs", Reglage.partage(16, 0.03), 2.5, 0.27);
        noter("miroirs", Reglage.partage(8, 0.06), 2, 0.94);
        noter("miroirs", Reglage.partage(4, 0.2), 1.5, 1.2);
        noter("miroirs", Reglage.auto(1), 1.8, 0.95);
        String table = new Tableaux(resultats).pages().get("choisir");
        assertTrue(table.contains("<td>aller au plus vite</td><td>un rayon</td><td>3 niveaux</td><td>12 niveaux (miroirs)</td><td>× 1</td>"
                + "<td>0,4 s, l'unité</td>"), table);
        assertTrue(table.contains("<td>le mieux, en deux fois ce temps</td><td>partage n=8 seuil=0.06</td><td>0,6 niveau</td>"
                + "<td>0,94 niveau (miroirs)</td><td>× 2</td><td>0,8 s, × 2 (de 1,9"), table);
        // l'erreur de la grille n'est connue que d'une scène
        assertTrue(table.contains("<td>un niveau au plus</td><td>--auto erreur=1</td><td>0,7 niveau</td>"), table);
        assertTrue(table.contains("\n    [Antialias]\n    methode=partage\n    n=16\n    seuil=0.03\n\n"), table);
        assertTrue(table.contains("\n    java -jar antialias/target/antialias.jar --reflets 1000 --seuil 0.0078125 --image boules.png "
                + "scenes/scene1.ini\n"), table);
        assertEquals(1, table.split("n=16\n", -1).length - 1, "ce qui est à écrire l'est une fois");
        assertTrue(table.endsWith("\nMesures du commit abc, le 2026-11-25.\n"), table);
    }

    @Test
    void sansAucunTempsLaTableLeDit() {
        noter("scene1", Reglage.UN_RAYON, 1, 3);
        resultats.toutes.get(0).rapport = Intervalle.exact(Double.NaN);
        Map<String, String> pages = new Tableaux(resultats).pages();
        assertTrue(pages.get("choisir").contains("<td>un niveau au plus</td><td colspan=\"5\">rien de ce qui est mesuré</td>"),
                pages.get("choisir"));
        assertEquals("pas encore mesuré", pages.get("machine"));
    }

    @Test
    void uneDroiteEtSaPenteSontCellesDesTemps() {
        for (int x : new int[] {2, 4, 8}) {
            Mesure m = new Mesure(Catalogue.LAMPES, Catalogue.COURS, "lampes", "" + x, x);
            m.unite = 0.5;
            m.rapport = Intervalle.exact(1 + 0.2 * x);
            resultats.toutes.add(m);
        }
        double[] droite = Planches.droite(resultats);
        assertEquals(0.5, droite[0], 1e-12);
        assertEquals(0.1, droite[1], 1e-12);
    }
}
