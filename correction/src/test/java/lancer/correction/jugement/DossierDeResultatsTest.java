package lancer.correction.jugement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lancer.correction.Panne;
import lancer.correction.depot.Rendu;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les résultats écrits, quoi qu'il y ait dans l'un d'eux. */
class DossierDeResultatsTest {

    @TempDir
    Path classe;

    private static GrilleDeNotation grille(String critere) {
        GrilleDeNotation grille = new GrilleDeNotation("");
        grille.ajouter(new Verification("vecteurs", "Vecteurs", critere, "Vecteur", "un titre"));
        return grille;
    }

    @Test
    void unResultatQueLOnNePeutEcrireNeCouteQueSaLigne() throws IOException {
        List<Rendu> rendus = new ArrayList<>();
        List<Resultat> resultats = new ArrayList<>();
        for (int k = 0; k < 1005; k++) {
            rendus.add(new Rendu("n" + k, "Élève " + k));
            resultats.add(new Resultat("n" + k, "Élève " + k));
        }
        resultats.get(1).remarques.add(null);
        resultats.get(2).methodes.put("vecteurs.a", "int x; // \ud83e");
        DossierDeResultats.ecrire(classe, grille("a"), rendus, resultats, null);
        List<Resultat> lus = new ArrayList<>(new DossierDeResultats(classe).resultats.values());
        assertEquals(1005, lus.size());
        assertEquals(List.of("ses résultats n'ont pas pu être écrits (java.lang.NullPointerException)"), lus.get(1).refus);
        assertEquals("int x; // ?", lus.get(2).methodes.get("vecteurs.a"));
        assertEquals(List.of("n1003", List.of()), List.of(lus.get(1003).id, lus.get(1003).refus), "dans l'ordre, au-delà de 999");
    }

    @Test
    void desResultatsDUneAutreGrilleNeSeMelentPas() {
        GrilleDeNotation grille = grille("a");
        grille.reprendre(grille("a"));
        assertTrue(assertThrows(Panne.class, () -> grille.reprendre(grille("b"))).getMessage().contains("autre version du programme"));
        grille.reprendre(new GrilleDeNotationSansConfinement().grille);
        assertEquals("sans bwrap", grille.sansConfinement(), "un seul rendu exécuté sans confinement suffit à le dire");
    }

    private static final class GrilleDeNotationSansConfinement {

        private final GrilleDeNotation grille = new GrilleDeNotation("sans bwrap");

        GrilleDeNotationSansConfinement() {
            grille.ajouter(new Verification("vecteurs", "Vecteurs", "a", "Vecteur", "un titre"));
        }
    }

    @Test
    void unDossierInacheveNEffaceRien() throws IOException {
        DossierDeResultats.ecrire(classe, grille("a"), List.of(new Rendu("u", "U")), List.of(new Resultat("u", "U")), null);
        Files.createDirectories(classe.resolve("resultats/à moi"));
        Files.writeString(classe.resolve("resultats/lettre.txt"), "x");
        List<Resultat> autres = List.of(new Resultat("v", "V"));
        List<Rendu> aucun = List.of();
        assertThrows(RuntimeException.class, () -> DossierDeResultats.ecrire(classe, grille("a"), aucun, autres, null));
        assertEquals("u", new DossierDeResultats(classe).resultats.get("001-u").id);
        DossierDeResultats.ecrire(classe, grille("a"), List.of(new Rendu("v", "V")), autres, null);
        assertEquals(List.of("001-v"), List.copyOf(new DossierDeResultats(classe).resultats.keySet()));
        assertTrue(Files.exists(classe.resolve("resultats/lettre.txt")) && Files.isDirectory(classe.resolve("resultats/à moi")));
    }
}
