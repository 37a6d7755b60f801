package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** Le programme achevé, une faute à la fois ({@code etapes.txt}) : « make test » envoie à la méthode fautive. */
class EtapesTest {

    private static final Pattern SUIVANTE =
            Pattern.compile("(?m)^L'étape suivante : (\\d)\\. .* ; à (?:reprendre|compléter) : (\\w+)\\.java:(\\d+)$");

    @TempDir
    static Path dossier;

    /** Une faute, et ce qu'on en attend. */
    static final class Faute {

        final String nom;
        final String etape;
        final String classe;
        final String methode;
        final Programme programme;

        private Faute(String titre, Programme programme) {
            this.programme = programme;
            String[] mots = titre.split(" ", 3);
            nom = mots[0];
            etape = mots[1];
            classe = mots[2].substring(0, mots[2].indexOf('.'));
            methode = mots[2].substring(classe.length() + 1);
        }
    }

    static List<Faute> fautes(Path dossier) throws IOException {
        List<Faute> fautes = new ArrayList<>();
        for (String bloc : Files.readString(ClasseEssai.RENDUS.resolve("etapes.txt")).replaceAll("(?m)^#.*\n", "").trim().split("\n\n")) {
            String[] parts = bloc.split("\n", 3);
            Faute faute = new Faute(parts[0], new Programme(dossier));
            Matcher m = Pattern.compile("(?m)^-(.*)\n((?:\\+.*\n?)+)").matcher(parts[2]);
            while (m.find()) {
                faute.programme.changer(parts[1], m.group(1), m.group(2).replaceAll("(?m)^\\+", "").replaceFirst("\n$", ""));
            }
            fautes.add(faute);
        }
        return fautes;
    }

    @TestFactory
    List<DynamicTest> chaqueFauteEstDiteLaOuElleEst() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        for (Faute faute : fautes(dossier)) {
            tests.add(DynamicTest.dynamicTest(faute.nom, () -> {
                String dit = faute.programme.bilan();
                Matcher suivante = SUIVANTE.matcher(dit);
                assertTrue(suivante.find(), dit);
                assertEquals(faute.classe, suivante.group(2), dit);
                String methode = faute.programme.methode(faute.classe, Integer.parseInt(suivante.group(3)));
                assertTrue(methode.contains(" " + faute.methode), methode + dit);
                assertEquals(faute.etape, suivante.group(1), dit);
                assertTrue(!faute.nom.equals("comparaison-a-l-envers")
                        || dit.contains("; à reprendre d'abord : getClosestIntersection : la plus proche"), dit);
            }));
        }
        assertTrue(tests.size() >= 50, tests.size() + " fautes");
        return tests;
    }

    @Test
    void lesEtapesQueLOnNAPasCommenceesApresLambertSontACommencer() throws Exception {
        String dit = new Programme(dossier).changer("Objet3D", "couleur.add(diffus).add(speculaire)", "couleur.add(diffus)")
                .changer("Objet3D", "&& !estALOmbre(scene, lampe, contact)", "")
                .changer("Objet3D", "couleur = couleur.add(Ks.mul(reflet));", "").bilan();
        assertTrue(dit.matches("(?s).*\n6\\. [^\n]*/7 ; à commencer : pour l'instant, Ks et ns[^\n]*\n7\\. [^\n]*/6 ; à commencer : "
                + "pour l'instant, une boule entre[^\n]*\n8\\. [^\n]*/8 ; à commencer : pour l'instant, la profondeur.*"
                + "L'étape suivante : 6\\. [^\n]* ; à compléter : Objet3D\\.java:\\d+\n.*") && !dit.contains("à reprendre"), dit);
    }

    @Test
    void unSigneFauxDePhongEstRateEtNonPasACommencer() {
        for (String[] faute : new String[][] {{"R.dot(L)", "-R.dot(L)"}, {"V.sub(N.mul(2 * N.dot(V)))", "V.add(N.mul(2 * N.dot(V)))"},
            {"R.dot(L)", "new Vecteur(-R.x, R.y, -R.z).dot(L)"}}) {
            Map<String, String> rates = new Programme(dossier).changer("Objet3D", faute[0], faute[1]).rates(0);
            assertTrue(rates.size() >= 3 && rates.values().stream().noneMatch(r -> r.contains("étape non commencée")), rates.toString());
        }
    }
}
