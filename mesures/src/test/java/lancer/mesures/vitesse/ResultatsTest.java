package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.mesures.Nombres;
import lancer.mesures.pages.PagesMesurees;
import lancer.mesures.scenes.Scenes;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les mesures publiées sont de ce programme, et les pages disent ce qu'elles disent. */
class ResultatsTest {

    private static final Path RESULTATS = Paths.get("../mesures/resultats");
    private static final Taille TAILLE = new Taille(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);

    /** Nombre de réglages que le test compte de nouveau, et rayons que chacun ne dépasse pas. */
    private static final int ESSAYES = System.getProperty("tests.longs") != null ? 4 : 1;
    private static final double RAYONS_MAX = 5e6;

    @TempDir
    Path dossier;

    private static Resultats publies() throws IOException {
        return Resultats.lire(RESULTATS);
    }

    private Mesureur mesureur() {
        return new Mesureur(dossier, null, new PrintStream(System.out), TAILLE, true, VitesseTest::programme);
    }

    @Tag("long")
    @Test
    void lesRayonsPubliesSontEncoreCeuxDuProgramme() throws IOException {
        List<Mesure> possibles = publies().volet(Catalogue.CHOIX)
                .tels(m -> m.rayons < RAYONS_MAX && !m.methode.equals(Reglage.AUTO)).toutes;
        List<Mesure> essayes = new Random(1).ints(0, possibles.size()).distinct().limit(ESSAYES).mapToObj(possibles::get)
                .collect(Collectors.toList());
        for (Mesure m : essayes) {
            assertEquals(Nombres.champ(m.rayons), Nombres.champ(mesureur().rayons(Catalogue.reglage(m), Scenes.fichier(m.scene, dossier))),
                    m.scene + ", " + m.nom() + " : make mesures MESURES=--comptes");
        }
    }

    @Test
    void lesNombresDesPagesSontCeuxDesMesures() throws IOException {
        Map<String, String> valeurs = new Rapport(RESULTATS).valeurs();
        for (Path relative : Rapport.PAGES) {
            String texte = new String(Files.readAllBytes(Paths.get("..").resolve(relative)), StandardCharsets.UTF_8);
            assertTrue(texte.contains("<!--v:"), relative + " montre des mesures");
            assertEquals(PagesMesurees.remplacer(texte, valeurs), texte, relative + " : make mesures, ou MESURES=--dessiner, le réécrit");
        }
    }

    /** Les blocs d'une page, lignes en retrait. */
    private static List<String> blocs(String texte) {
        Matcher m = Pattern.compile("(?m)(?:^ {4}.*\\n)+").matcher(texte);
        List<String> blocs = new ArrayList<>();
        while (m.find()) {
            blocs.add(m.group().replaceAll("(?m)^ {4}", "").trim());
        }
        return blocs;
    }

    @Test
    void ceQuiEstAEcrireSousUneLigneDeLaPremiereTableEstSonReglage() throws IOException {
        String page = new String(Files.readAllBytes(Paths.get("../docs/vitesse-et-precision.md")), StandardCharsets.UTF_8);
        Resultats cours = publies().volet(Catalogue.CHOIX).scene(Catalogue.COURS);
        int essayees = 0;
        for (String ligne : page.split("<tr><td>(?=[a-z])")) {
            List<String> blocs = blocs(ligne);
            for (Mesure m : blocs.isEmpty() ? Collections.<Mesure>emptyList() : cours.toutes) {
                if (ligne.replace('\u00a0', ' ').contains("<td>" + m.nom() + "</td>")) {
                    Reglage reglage = Catalogue.reglage(m);
                    assertEquals(reglage.commande(), blocs.get(blocs.size() - 1));
                    assertEquals(reglage.section.trim(), blocs.size() > 1 ? blocs.get(0) : "");
                    essayees++;
                }
            }
        }
        assertTrue(essayees > 1, "la table n'a pas de commande");
    }
}
