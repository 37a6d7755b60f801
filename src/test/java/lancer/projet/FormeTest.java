package lancer.projet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystems;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.nio.file.Paths;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** La forme des sources, de tous les modules : celle que {@code .editorconfig} demande aux éditeurs. */
class FormeTest {

    private static final Path RACINE = Paths.get("");
    private static final List<Path> FICHIERS = new ArrayList<>();
    private static final Pattern LIEN = Pattern.compile("\\]\\(([^)\\s]+)\\)|(?:src|href)=\"([^\"]+)\"");

    /** Chaque section de {@code .editorconfig} : à quels fichiers elle s'applique, et ce qu'elle en dit. */
    private static final Map<PathMatcher, Map<String, String>> SECTIONS = new LinkedHashMap<>();

    @BeforeAll
    static void lire() throws IOException {
        Map<String, String> section = new HashMap<>();
        for (String ligne : Files.readAllLines(RACINE.resolve(".editorconfig"))) {
            if (ligne.startsWith("[")) {
                String noms = ligne.substring(1, ligne.lastIndexOf(']'));
                section = new HashMap<>();
                // un motif sans barre vaut dans tous les dossiers
                SECTIONS.put(FileSystems.getDefault().getPathMatcher("glob:" + (noms.contains("/") ? noms : "{**/,}" + noms)), section);
            } else if (ligne.contains("=")) {
                section.put(ligne.substring(0, ligne.indexOf('=')).trim(), ligne.substring(ligne.indexOf('=') + 1).trim());
            }
        }
        Files.walkFileTree(RACINE.toAbsolutePath(), new SimpleFileVisitor<Path>() {
            @Override
            public FileVisitResult preVisitDirectory(Path dossier, BasicFileAttributes a) {
                String nom = dossier.getFileName().toString();
                return nom.equals("target") || nom.startsWith(".") && !nom.equals(".ci")
                        ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFile(Path fichier, BasicFileAttributes a) {
                if (fichier.getFileName().toString().matches(".*\\.(java|xml|md|mk|sh)|Makefile|run")) {
                    FICHIERS.add(RACINE.toAbsolutePath().relativize(fichier));
                }
                return FileVisitResult.CONTINUE;
            }
        });
    }

    /** Ce qui est demandé de ce fichier : la dernière section qui le dise. */
    private static Map<String, String> demande(Path fichier) {
        Map<String, String> demande = new HashMap<>();
        SECTIONS.forEach((motif, section) -> {
            if (motif.matches(fichier)) {
                demande.putAll(section);
            }
        });
        return demande;
    }

    private static List<String> fautes(Path fichier, Map<String, String> demande) throws IOException {
        List<String> fautes = new ArrayList<>();
        if ("unset".equals(demande.get("charset"))) {
            return fautes; // rien n'en est demandé, exprès
        }
        String texte;
        try {
            texte = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(Files.readAllBytes(fichier))).toString()
                    .replace("\r\n", "\n");
        } catch (CharacterCodingException e) {
            return Collections.singletonList(fichier + " : pas de l'UTF-8");
        }
        if (!texte.endsWith("\n") || texte.endsWith("\n\n")) {
            fautes.add(fichier + " : la dernière ligne n'est pas finie, ou est vide");
        }
        String[] lignes = texte.split("\n");
        String max = demande.getOrDefault("max_line_length", "off");
        for (int k = 0; k < lignes.length; k++) {
            String ligne = lignes[k];
            String ou = fichier + ":" + (k + 1) + " : ";
            if (ligne.matches(".*[ \t]")) {
                fautes.add(ou + "des blancs au bout");
            }
            if (ligne.startsWith(demande.get("indent_style").equals("tab") ? " " : "\t")) {
                fautes.add(ou + "retrait qui n'est pas fait de " + demande.get("indent_style"));
            }
            if (!max.equals("off") && ligne.codePointCount(0, ligne.length()) > Integer.parseInt(max)) {
                fautes.add(ou + "plus de " + max + " colonnes");
            }
        }
        return fautes;
    }

    @Test
    void lesSourcesOntLaFormeQueDitEditorconfig() throws IOException {
        List<String> fautes = new ArrayList<>();
        for (Path fichier : FICHIERS) {
            fautes.addAll(fautes(fichier, demande(fichier)));
        }
        assertTrue(FICHIERS.contains(Paths.get("src/main/java/lancer/Main.java")), "les sources ne sont pas là");
        assertEquals("", String.join("\n", fautes));
    }

    @Test
    void leCodeDeLaBaseEtDesVariantesTientEnCentVingtColonnesEtLeResteEnCentQuarante() {
        for (String principal : new String[] {"src/main/java/lancer/Main.java", "src/main/java/lancer/auto/Auto.java",
            "brume/src/main/java/lancer/brume/Brume.java", "nuit/src/main/java/lancer/nuit/Nuit.java"}) {
            assertEquals("120", demande(Paths.get(principal)).get("max_line_length"), principal);
        }
        for (String autre : new String[] {"src/test/java/lancer/Tests.java", "mesures/src/main/java/lancer/mesures/Gabarit.java"}) {
            assertEquals("140", demande(Paths.get(autre)).get("max_line_length"), autre);
        }
        assertFalse(demande(Paths.get("README.md")).containsKey("max_line_length"));
    }

    @Test
    void uneClasseOuUneMethodeQueNommeUnePageExiste() throws IOException {
        Map<String, String> sources = new HashMap<>();
        for (Path fichier : FICHIERS) {
            String nom = fichier.getFileName().toString();
            // deux modules ont une classe Scene
            sources.merge(nom.replace(".java", ""), nom.endsWith(".java")
                    ? new String(Files.readAllBytes(RACINE.resolve(fichier)), StandardCharsets.UTF_8) : "", String::concat);
        }
        List<String> fautes = new ArrayList<>();
        Pattern nomme = Pattern.compile("`(?:lancer\\.[a-z.]*)?([A-Z][a-z]\\w{2,})(?:\\.([a-z]\\w+))?[^`]*`");
        int noms = 0;
        for (Path fichier : FICHIERS) {
            Matcher m = nomme.matcher(fichier.toString().endsWith(".md") && !fichier.startsWith("correction/src")
                    ? new String(Files.readAllBytes(RACINE.resolve(fichier)), StandardCharsets.UTF_8) : "");
            while (m.find()) {
                noms++;
                String source = sources.get(m.group(1));
                boolean existe = source != null && (m.group(2) == null || source.isEmpty()
                        || Pattern.compile("\\b" + m.group(2) + "\\b").matcher(source).find());
                if (!existe && !deJava(m.group(1))) {
                    fautes.add(fichier + " : " + m.group());
                }
            }
        }
        assertTrue(noms > 50, noms + " noms de classes");
        assertEquals("", String.join("\n", fautes));
    }

    private static boolean deJava(String classe) {
        try {
            Class.forName("java.lang." + classe);
            return true;
        } catch (ClassNotFoundException e) {
            return false;
        }
    }

    /** Une ligne qui commence par un commentaire se lit comme du HTML : elle coupe son paragraphe, et n'a plus de liens. */
    @Test
    void aucuneLigneDeTexteDUnePageNeCommenceParUneMarque() throws IOException {
        List<String> fautes = new ArrayList<>();
        for (Path fichier : FICHIERS) {
            if (fichier.toString().endsWith(".md")) {
                for (String ligne : Files.readAllLines(RACINE.resolve(fichier))) {
                    if (ligne.matches(" *<!--v:.*?-->.+")) {
                        fautes.add(fichier + " : " + ligne);
                    }
                }
            }
        }
        assertEquals("", String.join("\n", fautes));
    }

    @Test
    void leReadmeTientEnDeuxPages() throws IOException {
        List<String> lignes = Files.readAllLines(RACINE.resolve("README.md"));
        assertTrue(lignes.size() <= 110, lignes.size() + " lignes");
        int mots = String.join(" ", lignes).trim().split("\\s+").length;
        assertTrue(mots <= 1300, mots + " mots");
    }

    /** Fichiers et titres : le nom d'un titre dans une adresse est celui que lui donne GitHub. */
    @Test
    void chaqueLienDUnePageMeneQuelquePart() throws IOException {
        List<String> perdus = new ArrayList<>();
        for (Path page : FICHIERS) {
            // le projet que reçoivent les étudiants n'est pas à sa place ici
            if (page.toString().endsWith(".md") && !page.startsWith("correction")) {
                String texte = new String(Files.readAllBytes(RACINE.resolve(page)), StandardCharsets.UTF_8);
                Matcher lien = LIEN.matcher(texte.replaceAll("(?m)^    .*$|`[^`\n]*`", ""));
                while (lien.find()) {
                    String adresse = lien.group(1) == null ? lien.group(2) : lien.group(1);
                    if (!adresse.matches("https?:.*") && !mene(RACINE.toAbsolutePath().resolve(page), adresse)) {
                        perdus.add(page + " : " + adresse);
                    }
                }
            }
        }
        assertEquals("", String.join("\n", perdus));
    }

    private static boolean mene(Path page, String adresse) throws IOException {
        String[] parts = adresse.split("#", 2);
        Path but = parts[0].isEmpty() ? page : page.resolveSibling(parts[0]).normalize();
        if (parts.length == 1 || !Files.isRegularFile(but)) {
            return parts.length == 1 && Files.exists(but);
        }
        return Files.readAllLines(but).stream().filter(l -> l.matches("#+ .*"))
                .map(l -> l.replaceAll("^#+ ", "").toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{N}_ -]", "").replace(' ', '-'))
                .anyMatch(parts[1]::equals);
    }

    /** Chaque paquet de la maison : la variante d'un étudiant n'y est pas tenue. */
    @Test
    void chaquePaquetDitCeQuiYVit() {
        List<String> sans = new ArrayList<>();
        for (Path fichier : FICHIERS) {
            if (fichier.toString().replace('\\', '/').matches("((brume|blinn|antialias|mesures|correction)/)?src/main/java/.*")
                    && !FICHIERS.contains(fichier.resolveSibling("package-info.java"))
                    && !sans.contains(fichier.getParent().toString())) {
                sans.add(fichier.getParent().toString());
            }
        }
        assertEquals(Collections.emptyList(), sans);
    }
}
