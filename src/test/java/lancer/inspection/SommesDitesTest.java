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

    /** Une émission, quel que soit le moment où elle s'ajoute. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "Couleur couleur = new Couleur(); | Couleur couleur = KE;",
        "if (profondeur > 0 | couleur = couleur.add(KE); if (profondeur > 0",
        "return couleur; | return couleur.add(KE);"})
    void unTermeDePlusEstCeQueLeRecitNeConnaitPas(String ancienne, String nouvelle) throws IOException {
        String recit = modifier(ancienne, nouvelle.replace("KE", KE));
        List<double[]> autres = Sommes.de(recit);
        assertTrue(autres.size() > 10, autres.size() + " contacts");
        autres.forEach(autre -> assertArrayEquals(new double[] {0.1, 0.02, 0.3}, autre, 1e-15));
        assertEquals(lignes(tel(), "  [Lampe"), lignes(recit, "  [Lampe"));
    }

    /** Les couleurs des lignes qui commencent ainsi. */
    private static List<String> couleurs(String recit, String debut) {
        return Arrays.stream(recit.split("\\R")).filter(ligne -> ligne.matches(debut + "\\S.*"))
                .map(ligne -> ligne.replaceFirst("^" + debut + "(?=\\S)", "").replaceFirst("( =| :).*", "")).collect(Collectors.toList());
    }

    /** Les lampes se disent comme avant : leurs termes, et « autre », donnent donc la couleur. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "diffusion.mul(KL).mul(cosinus) | diffusion.mul(KL)",
        "Ks.mul(KL).mul(eclat) | Ks.mul(KL)",
        "couleur = couleur.add(apport) | couleur = couleur.add(apport.div(versLampe.norme2()))",
        "couleur = couleur.add(apport) | couleur = apport",
        "couleur = couleur.add(apport) | if (apport.r > 1) couleur = couleur.add(apport)",
        "&& !scene.estCachee(lampe, contact, L, versLampe.norme(), this) | ",
        "N.dot(versLampe) > 0 | N.dot(versLampe) < 0",
        "Ks.mul(vue) | vue",
        "scene.getCouleurVue(reflechi, this, profondeur - 1) | scene.getCouleurVue(reflechi, this, 0)",
        "Ks.mul(vue) | Ks",
        "profondeur > 0 && | profondeur > 9 &&",
        "return couleur; | return new Couleur(couleur.b, couleur.v, couleur.r);"})
    void unFacteurOuUnTermeOublieEstCeQueLeRecitNeConnaitPas(String ancienne, String nouvelle) throws IOException {
        String recit = modifier(ancienne, nouvelle == null ? "" : nouvelle);
        long autres = Sommes.de(recit).stream().filter(autre -> autre != null).count();
        assertTrue(autres > 2, autres + " contacts : " + recit);
        assertEquals(lignes(tel(), "  [Lampe"), lignes(recit, "  [Lampe"));
        assertEquals(autres, lignes(recit, "  autre = ").size());
        assertEquals(0, lignes(recit, "autre = ").size(), recit);
        // sans air, la couleur du premier contact est celle du pixel
        assertEquals(couleurs(recit, "somme "), couleurs(recit, "1  .*  "));
    }

    @Test
    void uneReflexionDevieeEstSuivie() throws IOException {
        String recit = modifier("return V.add(-2 * V.dot(N), N)", "return V.add(-1.5 * V.dot(N), N)");
        List<double[]> autres = Sommes.de(recit);
        assertTrue(autres.size() > 10, autres.size() + " contacts");
        autres.forEach(autre -> assertNull(autre));
        assertTrue(!lignes(tel(), "    R = ").equals(lignes(recit, "    R = ")), recit);
    }

    @Test
    void ceQuiChangeApresGetColorEstCeQueLeRecitNeConnaitPas() throws IOException {
        String recit;
        String ancienne = "atelier.verifier(couleur,";
        try (Essai.Isole programme = Modification.de(dossier, "Lancer", ancienne, "atelier.verifier(couleur.add(" + KE + "),")) {
            recit = recits(programme, SCENE);
        }
        Sommes.de(recit).forEach(autre -> assertNull(autre));
        List<String> autres = lignes(recit, "autre = ");
        assertEquals(PIXELS.length, autres.size(), recit);
        for (String autre : autres) {
            double[] nombres = Arrays.stream(autre.split(" ")).skip(2).limit(3).mapToDouble(Double::parseDouble).toArray();
            assertArrayEquals(new double[] {0.1, 0.02, 0.3}, nombres, 1e-15);
        }
    }
}
