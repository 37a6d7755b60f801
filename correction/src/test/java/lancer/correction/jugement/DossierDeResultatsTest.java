package lancer.correction.jugement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lancer.correction.Panne;
import lancer.correction.depot.Rendu;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Les résultats écrits, quoi qu'il y ait dans l'un d'eux, et quels que soient ceux qui les écrivent. */
class DossierDeResultatsTest {

    @TempDir
    Path classe;

    private static GrilleDeNotation grille(String critere) {
        GrilleDeNotation grille = new GrilleDeNotation();
        grille.ajouter(new Verification("vecteurs", "Vecteurs", critere, "Vecteur", "un titre"));
        return grille;
    }

    private static Resultat resultat(String id, String source) {
        Rendu rendu = new Rendu(id, id);
        rendu.sources.put("A.java", source.getBytes());
        return new Resultat(rendu, "");
    }

    private List<String> ids() {
        return new DossierDeResultats(classe).resultats().stream().map(r -> r.id).sorted().collect(Collectors.toList());
    }

    @Test
    void unDemiCaractereNEmpechePasDEcrireUnResultat() throws IOException {
        DossierDeResultats dossier = new DossierDeResultats(classe);
        Resultat demi = resultat("b", "");
        demi.methodes.put("vecteurs.a", "int x; // \ud83e");
        dossier.ecrire(demi);
        List<Resultat> lus = dossier.resultats();
        assertEquals("int x; // ?", lus.get(0).methodes.get("vecteurs.a"));
    }

    @Test
    void deuxEntreesNOntJamaisLeMemeFichier() throws IOException {
        List<String> noms = List.of("TP1.zip", "TP1", "TP1%2Ezip", "zoé", "zoe\u0301", "..", ".json", "a/b", "a%2Fb", "é".repeat(120),
                "é".repeat(120) + "x", "x".repeat(250), "corrige", "12");
        DossierDeResultats dossier = new DossierDeResultats(classe);
        for (String nom : noms) {
            dossier.ecrire(resultat(nom, ""));
            assertTrue(DossierDeResultats.nom(nom).matches("[A-Za-z0-9%_~-][A-Za-z0-9.%_~-]{0,199}"), DossierDeResultats.nom(nom));
        }
        assertEquals(new TreeSet<>(noms), new TreeSet<>(ids()));
        assertEquals("zo%C3%A9.zip", DossierDeResultats.nom("zoé.zip"));
    }

    @Test
    void deuxCorrecteursALaFoisDonnentLUnion() throws IOException {
        IntStream.range(0, 200).parallel().forEach(k -> {
            try {
                new DossierDeResultats(classe).ecrire(grille("a"));
                new DossierDeResultats(classe).ecrire(resultat("n" + k % 120, ""));
            } catch (IOException e) {
                throw new IllegalStateException(e);
            }
        });
        assertEquals(120, ids().size());
        assertEquals("a", new DossierDeResultats(classe).grille().etapes.get(0).criteres.get(0).methode);
        try (Stream<Path> tous = Files.walk(classe)) {
            assertEquals(0, tous.filter(f -> f.getFileName().toString().startsWith(".ecrit")).count());
        }
    }

    @Test
    void unAutreTravailQuiEnRemplaceUnLeDitEtLeMemeNon() throws IOException {
        DossierDeResultats dossier = new DossierDeResultats(classe);
        Resultat premier = resultat("TP1.zip", "class A {}");
        dossier.ecrire(premier);
        Resultat meme = resultat("TP1.zip", "class A {}");
        dossier.ecrire(meme);
        assertEquals("", meme.remplace);
        dossier.ecrire(resultat("TP1.zip", "class B {}"));
        assertEquals(List.of("remplace un autre travail de « TP1.zip », jugé le " + meme.date), dossier.resultats().get(0).aRegarder);
    }

    @Test
    void desResultatsDUneAutreGrilleNeSeMelentPas() throws IOException {
        DossierDeResultats dossier = new DossierDeResultats(classe);
        dossier.ecrire(grille("a"));
        dossier.ecrire(grille("b"));
        dossier.ecrire(resultat("u", ""));
        dossier.ecrire(grille("b"));
        String dit = assertThrows(Panne.class, () -> dossier.ecrire(grille("a"))).getMessage();
        assertTrue(dit.contains("une autre version du programme") && dit.contains("NEUF=1"), dit);
    }
}
