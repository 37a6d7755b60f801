package lancer.projet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.essai.Essai;
import lancer.essai.Modification;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Chaque changement de la base que montre docs/etendre.md, suivi à la lettre, se compile et change l'image. */
class ChangerLaBaseTest {

    /** Un fichier, l'endroit, et les lignes à y mettre, reculées de quatre blancs. */
    private static final Pattern CHANGEMENT =
            Pattern.compile("Dans `([^`]+)`, (sous|à la place de)\\s`([^`]+)` :\n\n((?: {4}.*\n|\n(?= {4}))+)");

    @TempDir
    Path dossier;

    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', value = {"Une clé de la matière | Ke=0.3 0 0 | --fils=2", "Le ciel | ns=1 | --fils=2"})
    void unePartieDeLaPageSuivieALaLettreChangeLImage(String partie, String cle, String option) throws IOException {
        try (Essai.Isole changee = changee(partie); Essai.Isole base = new Essai.Isole(List.of())) {
            assertFalse(Arrays.equals(dessiner(base, "ns=1", "--fils=2"), dessiner(changee, cle, option)), "l'image n'a pas changé");
        }
    }

    /** La base, où cette partie de la page est suivie à la lettre. */
    private Essai.Isole changee(String partie) throws IOException {
        Map<String, String> textes = new LinkedHashMap<>();
        Matcher m = CHANGEMENT.matcher(Essai.texte("docs/etendre.md").split("\n### " + partie + "\n")[1].split("\n##")[0]);
        while (m.find()) {
            String texte = textes.containsKey(m.group(1)) ? textes.get(m.group(1)) : Essai.texte(m.group(1));
            textes.put(m.group(1), changer(texte, m.group(2).equals("sous"), m.group(3), m.group(4).replaceAll("(?m)^ {4}", "")));
        }
        Map<String, String> classes = new LinkedHashMap<>();
        textes.forEach((fichier, texte) -> {
            if (fichier.endsWith(".java")) {
                assertTrue(Arrays.stream(texte.split("\n")).allMatch(l -> l.length() <= 120), fichier);
                classes.put(fichier.replace(".java", ""), texte);
            }
        });
        return Modification.compilee(dossier, classes);
    }

    /** Ce texte, où ces lignes sont mises sous celle de cet endroit, ou à sa place. */
    private static String changer(String texte, boolean sous, String endroit, String lignes) {
        assumeFalse(texte.contains(lignes.trim()), "ce changement est déjà fait");
        Matcher ligne = Pattern.compile("(?m)^(.*)" + Pattern.quote(endroit) + "(.*)\n").matcher(texte);
        assertTrue(ligne.find(), endroit);
        boolean seul = (ligne.group(1) + ligne.group(2)).trim().isEmpty();
        String nouveau = sous ? ligne.group() + lignes : seul ? lignes : ligne.group(1) + lignes.trim() + ligne.group(2) + "\n";
        return texte.substring(0, ligne.start()) + nouveau + texte.substring(ligne.end());
    }

    private byte[] dessiner(Essai.Isole programme, String cle, String option) throws IOException {
        Path image = dossier.resolve("image.pfm");
        Essai dit = programme.executer("--lineaire", image.toString(), "--taille=8x6", option, scene(cle).toString());
        assertEquals("statut 0, sortie «  », erreur «  »", dit.toString());
        return Files.readAllBytes(image);
    }

    private Path scene(String cle) throws IOException {
        return Essai.scene(dossier.resolve("s.ini"), "[Sphere 1]", "centre=0 0 6", "rayon=1", "Kd=0.5 0.5 0.5", cle,
                "[Lampe 1]", "position=3 3 0", "couleur=1 1 1");
    }
}
