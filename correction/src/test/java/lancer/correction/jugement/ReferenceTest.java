package lancer.correction.jugement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.correction.isolement.Arret;
import lancer.correction.isolement.Confinement;
import lancer.correction.modele.SourcesDuCours;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;

/** Le corrigé, écrit d'après le seul énoncé, et le projet à compléter. */
@EnabledForJreRange(min = JRE.JAVA_17)
class ReferenceTest extends JuryEssai {

    @TempDir
    Path dossier;

    @Test
    void leCorrigeDessineNotreImageEtPasseTout() throws IOException {
        ecrireCorrige(dossier.resolve("rendus/corrige"));
        Map<String, Resultat> resultats = juger(dossier.resolve("rendus"), Confinement.essayer(), PATIENTES);
        Resultat corrige = resultats.get("corrige");
        assertEquals(new TreeSet<>(), ratees(corrige));
        assertTrue(corrige.verdicts.values().stream().allMatch(Verdict::compte));
        int faux = 0;
        for (String nom : Reference.SCENES.keySet()) {
            int[] taille = Reference.SCENES.get(nom);
            Scene lue = new Scene(Files.writeString(dossier.resolve(nom + ".ini"), SourcesDuCours.scene(nom, GRAINE)).toString());
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
    void leProjetACompleterNePasseQueCeQuiNeComptePas() throws IOException, Arret {
        Reference reference = jury(Confinement.essayer(), PATIENTES).reference;
        assertEquals(new TreeSet<>(List.of("vecteurs.lesAutresOperationsSontIntactes", "scene.sansDistanceIlNYAPasDeContact")),
                reference.verifications.stream().filter(v -> !v.compte).map(Verification::id)
                        .collect(Collectors.toCollection(TreeSet::new)));
        for (Verification v : reference.verifications) {
            assertEquals(v.compte, !reference.duSquelette(v).compte(), v.id() + " : seule parmi le corrigé, la classe de même");
        }
    }
}
