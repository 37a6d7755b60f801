package lancer.correction.jugement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.correction.isolement.Arret;
import lancer.correction.isolement.Confinement;
import lancer.correction.modele.SourcesDuCours;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Le corrigé, écrit d'après le seul énoncé, est juste ; avec une faute classique, elle est vue à son étape, et à elle seule. */
@EnabledForJreRange(min = JRE.JAVA_17)
class ReferenceTest extends JuryEssai {

    /** Les fautes des rendus que {@link lancer.correction.ClasseTest} juge. */
    private static final Set<String> DANS_LA_CLASSE = Set.of("L-non-normalise", "image-renversee", "sans-fin");

    @TempDir
    static Path dossier;

    private static Map<String, Resultat> resultats;

    @BeforeAll
    static void jugerLesFautes() throws IOException {
        Path rendus = dossier.resolve("rendus");
        for (String ligne : Files.readAllLines(RENDUS.resolve("fautes.txt"))) {
            String[] faute = ligne.split("\\|");
            if (!ligne.startsWith("#") && !DANS_LA_CLASSE.contains(faute[0])) {
                Path rendu = rendus.resolve(faute[0]);
                changer(Files.exists(rendu) ? sources(rendu) : ecrireCorrige(rendu), faute[1], faute[2], faute[3]);
            }
        }
        copier(RENDUS.resolve("classe/Étudiant 6_106_assignsubmission_file/brume/src/main/java/lancer/Lancer.java"),
                rendus.resolve("racine-negative/brume/src/main/java/lancer/Lancer.java"));
        copier(RENDUS.resolve("classe/Étudiant 6_106_assignsubmission_file/brume/src/main/java/lancer/Brume.java"),
                rendus.resolve("racine-negative/brume/src/main/java/lancer/Brume.java"));
        ecrireCorrige(rendus.resolve("corrige"));
        ecrireCorrige(rendus.resolve("extensions"));
        variante(rendus.resolve("extensions/brume"), SourcesDuCours.corrige("Lancer")
                .replace("getColor(scene, initial, contact, profondeur)",
                "getColor(scene, initial, contact, profondeur).mul(0.5).add(new Couleur(0.4, 0.4, 0.4))"));
        variante(rendus.resolve("extensions/antialias"), SourcesDuCours.corrige("Lancer", "antialias")
                .replace("+ 0.5) / N", "+ 0.5) / N + 0.5"));
        resultats = juger(rendus, Confinement.essayer(), PATIENTES);
    }

    private static void variante(Path projet, String lancer) throws IOException {
        Files.writeString(Files.createDirectories(projet.resolve("src/main/java/lancer")).resolve("Lancer.java"), lancer);
    }

    @ParameterizedTest
    @CsvSource({"racine-negative, sphere, Sphere", "ombre-de-soi, ombres, Objet3D", "plus-loin, scene, Scene",
        "miroir-a-l-envers, phong reflets, Objet3D", "normale-a-l-envers, lambert, Sphere", "masquees, ombres sphere, Sphere Objet3D"})
    void uneFauteEstVueASonEtapeEtDansSaClasse(String faute, String etapes, String classes) {
        TreeSet<String> ratees = ratees(resultats.get(faute));
        ratees.remove("image");
        assertEquals(List.of(classes.split(" ")), resultats.get(faute).classesFautives, resultats.get(faute).remarques.toString());
        assertEquals(etapes, String.join(" ", ratees), faute + " : " + resultats.get(faute).verdicts.entrySet().stream()
                .filter(e -> e.getValue().etat == Verdict.Etat.FAUSSE).map(e -> e.getKey() + " " + e.getValue().message)
                .collect(Collectors.toList()));
    }

    @Test
    void leCorrigeDessineNotreImageEtPasseTout() throws IOException {
        Resultat corrige = resultats.get("corrige");
        assertEquals(new TreeSet<>(), ratees(corrige));
        assertTrue(corrige.verdicts.values().stream().allMatch(Verdict::compte));
        int faux = 0;
        for (String nom : Reference.SCENES.keySet()) {
            int[] taille = Reference.SCENES.get(nom);
            String texte = SourcesDuCours.scene(nom, JuryPartage.GRAINE);
            Scene lue = new Scene(Files.writeString(dossier.resolve(nom + ".ini"), texte).toString());
            // sans les variantes, que les tests de ce module ont dans leur chemin
            Lancer lancer = new Lancer(new Scene(lue.getObjets(), lue.getLampes()), new Camera(taille[0], taille[1]));
            for (int p = 0; p < taille[0] * taille[1]; p++) {
                Couleur c = lancer.getCouleurPixel(p % taille[0], p / taille[0], taille[2]);
                for (int k = 0; k < 3; k++) {
                    int sien = corrige.images.get(nom).code(p % taille[0], p / taille[0]) >> 16 - 8 * k & 255;
                    faux += Math.abs(sien - (c.getCode() >> 16 - 8 * k & 255)) > 1 ? 1 : 0;
                }
            }
        }
        assertEquals(0, faux, "composantes à plus d'un niveau de celles de notre programme");
    }

    @Test
    void leProjetACompleterNePasseQueCeQuiNeComptePas() throws Arret {
        Reference reference = JuryPartage.de(Confinement.essayer()).reference();
        // rien ne se note à l'étape des répétitions
        List<Verification> notees = reference.verifications.stream().filter(v -> !v.etape.equals(Verification.REPETITION))
                .collect(Collectors.toList());
        assertEquals(new TreeSet<>(List.of("vecteurs.lesAutresOperationsSontIntactes", "vecteurs.uneCouleurNEstLimiteeQuALEcran",
                "vecteurs.unTripletGardeSesCoordonnees", "vecteurs.lesConstantesSontCellesDuCours",
                "vecteurs.unContactGardeSonObjetEtSaDistance",
                "rayons.leCielEstCeluiDuCours", "scene.sansDistanceIlNYAPasDeContact")),
                notees.stream().filter(v -> !v.compte).map(Verification::id)
                        .collect(Collectors.toCollection(TreeSet::new)));
        for (Verification v : notees) {
            assertEquals(v.compte, !reference.duSquelette(v).compte(), v.id() + " : seule parmi le corrigé, la classe de même");
        }
    }

    @Test
    void uneBouleDansSaPropreOmbreEstUneFauteDOmbre() {
        // la faute y est, et non dans getColor, que l'on a appelée
        Map<String, String> methodes = resultats.get("ombre-de-soi").methodes;
        assertTrue(!methodes.isEmpty() && methodes.values().stream().allMatch(m -> m.contains("private boolean estALOmbre(")),
                "la méthode privée est montrée aussi : " + methodes);
    }

    @Test
    void uneExtensionSeMontreAvecSaBaseEtNEstPasJugee() {
        for (String[] une : new String[][] {{"extensions", "brume"}, {"extensions", "antialias"}, {"racine-negative", "brume"}}) {
            Resultat resultat = resultats.get(une[0]);
            assertEquals(Verdict.Etat.A_NOTER, resultat.verdicts.get(une[1] + ".image").etat, une[0]);
            Image sienne = resultat.images.get(une[1]);
            Image base = resultat.images.get(une[1] + GrilleDeNotation.BASE);
            assertFalse(sienne.pareille(base), une[0] + " : l'extension change l'image de sa base");
        }
        assertFalse(resultats.get("masquees").verdicts.containsKey("brume.image"), "elle n'est pas rendue");
    }

    @Test
    void uneNormaleALEnversEstUneFauteDeLambertQuelQueSoitLePointVisePourChaquePixel() {
        assertTrue(resultats.get("normale-a-l-envers").centre, "getCouleurPixel vise le centre du pixel");
        assertEquals("normale N", resultats.get("normale-a-l-envers").chemin.getPremierEcart().nom, "et non le rayon, qui est juste");
    }

    @Test
    void plusieursFautesAlaFoisNeSeCachentPas() {
        assertTrue(resultats.get("masquees").verdicts.entrySet().stream().noneMatch(e -> e.getKey().startsWith("lambert.")
                && e.getValue().etat == Verdict.Etat.FAUSSE), "une boule qui s'ombre elle-même ne dit rien de Lambert");
        assertFalse(imageJuste(resultats.get("masquees")));
    }
}
