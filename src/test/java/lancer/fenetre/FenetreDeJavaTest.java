package lancer.fenetre;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.GraphicsEnvironment;
import java.util.Arrays;
import lancer.essai.EssaiProcessus;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Une machine virtuelle mal installée, sur un écran qui répond. */
@Tag("fenetre")
@Timeout(900)
class FenetreDeJavaTest extends EssaiProcessus {

    @BeforeEach
    void supposerUnEcran() {
        assumeFalse(GraphicsEnvironment.isHeadless(), "pas d'écran ici");
    }

    @Test
    void uneClasseDAccessibiliteAbsenteNEstPasUnEcranAbsent() throws Exception {
        assertEquals(1, statut(preparer(java("-Djavax.accessibility.assistive_technologies=absente.Classe", SCENE))));
        assertTrue(erreur().contains("absente.Classe") && !erreur().contains("pas d'écran"), erreur());
        assertEquals(1, erreur().split("\n").length, erreur());
    }

    @Test
    void unUtilisateurSansDossierNEnAPasUnDeCeNom() throws Exception {
        processus = preparer(java("-Duser.home=?", "--statistiques", "--taille=32x24", SCENE)).start();
        attendre(() -> sortie().contains("trace.ms") || !processus.isAlive());
        assertTrue(processus.isAlive(), erreur());
        assertEquals(Arrays.asList("flux"), Arrays.asList(dossier.toFile().list()));
    }
}
