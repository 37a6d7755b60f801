package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lancer.correction.modele.SourcesDuCours;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;

/**
 * Le programme complet avec une faute honnête à la fois ({@code banc.txt}) : la note suit le travail, et la rangée le dit. D'autres fautes
 * des mêmes sortes ({@code banc-long.txt}) sont essayées à leur place avec {@code -Dtests.longs}.
 */
@EnabledForJreRange(min = JRE.JAVA_17)
class BancTest extends ClasseEssai {

    /** Un remplacement, ou un autre pas de la recette d'un rendu. */
    private static final Pattern PAS = Pattern.compile("(?m)((?:^-.*\n)+)((?:^\\+.*\n)*)|^.+$");

    @TempDir
    static Path dossier;

    /** Un rendu : ce qui est demandé de sa note et de sa rangée, et comment le faire du corrigé. */
    private static final class Essai {

        private String nom;
        private double[] note;
        private String dit;
        /** Ce que sa rangée ne doit pas dire. */
        private String tu;
        private Charset codage = StandardCharsets.UTF_8;
        private String recette;
        private final Map<String, Map<String, String>> parties = new LinkedHashMap<>();
        private final Map<String, String> fichiers = new TreeMap<>();
        private Map<String, String> partie;

        /** Remplace un morceau, ou partout un mot. */
        private void remplacer(String classe, String avant, String apres) {
            partie.replaceAll((nom, texte) -> !classe.isEmpty() && !classe.equals(nom) ? texte : texte.replace(avant, apres));
        }

        private void ecrire(Path racine) throws IOException {
            partie = new TreeMap<>();
            SourcesDuCours.A_COMPLETER.forEach(c -> partie.put(c, SourcesDuCours.corrige(c)));
            partie.put("Main", SourcesDuCours.corrige("Main"));
            parties.put("lancer-base", partie);
            Map<String, String> autreNom = new TreeMap<>();
            String classe = "";
            Matcher pas = PAS.matcher(recette);
            while (pas.find()) {
                String ligne = pas.group();
                String[] mots = ligne.split(" ");
                if (ligne.startsWith("-")) {
                    String change = sansSigne(pas.group(1));
                    assertTrue(partie.get(classe).contains(change), nom + " : " + change);
                    remplacer(classe, change, sansSigne(pas.group(2)));
                } else if (mots[0].equals("partout")) {
                    String[] deux = ligne.substring(8).split(ligne.contains(";") ? "(?<=;) " : " ");
                    remplacer("", deux[0], deux[1]);
                } else if (mots[0].equals("donnees")) {
                    SourcesDuCours.DONNEES.forEach(c -> partie.put(c, SourcesDuCours.corrige(c)));
                } else if (mots[0].equals("codage")) {
                    codage = Charset.forName(mots[1]);
                } else if (mots[0].equals("squelette")) {
                    partie.put(mots[1], SourcesDuCours.squelette(mots[1]));
                } else if (mots[0].equals("texte")) {
                    fichiers.put(mots[1], ligne.substring(7 + mots[1].length()).replace("\\n", "\n"));
                } else if (mots[0].equals("fichier")) {
                    fichiers.put("lancer-base/" + mots[1], "");
                } else if (mots[0].equals("copie")) {
                    SourcesDuCours.A_COMPLETER.forEach(c -> fichiers.put(mots[1] + "/lancer/" + c + ".java", SourcesDuCours.squelette(c)));
                } else if (mots[0].equals("brouillon")) {
                    fichiers.put("lancer-base/lancer/" + ligne.substring(11 + mots[1].length()) + ".java",
                            SourcesDuCours.squelette(mots[1]));
                } else if (mots[0].equals("variante")) {
                    partie = new TreeMap<>(partie);
                    parties.put(mots[1], partie);
                } else if (mots.length == 3) {
                    autreNom.put(mots[0], mots[2]);
                } else {
                    classe = mots[0];
                }
            }
            parties.forEach((nomDePartie, classes) -> classes.forEach((c, texte) -> fichiers.put(nomDePartie + "/"
                    + texte.replaceFirst("(?s).*?package ([\\w.]+);.*", "$1").replace('.', '/') + "/" + autreNom.getOrDefault(c, c)
                    + ".java", texte)));
            for (Map.Entry<String, String> fichier : fichiers.entrySet()) {
                Path chemin = racine.resolve(fichier.getKey());
                Files.createDirectories(chemin.getParent());
                Files.writeString(chemin, fichier.getValue(), codage);
            }
        }
    }

    private static List<Essai> lire(String fichier) throws IOException {
        List<Essai> essais = new ArrayList<>();
        for (String[] bloc : blocs(fichier)) {
            String[] moities = bloc[0].split(" [=!] ");
            String[] mots = moities[0].split(" ");
            Essai essai = new Essai();
            essai.nom = mots[0];
            essai.note = new double[] {Double.parseDouble(mots[1]), Double.parseDouble(mots[2])};
            essai.dit = bloc[0].contains(" = ") ? moities[1] : "";
            essai.tu = bloc[0].contains(" ! ") ? moities[1] : "rien de tel";
            essai.recette = bloc[1];
            essais.add(essai);
        }
        return essais;
    }

    private static String sansSigne(String lignes) {
        return lignes.replaceAll("(?m)^[-+]", "").replaceFirst("\n$", "");
    }

    @Tag("long")
    @TestFactory
    List<DynamicTest> laNoteSuitLeTravail() throws IOException {
        List<Essai> essais = lire(Boolean.getBoolean("tests.longs") ? "banc-long.txt" : "banc.txt");
        assertFalse(essais.isEmpty());
        for (Essai essai : essais) {
            essai.ecrire(dossier.resolve("rendus").resolve(essai.nom));
        }
        Map<String, Map<String, String>> classe = noter(dossier.resolve("rendus"), dossier.resolve("notes"));
        String index = Files.readString(dossier.resolve("notes/index.html"));
        List<DynamicTest> verifications = new ArrayList<>();
        for (Essai essai : essais) {
            verifications.add(DynamicTest.dynamicTest(essai.nom, () -> {
                Map<String, String> ligne = classe.get(essai.nom);
                assertFalse(ligne.get("note").isEmpty(), essai.nom + ", sans note : " + ligne);
                double note = Double.parseDouble(ligne.get("note"));
                assertTrue(essai.note[0] <= note && note <= essai.note[1], essai.nom + " : " + ligne);
                String[] rangees = index.split("/" + essai.nom + "\\.html");
                String rangee = ligne.get("à regarder") + rangees[rangees.length - 1].split("<td class=\"vignette\"")[0];
                assertTrue(rangee.contains(essai.dit), essai.nom + " : « " + essai.dit + " » n'est pas dans " + rangee);
                assertFalse(rangee.contains(essai.tu), essai.nom + " : « " + essai.tu + " » est dans " + rangee);
            }));
        }
        return verifications;
    }
}
