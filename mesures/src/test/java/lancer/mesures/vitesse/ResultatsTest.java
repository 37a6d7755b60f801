package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;
import lancer.contrat.Compteurs;
import lancer.mesures.FichierCsv;
import lancer.mesures.ImageLineaire;
import lancer.mesures.pages.PagesMesurees;
import lancer.mesures.scenes.Scenes;
import lancer.scene.FichierScene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les résultats notés avec le programme, et les pages qui les montrent : ce que le programme compte aujourd'hui. */
class ResultatsTest {

    private static final Path RESULTATS = projet("mesures/resultats");

    /**
     * Lignes recomptées des réglages, et deux fois moins des foules ; une image de plus de rayons que cela prendrait trop de temps à
     * refaire.
     */
    private static final int LIGNES = 6;
    private static final double RAYONS_MAX = 1e7;

    @TempDir
    Path dossier;

    /** Que les tests soient lancés à la racine ou dans le module. */
    private static Path projet(String chemin) {
        return Paths.get(Files.exists(Paths.get("ensemble.xml")) ? "" : "..").resolve(chemin);
    }

    private static List<Releve> auSort(List<Releve> releves, int lignes) {
        List<Releve> possibles = releves.stream().filter(r -> r.rayons() < RAYONS_MAX && r.nombre("spheres") < 20000)
                .collect(Collectors.toList());
        assertTrue(possibles.size() >= lignes, possibles.size() + " lignes");
        return new Random(1).ints(0, possibles.size()).distinct().limit(lignes).mapToObj(possibles::get).collect(Collectors.toList());
    }

    private static void verifier(Releve r, Compteurs c) {
        assertEquals(r.texte("primaires") + " " + r.texte("ombre") + " " + r.texte("reflechis") + " " + r.texte("tests") + " "
                + r.texte("noeuds") + " " + r.texte("raffines"),
                c.primaires + " " + c.ombre + " " + c.reflechis + " " + c.testsSpheres + " " + c.noeudsVisites + " " + c.pixelsRaffines,
                "vitesse.csv n'est plus de ce programme (make mesures) : " + r.scene + " " + r.methode + " " + r.parametres);
    }

    @Test
    void lesComptesDesReglagesSontEncoreCeuxDuProgramme() throws IOException {
        List<Releve> tous = Releves.lire(RESULTATS).aNous().tels(r -> !r.famille.equals(Catalogue.SPHERES)).get();
        for (Releve r : auSort(tous, LIGNES)) {
            Methode methode = Catalogue.methode(r.famille, r.scene, r.methode + "/" + r.parametres);
            Taille taille = new Taille((int) r.nombre("largeur"), (int) r.nombre("hauteur"));
            Methode.ScenePrete dessin = methode.new ScenePrete(Scenes.lire(Scenes.fichier(r.scene, dossier)), taille.largeur,
                    taille.hauteur);
            dessin.faire(new ImageLineaire(taille.largeur, taille.hauteur), taille.fils);
            Compteurs c = dessin.lancer.getCompteurs();
            assertEquals(r.texte("primaires") + " " + r.texte("ombre") + " " + r.texte("reflechis"),
                    c.primaires + " " + c.ombre + " " + c.reflechis, "ne sont plus de ce programme (make mesures MESURES=--comptes) : "
                    + r.scene + " " + r.nom());
        }
    }

    @Test
    void lesComptesDesFoulesSontEncoreCeuxDuProgramme() throws IOException {
        List<Releve> tous = Releves.lire(RESULTATS).de(Catalogue.SPHERES).methode(Catalogue.PROGRAMME).get();
        for (Releve r : auSort(tous, LIGNES / 2)) {
            Taille taille = new Taille((int) r.nombre("largeur"), (int) r.nombre("hauteur"));
            Methode.ScenePrete dessin = new Methode("", "").new ScenePrete(Scenes.lire(Scenes.fichier(r.scene, dossier)), taille.largeur,
                    taille.hauteur);
            dessin.faire(new ImageLineaire(taille.largeur, taille.hauteur), taille.fils);
            verifier(r, dessin.lancer.getCompteurs());
        }
    }

    @Test
    void lesBesoinsSontEncoreCeuxQueCompteLeProgramme() throws IOException {
        Map<String, String> diffus = FichierCsv.lire(RESULTATS.resolve(Vitesse.BESOINS)).stream()
                .filter(b -> b.get("scene").equals("diffus")).findFirst().get();
        diffus.keySet().removeAll(Arrays.asList("alloues_mo", "commit", "date"));
        assertEquals(String.join(",", diffus.values()), new Besoin(FichierScene.trouver("scenes/diffus.ini"),
                new Taille(Integer.parseInt(diffus.get("largeur")), Integer.parseInt(diffus.get("hauteur")))).ligne());
    }

    @Test
    void lesNombresDesPagesSontCeuxDesMesures() throws IOException {
        Map<String, String> valeurs = new Rapport(RESULTATS, new PrintStream(System.out)).valeurs();
        for (Path relative : Rapport.PAGES) {
            String texte = new String(Files.readAllBytes(projet(relative.toString())), StandardCharsets.UTF_8);
            assertTrue(texte.contains("<!--v:"), relative + " montre des mesures");
            assertEquals(PagesMesurees.remplacer(texte, valeurs), texte, relative + " : make mesures, ou MESURES=--dessiner, le réécrit");
        }
    }
}
