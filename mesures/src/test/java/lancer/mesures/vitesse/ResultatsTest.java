package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.mesures.FichierCsv;
import lancer.mesures.pages.PagesMesurees;
import lancer.mesures.trace.Planche;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les mesures publiées sont de ce programme, et les pages disent ce qu'elles disent. */
class ResultatsTest {

    private static final Path RESULTATS = Path.of("../mesures/resultats");
    @TempDir
    Path dossier;

    private static Resultats publies() throws IOException {
        return Resultats.lire(RESULTATS);
    }

    /** Deux réglages de la scène du cours, comptés de nouveau : ce que les pages disent est de ce programme. */
    @Test
    void unComptePublieEstCeluiDuProgrammeOuIlEstNomme() throws IOException {
        Resultats cours = publies().volet(Catalogue.CHOIX).scene(Catalogue.COURS);
        cours.ecrire(dossier);
        Verification verification = new Verification(dossier, dossier, System.out);
        verification.faire();
        cours.de(Catalogue.UN_NIVEAU).get().rayons *= 1.001;
        cours.ecrire(dossier);
        String dit = assertThrows(IOException.class, verification::faire).getMessage();
        assertTrue(dit.matches(".*\\(make mesures les refait\\) : scene1, partage n=12 seuil=0.045 : [^;]*"), dit);
    }

    @Test
    void chaqueSceneLivreeEstDansChaqueTable() throws IOException {
        Map<String, List<String>> tables = new TreeMap<>();
        for (String csv : List.of("juge.csv", "auto.csv")) {
            tables.put(csv, FichierCsv.lire(RESULTATS.resolve(csv)).stream().map(c -> c[0]).collect(Collectors.toList()));
        }
        tables.put(Catalogue.CHOIX, publies().volet(Catalogue.CHOIX).scenes());
        tables.put(Catalogue.REFLETS, publies().volet(Catalogue.REFLETS).scenes());
        tables.forEach((table, scenes) -> {
            List<String> manquent = new ArrayList<>(livrees());
            manquent.removeAll(scenes);
            assertEquals(List.of(), manquent, "scènes qui manquent à " + table);
        });
    }

    private static List<String> livrees() {
        try {
            return Catalogue.livrees();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void aucunGraphiqueNEstVide() throws IOException {
        Map<String, Planche> planches = new Rapport(RESULTATS).planches();
        assertTrue(planches.size() >= 9, planches.keySet().toString());
        planches.forEach((nom, planche) -> assertTrue(planche.seVoit(), nom + " : un graphique n'a pas de point entre ses axes"));
    }

    @Test
    void lesNombresDesPagesSontCeuxDesMesures() throws IOException {
        Map<String, String> valeurs = new Rapport(RESULTATS).valeurs();
        for (Path relative : Rapport.PAGES) {
            String texte = Files.readString(Path.of("..").resolve(relative));
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
    void ceQuiEstAEcrireSousLaPremiereTableEstDesReglagesDuCatalogue() throws IOException {
        String page = Files.readString(Path.of("../docs/vitesse-et-precision.md"))
                .replace('\u00a0', ' ');
        int essayees = 0;
        for (Mesure m : publies().volet(Catalogue.CHOIX).scene(Catalogue.COURS).toutes) {
            int debut = page.indexOf("**" + m.nom() + "** :");
            if (debut >= 0) {
                Reglage reglage = Catalogue.reglage(m);
                List<String> blocs = blocs(page.substring(debut));
                assertEquals(reglage.commande(), blocs.get(reglage.section.isEmpty() ? 0 : 1));
                assertEquals(reglage.section.trim(), reglage.section.isEmpty() ? "" : blocs.get(0));
                essayees++;
            }
        }
        assertTrue(essayees > 1, "la table n'a pas de commande");
    }
}
