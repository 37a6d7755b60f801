package lancer.correction.isolement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.file.Paths;
import java.util.List;
import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;

/** Ce qui tue une machine virtuelle à part, et ce qui ne la tue pas. */
@EnabledForJreRange(min = JRE.JAVA_17)
class EnfantTest {

    /** Répète ce qu'on lui dit. */
    static final class Echo {

        public static void main(String[] args) throws IOException {
            BufferedReader entree = new BufferedReader(new InputStreamReader(System.in));
            for (String ligne = entree.readLine(); ligne != null; ligne = entree.readLine()) {
                System.out.println(ligne);
            }
        }
    }

    @Test
    void ilSurvitAuFilQuiLADemande() throws Exception {
        Confinement confinement = Confinement.essayer();
        assumeTrue(confinement.estConfine(), confinement.getManque());
        String classes = new File(Echo.class.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
        Limites limites = Limites.ordinaires();
        FutureTask<Enfant> demande = new FutureTask<>(() -> new Enfant(confinement.java(Echo.class, classes,
                List.of(Paths.get(classes)), null, limites), "", limites));
        Thread demandeur = new Thread(demande);
        demandeur.start();
        try (Enfant enfant = demande.get()) {
            enfant.commencer(limites.calcul);
            enfant.dire("avant");
            assertEquals("avant", enfant.attendre());
            demandeur.join();
            enfant.dire("après");
            assertEquals("après", enfant.attendre());
        }
    }
}
