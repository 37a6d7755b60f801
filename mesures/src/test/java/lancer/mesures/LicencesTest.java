package lancer.mesures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.util.Scanner;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Les licences de ce qui n'est pas de nous. */
class LicencesTest {

    /** Les archives du chemin des classes qui ne servent qu'aux tests, ou sont de ce projet. */
    private static final String A_PART = "junit-.*|opentest4j|apiguardian-api|lancer.*|brume.*|blinn.*|antialias.*|surefire.*";

    private static Set<String> bibliotheques() {
        Set<String> noms = new TreeSet<>();
        // Surefire met le vrai chemin dans cette propriété
        String chemin = System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
        for (String element : chemin.split(Pattern.quote(File.pathSeparator))) {
            String nom = new File(element).getName().replaceFirst("(-[0-9][0-9.]*)?\\.jar$", "");
            if (element.endsWith(".jar") && !nom.matches(A_PART)) {
                noms.add(nom);
            }
        }
        return noms;
    }

    @Test
    void chaqueBibliothequeEmbarqueeALesSiennesDansLArchive() {
        Set<String> dites = new TreeSet<>();
        try (Scanner lignes = new Scanner(getClass().getResourceAsStream("/META-INF/licences/LISEZMOI.txt"), "UTF-8")) {
            while (lignes.hasNextLine()) {
                String ligne = lignes.nextLine();
                Matcher m = Pattern.compile("(\\S+) {2,}\\S.* {2,}(\\S+)( et (\\S+))?").matcher(ligne);
                if (m.matches()) {
                    dites.add(m.group(1));
                    assertNotNull(getClass().getResource("/" + m.group(2)), ligne);
                    assertTrue(m.group(4) == null || getClass().getResource("/" + m.group(4)) != null, ligne);
                }
            }
        }
        assertEquals(bibliotheques(), dites);
    }
}
