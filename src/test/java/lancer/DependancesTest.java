package lancer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lancer.contrat.PixelFautif;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Ce qui dépend de quoi, lu dans les sources : les lignes {@code import}, et les noms complets ailleurs. */
class DependancesTest {

    private static final Path SOURCES = Paths.get("src", "main", "java");

    /** Chaînes et commentaires ne dépendent de rien. */
    private static final Pattern TEXTES = Pattern.compile("\"(\\\\.|[^\"\\\\])*\"|'(\\\\.|[^'\\\\])+'|//[^\n]*|/\\*.*?\\*/",
            Pattern.DOTALL);
    private static final Pattern PAQUET = Pattern.compile("(?m)^package .*?;");
    private static final Pattern NOM = Pattern.compile("(?<![\\w.])(?:java|javax|sun|com|org|lancer)(?:\\.[a-z]\\w*)*\\.[A-Z]\\w*");

    /** De chaque fichier, son code sans commentaire ni chaîne, et les classes qu'il nomme. */
    private static final Map<String, String> CODES = new TreeMap<>();
    private static final Map<String, Set<String>> NOMS = new TreeMap<>();

    @BeforeAll
    static void lireLesSources() throws IOException {
        try (Stream<Path> fichiers = Files.walk(SOURCES)) {
            for (Path fichier : (Iterable<Path>) fichiers.filter(f -> f.toString().endsWith(".java"))::iterator) {
                String texte = new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
                String code = PAQUET.matcher(TEXTES.matcher(texte).replaceAll(" ")).replaceAll("");
                String nom = SOURCES.relativize(fichier).toString().replace(fichier.getFileSystem().getSeparator(), "/");
                CODES.put(nom, code);
                NOMS.put(nom, new TreeSet<>());
                Matcher m = NOM.matcher(code);
                while (m.find()) {
                    NOMS.get(nom).add(m.group());
                }
            }
        }
        assertTrue(CODES.containsKey("lancer/Main.java"), "les sources ne sont pas là : " + SOURCES.toAbsolutePath());
    }

    /** Les fichiers dont le nom est {@code fichiers} ne nomment que des classes dont le nom est {@code permis}. */
    private static void verifier(String fichiers, String permis) {
        Set<String> fautes = new TreeSet<>();
        NOMS.forEach((fichier, noms) -> noms.stream().filter(n -> fichier.matches(fichiers) && !n.matches(permis))
                .forEach(n -> fautes.add(fichier + " nomme " + n)));
        assertEquals(new TreeSet<>(), fautes);
    }

    @Test
    void lesClassesDuCoursNeDependentQueDesContrats() {
        String ducours = "java\\.(?!awt).*|lancer\\.(contrat|precision)\\..*";
        verifier("lancer/(?!Main|Scene|Lancer\\.)\\w+\\.java", ducours);
        verifier("lancer/Lancer\\.java", ducours + "|lancer\\.fils\\.Equipe");
        verifier("lancer/Scene\\.java", "java\\.(?!awt).*|lancer\\.(contrat|lecture|rapide)\\..*");
    }

    @Test
    void lesContratsNeDependentQueDuCours() {
        verifier("lancer/contrat/.*", "java\\.(?!awt).*|lancer\\.[A-Z].*|lancer\\.texte\\..*");
    }

    @Test
    void laCommandeNeDependQueDesTextesEtDesNombres() {
        verifier("lancer/commande/.*", "java\\.(?!awt).*|lancer\\.(Constantes|SceneFautive|contrat\\.PixelFautif)|lancer\\.texte\\..*");
    }

    @Test
    void laRechercheRapideNeSaitRienDesSortiesNiDeLaCommande() {
        verifier("lancer/rapide/.*", "java\\.(?!awt).*|lancer\\.[A-Z].*|lancer\\.(contrat|precision)\\..*|lancer\\.fils\\.Equipe");
        verifier("lancer/fils/.*", "java\\.util\\..*");
    }

    @Test
    void leChoixDesReglagesNeSaitRienDesSortiesNiDesVariantes() {
        verifier("lancer/auto/.*",
                "java\\.(?!awt).*|lancer\\.[A-Z].*|lancer\\.contrat\\..*|lancer\\.commande\\.Options");
        verifier("(?!lancer/(auto/|sortie/VersFichiers\\.java)).*", "(?!lancer\\.auto\\.).*");
    }

    @Test
    void seuleLaFenetreConnaitAwtEtImageIoNeLitQueLesImagesAComparer() {
        String sansAwt = "(?!java\\.awt|javax\\.|sun\\.|com\\.).*";
        verifier("(?!lancer/(fenetre/|sortie/LectureImage\\.java)).*", sansAwt);
        verifier("lancer/sortie/LectureImage\\.java", sansAwt + "|java\\.awt\\.image\\..*|javax\\.imageio\\..*");
        verifier("(?!lancer/(fenetre/|Main\\.java)).*", "(?!lancer\\.fenetre\\.).*");
    }

    @Test
    void seuleLaLectureConnaitIni4jEtNEnPrendQueLeDecoupage() {
        verifier("(?!lancer/lecture/).*", "(?!org\\.ini4j).*");
        verifier(".*", "(?!org\\.).*|org\\.ini4j\\.(Config|InvalidFileFormatException|spi\\.IniHandler|spi\\.IniParser)");
        // la CVE-2022-41404 passe par ces méthodes-là
        CODES.forEach((fichier, code) -> assertFalse(fichier.startsWith("lancer/lecture/")
                && Pattern.compile("\\bfetch\\w*\\s*\\(|\\.\\s*(to|as|from)\\s*\\(").matcher(code).find(), fichier));
    }

    @Test
    void laLectureEtLesSortiesNeSeConnaissentPas() {
        verifier("lancer/lecture/.*", "(?!lancer\\.(sortie|fenetre|commande|rapide)).*");
    }
}
