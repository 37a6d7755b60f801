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
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lancer.contrat.Compteurs;
import lancer.mesures.FichierCsv;
import lancer.mesures.ImageLineaire;
import lancer.mesures.Lancement;
import lancer.mesures.pages.PagesMesurees;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.trace.Style;
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
        diffus.keySet().removeAll(Arrays.asList("commit", "date"));
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

    /** Les blocs d'une page, lignes en retrait. */
    private static List<String> blocs(String texte) {
        Matcher m = Pattern.compile("(?m)(?:^ {4}.*\\n)+").matcher(texte);
        List<String> blocs = new ArrayList<>();
        while (m.find()) {
            blocs.add(m.group().replaceAll("(?m)^ {4}", ""));
        }
        return blocs;
    }

    @Test
    void ceQuiEstAEcrireSousUneLigneDeLaPremiereTableDonneSonReglage() throws IOException {
        String page = new String(Files.readAllBytes(projet("docs/vitesse-et-precision.md")), StandardCharsets.UTF_8);
        List<Releve> mesures = Releves.lire(RESULTATS).de(Catalogue.METHODES).scene(Catalogue.COURS).get();
        String scene = new String(Files.readAllBytes(projet("scenes/scene1.ini")), StandardCharsets.UTF_8);
        int essayees = 0;
        for (String ligne : page.split("<tr><td>")) {
            String section = "";
            for (String bloc : blocs(ligne)) {
                section += bloc.startsWith("[") ? bloc : "";
                if (bloc.startsWith("java -jar ") && !bloc.contains("--auto")) {
                    Path image = dossier.resolve("boules.png");
                    Path fichier = Files.write(dossier.resolve("scene.ini"), (scene + "\n" + section).getBytes(StandardCharsets.UTF_8));
                    List<Object> commande = new ArrayList<>(Arrays.asList(Lancement.JAVA, "-cp", System.getProperty("java.class.path"),
                            "lancer.Main", "--sans=Brume,Blinn" + (bloc.contains("antialias.jar") ? "" : ",Antialias"), "--statistiques"));
                    commande.addAll(Arrays.asList(bloc.trim().replaceFirst("java -jar \\S+ ", "").replace("boules.png", image.toString())
                            .replace("scenes/scene1.ini", fichier.toString()).split(" ")));
                    String dit = new Lancement(dossier.resolve("pris"), commande.toArray()).reussi().dit;
                    assertTrue(mesures.stream().anyMatch(r -> ligne.contains("<td>" + Style.niveaux(r.erreur().valeur) + "</td>")
                            && dit.contains("rayons.primaires: " + r.texte("primaires") + "\n")
                            && dit.contains("rayons.ombre: " + r.texte("ombre") + "\n")), bloc + dit);
                    essayees++;
                }
            }
        }
        assertTrue(essayees > 0, "la table n'a pas de commande");
    }
}
