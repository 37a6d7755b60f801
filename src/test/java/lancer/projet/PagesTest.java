package lancer.projet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.essai.Ressources;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Ce que nomment les pages existe. */
class PagesTest {

    private static final Pattern LIEN = Pattern.compile("\\]\\(([^)\\s]+)\\)|(?:src|href)=\"([^\"]+)\"");

    /** Le texte de chaque page, et de chaque fichier dont le nom peut être celui d'une classe. */
    private static final Map<Path, String> PAGES = new HashMap<>();
    private static final Map<String, String> SOURCES = new HashMap<>();

    @BeforeAll
    static void lire() throws IOException {
        Path racine = Paths.get("").toAbsolutePath();
        for (Path fichier : Ressources.fichiers(racine, dossier -> !dossier.getFileName().toString().matches("target|\\..*"))) {
            String nom = fichier.getFileName().toString();
            if (nom.matches(".*\\.(java|xml|md)|Makefile")) {
                String texte = new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
                // deux modules ont une classe Scene
                SOURCES.merge(nom.replace(".java", ""), nom.endsWith(".java") ? texte : "", String::concat);
                // le projet que reçoivent les étudiants n'est pas à sa place ici
                if (nom.endsWith(".md") && !racine.relativize(fichier).startsWith("correction")) {
                    PAGES.put(fichier, texte);
                }
            }
        }
    }

    @Test
    void uneClasseOuUneMethodeQueNommeUnePageExiste() {
        List<String> fautes = new ArrayList<>();
        Pattern nomme = Pattern.compile("`(?:lancer\\.[a-z.]*)?([A-Z][a-z]\\w{2,})(?:\\.([a-z]\\w+))?[^`]*`");
        int noms = 0;
        for (Map.Entry<Path, String> page : PAGES.entrySet()) {
            for (Matcher m = nomme.matcher(page.getValue()); m.find(); noms++) {
                String source = SOURCES.get(m.group(1));
                boolean existe = source != null && (m.group(2) == null || source.isEmpty()
                        || Pattern.compile("\\b" + m.group(2) + "\\b").matcher(source).find());
                if (!existe && !deJava(m.group(1))) {
                    fautes.add(page.getKey() + " : " + m.group());
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

    /** Fichiers et titres : le nom d'un titre dans une adresse est celui que lui donne GitHub. */
    @Test
    void chaqueLienDUnePageMeneQuelquePart() throws IOException {
        List<String> perdus = new ArrayList<>();
        for (Map.Entry<Path, String> page : PAGES.entrySet()) {
            Matcher lien = LIEN.matcher(page.getValue().replaceAll("(?m)^    .*$|`[^`\n]*`", ""));
            while (lien.find()) {
                String adresse = lien.group(1) == null ? lien.group(2) : lien.group(1);
                if (!adresse.matches("https?:.*") && !mene(page.getKey(), adresse)) {
                    perdus.add(page.getKey() + " : " + adresse);
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
}
