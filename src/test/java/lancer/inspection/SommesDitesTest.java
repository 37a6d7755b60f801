package lancer.inspection;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import lancer.essai.Essai;
import lancer.essai.Modification;
import lancer.essai.Sommes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Le récit d'un contact donne sa couleur, ou dit ce qu'il n'en connaît pas, quoi qu'un étudiant change dans les classes du cours. */
class SommesDitesTest {

    private static final String KE = "new Couleur(0.1, 0.02, 0.3)";
    private static final String SCENE = "scenes/scene1.ini";
    private static final String[] PIXELS = {"60,55", "31,62", "88,49", "12,80", "70,70", "45,30", "30,80", "60,85", "100,75", "50,60"};

    @TempDir
    Path dossier;

    private static String recits(Essai.Isole programme, String scene) {
        return Arrays.stream(PIXELS).map(pixel -> {
            Essai dit = programme.executer("--taille", "120x90", "--pixel", pixel, scene);
            assertEquals(0, dit.code, dit.toString());
            return dit.sortie;
        }).collect(Collectors.joining());
    }

    private String modifier(String ancienne, String nouvelle) throws IOException {
        try (Essai.Isole programme = Modification.de(dossier, "Objet3D", ancienne, nouvelle)) {
            return recits(programme, SCENE);
        }
    }

    private static String tel() throws IOException {
        try (Essai.Isole programme = new Essai.Isole(Collections.<Path>emptyList())) {
            return recits(programme, SCENE);
        }
    }

    /** Les lignes de ce récit qui commencent ainsi. */
    private static List<String> lignes(String recit, String debut) {
        return Arrays.stream(recit.split("\\R")).filter(ligne -> ligne.startsWith(debut)).collect(Collectors.toList());
    }

    @Test
    void uneEmissionAjouteeALaSommeRendueEstCeQueLeRecitNeConnaitPas() throws IOException {
        List<double[]> autres = Sommes.de(modifier("return lumiere.getCouleur()", "return lumiere.getCouleur().add(" + KE + ")"));
        assertTrue(autres.size() > 10, autres.size() + " contacts");
        autres.forEach(autre -> assertArrayEquals(new double[] {0.1, 0.02, 0.3}, autre, 1e-15));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "avant les lampes | new Lumiere(scene.getModele(), N, R); | new Lumiere(scene.getModele(), N, R); lumiere.ajouter(KE);",
        "avant chaque lampe | Vecteur versLampe = | lumiere.ajouter(KE); Vecteur versLampe =",
        "avec chaque apport | lumiere.ajouter(apport); | lumiere.ajouter(KE); lumiere.ajouter(apport);",
        "après chaque apport | lumiere.ajouter(apport); | lumiere.ajouter(apport); lumiere.ajouter(KE);",
        "après les lampes | if (profondeur > 0 | lumiere.ajouter(KE); if (profondeur > 0",
        "avant le reflet | Rayon reflechi = | lumiere.ajouter(KE); Rayon reflechi =",
        "après le reflet | return lumiere.getCouleur() | lumiere.ajouter(KE); return lumiere.getCouleur()"})
    void unTermeAjouteSeDitASaPlaceEtLesLampesRestentCeQuEllesSont(String quand, String ancienne, String nouvelle) throws IOException {
        String recit = modifier(ancienne, nouvelle.replace("KE", KE));
        List<double[]> autres = Sommes.de(recit);
        assertTrue(autres.size() > 10, autres.size() + " contacts");
        autres.forEach(autre -> assertNull(autre));
        List<String> ajoutes = lignes(recit, "  autre terme = ");
        assertTrue(ajoutes.size() > 5, ajoutes.size() + " termes");
        ajoutes.forEach(terme -> assertEquals("  autre terme = 0.1 0.02 0.3", terme));
        assertEquals(lignes(tel(), "  [Lampe"), lignes(recit, "  [Lampe"));
        assertTrue(!recit.contains("ne donne pas"), recit);
        assertEquals(lignes(tel(), "    diffus"), lignes(recit, "    diffus"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "Couleur KL = lampe.getCouleur() | .div(versLampe.norme2()) | '    diffus : Kd \\(.*\\) ⊗ .* × N·L \\S+ ne donne pas .*'",
        "lumiere.ajouter(apport | .div(versLampe.norme2()) | '  \\[Lampe.* éclairée : diffus \\+ reflet ne donne pas .*'",
        "scene.getModele().getSpecularite().eclat(V, N, L, R, ns) | * 0.5 | '    reflet : Ks \\(.*\\) ⊗ .* ne donne pas .*'",
        "Ks.mul(scene.getCouleurVue(reflechi, this, profondeur - 1) | .mul(0.5) | '  Ks \\(.*\\) ⊗ somme \\d+ ne donne pas .*'"})
    void unProduitQueSesFacteursNeDonnentPasLeDit(String facteur, String affaibli, String dit) throws IOException {
        String recit = modifier(facteur, facteur + " " + affaibli);
        List<double[]> autres = Sommes.de(recit);
        assertTrue(autres.size() > 10, autres.size() + " contacts");
        autres.forEach(autre -> assertNull(autre));
        long dits = Arrays.stream(recit.split("\\R")).filter(ligne -> ligne.matches(dit)).count();
        assertTrue(dits > 5, dits + " lignes : " + recit);
        List<String> lampes = lignes(tel(), "  [Lampe").stream().map(SommesDitesTest::sort).collect(Collectors.toList());
        assertEquals(lampes, lignes(recit, "  [Lampe").stream().map(SommesDitesTest::sort).collect(Collectors.toList()));
    }

    private static String sort(String lampe) {
        return lampe.replaceFirst("^.*  (?=\\S)", "").replaceFirst(" : .*", "");
    }

    @Test
    void unRefletQuePersonneNePeseSeDitQuandMeme() throws IOException {
        String recit = modifier("if (lumiere.vautUnReflet(produitKs))", "");
        Sommes.de(recit).forEach(autre -> assertNull(autre));
        assertTrue(lignes(recit, "    poids").stream().allMatch(ligne -> ligne.endsWith(" : inconnu")), recit);
        assertEquals(lignes(tel(), "  Ks (").get(0), lignes(recit, "  Ks (").get(0));
    }

    @Test
    void uneLampeQuiNEstNiCacheeNiAjouteeNePasseNiPourLUneNiPourLAutre() throws IOException {
        String recit = modifier("lumiere.ajouter(apport)", "if (apport.r > 1) lumiere.ajouter(apport)");
        Sommes.de(recit).forEach(autre -> assertNull(autre));
        assertEquals(lignes(tel(), "  [Lampe").stream().filter(ligne -> ligne.contains("cachée par")).count(),
                lignes(recit, "  [Lampe").stream().filter(ligne -> ligne.contains("cachée par")).count());
        assertTrue(lignes(recit, "  [Lampe").stream().filter(ligne -> ligne.endsWith("pas ajoutée")).count() > 5, recit);
    }
}
