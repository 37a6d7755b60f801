package lancer.correction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** Le programme achevé, une faute à la fois ({@code etapes.txt}) : « make test » envoie à la méthode fautive. */
class EtapesTest {

    private static final Pattern SUIVANTE =
            Pattern.compile("(?m)^L'étape suivante : (\\d)\\. .* ; à (?:reprendre|compléter) : (\\w+)\\.java:(\\d+)$");

    /** Des fautes qui se voient plus ou moins selon les valeurs : elles arrondissent, ou ne changent rien là où un rayon vaut 1. */
    private static final Set<String> SELON_LES_VALEURS = Set.of("dot-en-entier", "norme2-en-entier", "rayon-sans-carre",
            "centre-oublie", "ombre-par-equals", "ombre-par-la-distance-egale",
            "ombre-par-la-distance-egale-ou-rien");

    @TempDir
    static Path dossier;

    /** Une faute, et ce qu'on en attend. */
    static final class Faute {

        final String nom;
        final String etape;
        final String classe;
        /** L'étape où un étudiant la fait. */
        final int faite;
        final String methode;
        /** Ce que nomme la première ligne. */
        final String cause;
        final Programme programme;

        private Faute(String titre, Programme programme) {
            this.programme = programme;
            String[] mots = titre.split(" = ")[0].split(" ", 3);
            nom = mots[0];
            etape = mots[1].substring(0, 1);
            faite = Integer.parseInt(mots[1].replaceFirst("./", ""));
            classe = mots[2].substring(0, mots[2].indexOf('.'));
            methode = mots[2].substring(classe.length() + 1);
            cause = titre.contains(" = ") ? titre.split(" = ")[1] : "";
        }

        /** Ce qui manque à ce bilan pour mener à la faute, vide si rien n'y manque. */
        String ecart(String bilan) {
            Matcher suivante = SUIVANTE.matcher(bilan);
            if (!suivante.find() || !suivante.group(2).equals(classe)) {
                return "une autre classe";
            }
            boolean laMethode = (" " + programme.methode(classe, Integer.parseInt(suivante.group(3)))).contains(" " + methode);
            String premier = bilan.split("\n\n")[1];
            return !laMethode ? "une autre méthode" : !etape.equals(suivante.group(1)) ? "une autre étape"
                    : premier.contains(cause) ? "" : "une autre cause";
        }

        private Set<String> desSiennes(Map<String, String> rates) {
            return rates.keySet().stream().filter(v -> v.startsWith(classe + ".")).collect(Collectors.toSet());
        }
    }

    /** @param enChemin vrai si chacune est faite par qui en est à son étape, et n'a encore rien écrit de la suite */
    private static List<Faute> fautes(Path dossier, boolean enChemin) throws IOException {
        List<Faute> fautes = new ArrayList<>();
        for (String[] parts : ClasseEssai.blocs("etapes.txt")) {
            Faute faute = new Faute(parts[0], new Programme(dossier));
            Matcher m = Pattern.compile("(?m)^(\\w+)$|^-(.*)\n((?:\\+.*\n?)+)").matcher(parts[1]);
            String classe = "";
            while (m.find()) {
                if (m.group(1) != null) {
                    classe = m.group(1);
                } else {
                    faute.programme.changer(classe, m.group(2), m.group(3).replaceAll("(?m)^\\+", "").replaceFirst("\n$", ""));
                }
            }
            fautes.add(faute);
            if (enChemin) {
                faute.programme.couper(faute.faite);
            }
        }
        return fautes;
    }

    /** Les graines du correcteur : vingt si l'on demande les tests longs. */
    private static final int GRAINES = Boolean.getBoolean("tests.longs") ? 20 : 1;

    /**
     * Une faute sur quatre, par qui en est à son étape ou par qui a tout écrit, tour à tour : celles qui se suivent sont de la même étape.
     * Toutes, et par les deux, avec {@code -Dtests.longs} ; toujours, en chemin, celles dont le nom finit par un point d'exclamation.
     */
    @TestFactory
    List<DynamicTest> chaqueFauteEstDiteLaOuElleEst() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        List<Faute> enChemin = fautes(dossier, true);
        List<Faute> ecrites = fautes(dossier, false);
        assertTrue(ecrites.size() >= 100, ecrites.size() + " fautes");
        for (int k = 0; k < ecrites.size(); k++) {
            if (GRAINES > 1 || k % 8 == 0 || enChemin.get(k).nom.endsWith("!")) {
                Faute faute = enChemin.get(k);
                tests.add(DynamicTest.dynamicTest(faute.nom + ", en chemin", () -> dite(faute, 0)));
            }
            if (GRAINES > 1 || k % 8 == 5) {
                Faute faute = ecrites.get(k);
                tests.add(DynamicTest.dynamicTest(faute.nom, () -> ditePourChaqueGraine(faute)));
            }
        }
        return tests;
    }

    /** @return les vérifications de sa classe qui ne réussissent pas */
    private static Set<String> dite(Faute faute, long graine) throws Exception {
        Programme.Rates rates = new Programme.Rates();
        String dit = faute.programme.bilan(graine, rates);
        assertEquals("", faute.ecart(dit), faute.nom + ", graine " + graine + " " + dit);
        return faute.desSiennes(rates.pourquoi);
    }

    /** Seules les vérifications de sa classe lui coûtent, les mêmes qu'avec les valeurs publiques ; les autres sont dites cachées. */
    private static void ditePourChaqueGraine(Faute faute) throws Exception {
        Set<String> publiques = faute.desSiennes(faute.programme.rates(0));
        Set<String> tirees = dite(faute, 1 + faute.nom.length());
        if (!SELON_LES_VALEURS.contains(faute.nom)) {
            assertEquals(publiques, tirees, faute.nom);
        }
        for (long graine = 1; graine < GRAINES; graine++) {
            dite(faute, graine);
        }
    }

    @Test
    void lesEtapesQueLOnNAPasCommenceesApresLambertSontACommencer() throws Exception {
        String dit = new Programme(dossier).changer("Objet3D", "couleur.add(diffus).add(speculaire)", "couleur.add(diffus)")
                .changer("Objet3D", "&& !estALOmbre(scene, lampe, contact)", "")
                .changer("Objet3D", "if (profondeur > 0)", "if (profondeur > 1000)").bilan();
        assertTrue(dit.matches("(?s).*\n6\\. [^\n]*/7 ; à commencer : pour l'instant, Ks et ns[^\n]*\n7\\. [^\n]*/7 ; à commencer : "
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
