package lancer.projet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Collections;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Ce qui dépend de quoi, lu dans les sources : les classes que chacune nomme, par son import, son paquet ou son nom complet. */
class DependancesTest {

    private static final Path SOURCES = Paths.get("src", "main", "java");

    /** Chaînes et commentaires ne dépendent de rien. */
    private static final Pattern TEXTES = Pattern.compile("\"(\\\\.|[^\"\\\\])*\"|'(\\\\.|[^'\\\\])+'|//[^\n]*|/\\*.*?\\*/",
            Pattern.DOTALL);
    private static final Pattern PAQUET = Pattern.compile("(?m)^package .*?;");
    private static final Pattern NOM = Pattern.compile("(?<![\\w.])(?:java|javax|sun|com|org|lancer)(?:\\.[a-z]\\w*)*\\.[A-Z]\\w*");
    private static final Pattern NOM_SIMPLE = Pattern.compile("(?<![\\w.])[A-Z]\\w*");

    private static final String JAVA = "java\\.(?!awt).*";
    private static final String COURS = JAVA + "|lancer\\.[A-Z].*|";

    /** De chaque classe, son code sans commentaire ni chaîne, et les classes qu'elle nomme. */
    private static final Map<String, String> CODES = new TreeMap<>();
    private static final Map<String, Set<String>> NOMS = new TreeMap<>();

    @BeforeAll
    static void lireLesSources() throws IOException {
        try (Stream<Path> fichiers = Files.walk(SOURCES)) {
            for (Path fichier : (Iterable<Path>) fichiers.filter(f -> f.toString().matches(".*(?<!package-info)\\.java"))::iterator) {
                String texte = new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
                String classe = SOURCES.relativize(fichier).toString().replace(fichier.getFileSystem().getSeparator(), ".");
                CODES.put(classe.substring(0, classe.length() - ".java".length()),
                        PAQUET.matcher(TEXTES.matcher(texte).replaceAll(" ")).replaceAll(""));
            }
        }
        assertTrue(CODES.containsKey("lancer.Main"), "les sources ne sont pas là : " + SOURCES.toAbsolutePath());
        CODES.forEach((classe, code) -> {
            Set<String> noms = new TreeSet<>();
            Matcher m = NOM.matcher(code);
            while (m.find()) {
                noms.add(m.group());
            }
            m = NOM_SIMPLE.matcher(code);
            while (m.find()) {
                String simple = "." + m.group();
                if (CODES.containsKey(paquet(classe) + simple) && noms.stream().noneMatch(n -> n.endsWith(simple))) {
                    noms.add(paquet(classe) + simple);
                }
            }
            noms.remove(classe);
            NOMS.put(classe, noms);
        });
    }

    private static String paquet(String classe) {
        return classe.substring(0, classe.lastIndexOf('.'));
    }

    /** Les classes dont le nom est {@code classes} ne nomment que leurs voisines et celles dont le nom est {@code permis}. */
    private static void verifier(String classes, String permis) {
        Set<String> fautes = new TreeSet<>();
        NOMS.forEach((classe, noms) -> noms.stream()
                .filter(n -> classe.matches(classes) && !paquet(n).equals(paquet(classe)) && !n.matches(permis))
                .forEach(n -> fautes.add(classe + " nomme " + n)));
        assertEquals(new TreeSet<>(), fautes);
    }

    @Test
    void lesClassesDuCoursNeDependentQueDesContratsEtDeLaPrecision() {
        String permis = JAVA + "|lancer\\.(contrat|precision)\\..*";
        verifier("lancer\\.(?!Main|Scene|Lancer)\\w+|lancer\\.SceneFautive", permis);
        verifier("lancer\\.Lancer", permis + "|lancer\\.fils\\..*");
        verifier("lancer\\.Scene", permis + "|lancer\\.scene\\.(LecteurScene|SceneLue)");
    }

    @Test
    void lesContratsNeDependentQueDuCoursEtDesTextes() {
        verifier("lancer\\.contrat\\..*", COURS + "lancer\\.texte\\..*");
        verifier("lancer\\.precision\\..*", COURS);
        verifier("lancer\\.texte\\..*", JAVA);
        verifier("lancer\\.fils\\..*", COURS + "lancer\\.(contrat|texte)\\..*");
    }

    @Test
    void laCommandeNeDependQueDesContratsEtDesTextes() {
        verifier("lancer\\.commande\\..*", JAVA + "|lancer\\.(Constantes|SceneFautive)|lancer\\.(contrat|texte)\\..*");
    }

    @Test
    void laRechercheRapideNeSaitRienDesSortiesNiDeLaCommande() {
        verifier("lancer\\.rapide\\..*", COURS + "lancer\\.(contrat|precision|fils)\\..*|lancer\\.image\\.ImageMemoire");
    }

    @Test
    void leChoixDesReglagesNeSaitRienDesSortiesNiDesVariantes() {
        verifier("lancer\\.auto\\..*", COURS + "lancer\\.contrat\\..*|lancer\\.commande\\.(Reglages|Etape)");
        String saufCeuxQuiLeDemandent = "(?!Main|dessin\\.SansFenetre|fenetre\\.PanneauVitesse).*";
        verifier("lancer\\." + saufCeuxQuiLeDemandent, "(?!lancer\\.auto\\.).*");
    }

    @Test
    void seuleLaFenetreConnaitAwtEtImageIoNeLitQueLesImagesAComparer() {
        String sansAwt = "(?!java\\.awt|javax\\.|sun\\.|com\\.).*";
        verifier("lancer\\.(?!fenetre\\.|image\\.LectureImage).*", sansAwt);
        verifier("lancer\\.image\\.LectureImage", sansAwt + "|java\\.awt\\.image\\..*|javax\\.imageio\\..*");
        verifier("lancer\\.(?!fenetre\\.|Main).*", "(?!lancer\\.fenetre\\.).*");
    }

    @Test
    void seuleLaLectureConnaitIni4jEtNEnPrendQueLeDecoupage() {
        verifier("lancer\\.(?!scene\\.).*", "(?!org\\.ini4j).*");
        verifier(".*", "(?!org\\.).*|org\\.ini4j\\.(Config|InvalidFileFormatException|spi\\.IniHandler|spi\\.IniParser)");
        // la CVE-2022-41404 passe par ces méthodes-là
        CODES.forEach((classe, code) -> assertFalse(classe.startsWith("lancer.scene.")
                && Pattern.compile("\\bfetch\\w*\\s*\\(|\\.\\s*(to|as|from)\\s*\\(").matcher(code).find(), classe));
    }

    @Test
    void laLectureEtLesSortiesNeSeConnaissentPas() {
        verifier("lancer\\.scene\\..*", COURS + "lancer\\.(contrat|texte)\\..*|org\\.ini4j\\..*");
        verifier("lancer\\.image\\.(?!LectureImage).*", COURS + "lancer\\.(contrat|texte)\\..*|lancer\\.commande\\.Echec");
    }

    /** Celui du cours lui-même mis à part : il se sert de tous. */
    @Test
    void aucunCercleNeRelieLesPaquets() {
        Map<String, Set<String>> fleches = new TreeMap<>();
        NOMS.forEach((classe, noms) -> noms.stream().map(DependancesTest::paquet)
                .filter(p -> p.startsWith("lancer.") && !paquet(classe).equals("lancer") && !p.equals(paquet(classe)))
                .forEach(p -> fleches.computeIfAbsent(paquet(classe), c -> new TreeSet<>()).add(p)));
        assertTrue(fleches.containsKey("lancer.rapide"));
        assertEquals(Collections.emptyMap(), cercles(fleches));
    }

    /** Ceux du cours : une scène a des objets, qui se colorent dans une scène ; un rayon retient l'objet qu'il touche. */
    @Test
    void aucunCercleNeRelieLesClassesQueCeuxDuCours() {
        Map<String, Set<String>> cours = new TreeMap<>();
        NOMS.forEach((classe, noms) -> noms.stream().filter(n -> paquet(classe).equals("lancer") && paquet(n).equals("lancer"))
                .forEach(n -> cours.computeIfAbsent(classe, c -> new TreeSet<>()).add(n)));
        Map<String, Set<String>> duCours = cercles(cours);
        assertEquals(new TreeSet<>(Arrays.asList("lancer.Camera", "lancer.Objet3D", "lancer.Point", "lancer.PointContact", "lancer.Rayon",
                "lancer.Scene", "lancer.Sphere", "lancer.Vecteur")), duCours.keySet());
        Map<String, Set<String>> fleches = new TreeMap<>();
        NOMS.forEach((classe, noms) -> noms.stream()
                .filter(n -> CODES.containsKey(n) && !duCours.getOrDefault(classe, Collections.emptySet()).contains(n))
                .forEach(n -> fleches.computeIfAbsent(classe, c -> new TreeSet<>()).add(n)));
        assertEquals(Collections.emptyMap(), cercles(fleches));
    }

    /** Les flèches de ce graphe qui font partie d'un cercle : on revient d'où elles partent. */
    private static Map<String, Set<String>> cercles(Map<String, Set<String>> fleches) {
        Map<String, Set<String>> cercles = new TreeMap<>();
        fleches.forEach((de, vers) -> vers.forEach(n -> {
            Set<String> atteints = new TreeSet<>();
            atteindre(n, fleches, atteints);
            if (atteints.contains(de)) {
                cercles.computeIfAbsent(de, c -> new TreeSet<>()).add(n);
            }
        }));
        return cercles;
    }

    private static void atteindre(String n, Map<String, Set<String>> fleches, Set<String> atteints) {
        if (atteints.add(n)) {
            fleches.getOrDefault(n, Collections.emptySet()).forEach(suivant -> atteindre(suivant, fleches, atteints));
        }
    }
}
