package lancer.atelier;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MutationsTest {

    private static final String NOM = "org.pitest.mutationtest.engine.gregor.mutators.";
    private static final String SCORES = "rond.Cercle : 2 sur 5\ntotal : 2 sur 5\n";
    private static final String LONG = "dont arrêtés, trop longs : 1 (boucle sans fin, ou machine trop chargée)\n";
    private static final String BORNE = "- Cercle.aire, ConditionalsBoundaryMutator ×1, `if (r > 0 || r == 0) {`";
    private static final String CALCUL = "- Cercle.aire, MathMutator ×2, `return 3.14 * r * r;`";
    private static final String RAISON = " : elle est ici";

    @TempDir
    Path module;
    private Path page;
    private Path liste;

    @BeforeEach
    void ecrireUnModule() throws IOException {
        page = module.resolve("page.md");
        liste = module.resolve("liste.md");
        ecrire("liste.md", "# Liste");
        ecrire("src/main/java/rond/Cercle.java", "package rond;", "class Cercle {", "    if (r > 0 || r == 0) {",
                "    return 3.14 * r * r;");
        ecrire("target/pit-reports/mutations.csv",
                "Cercle.java,rond.Cercle," + NOM + "ConditionalsBoundaryMutator,aire,3,SURVIVED,none",
                "Cercle.java,rond.Cercle$Petit," + NOM + "returns.NullReturnValsMutator,rayon,2,TIMED_OUT,none",
                "Cercle.java,rond.Cercle," + NOM + "MathMutator,aire,4,NO_COVERAGE,none",
                "Cercle.java,rond.Cercle," + NOM + "MathMutator,aire,4,SURVIVED,none",
                "Cercle.java,rond.Cercle," + NOM + "MathMutator,aire,4,KILLED,test.[class:x], y");
    }

    private void ecrire(String nom, String... lignes) throws IOException {
        Files.createDirectories(module.resolve(nom).getParent());
        Files.write(module.resolve(nom), Arrays.asList(lignes), StandardCharsets.UTF_8);
    }

    private void verifier(boolean conforme, String suite) throws IOException {
        StringBuilder dit = new StringBuilder();
        assertEquals(conforme, Mutations.verifier(Arrays.asList(page, liste), Collections.singletonList(module), dit));
        assertEquals(SCORES + LONG + suite.replace("PAGE", "[" + page + ", " + liste + "]"), dit.toString());
    }

    @Test
    void unePageEtUneListeQuiDisentLeScoreEtChaqueSurvivantSontConformes() throws IOException {
        ecrire("page.md", "# Page", "```", SCORES + "```", "", BORNE + RAISON);
        ecrire("liste.md", CALCUL + RAISON);
        verifier(true, "");
    }

    @Test
    void unSurvivantQuiNEstPasDansLaPageSEcritCommeIlFaudraitLYMettre() throws IOException {
        ecrire("page.md", SCORES, CALCUL + RAISON, BORNE);
        verifier(false, "manque à PAGE :\n" + BORNE + "\n");
    }

    @Test
    void unSurvivantDeMoinsOuDePlusSurLaMemeLigneEstUnEcart() throws IOException {
        ecrire("page.md", SCORES, CALCUL.replace("×2", "×3") + RAISON, BORNE + RAISON);
        verifier(false, "manque à PAGE :\n" + CALCUL + "\nn'est plus vrai dans PAGE :\n" + CALCUL.replace("×2", "×3") + "\n");
    }

    @Test
    void unScoreQuiNEstPlusLeBonEstUnEcart() throws IOException {
        ecrire("page.md", SCORES.replace("total : 2", "total : 3"), CALCUL + RAISON, BORNE + RAISON);
        verifier(false, "manque à PAGE :\ntotal : 2 sur 5\nn'est plus vrai dans PAGE :\ntotal : 3 sur 5\n");
    }

    @Test
    void sansRapportLaVerificationEchoue() throws IOException {
        ecrire("page.md", SCORES);
        Files.delete(module.resolve("target/pit-reports/mutations.csv"));
        assertThrows(IOException.class, () -> verifier(true, ""));
    }
}
