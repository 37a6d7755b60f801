package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.temoins.LancerSurveille;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Ce que « Vitesse ou précision… » mesure d'une image dessinée avec un de ses points. */
class ErreurMesureeTest {

    private static final int L = 160;
    private static final int H = 120;

    @ParameterizedTest
    @ValueSource(strings = {"bowling", "brume", "diffus", "miroirs", "ombres", "scene1", "tournesol"})
    void lErreurMesureeEtCelleQuiEtaitAttendueSontDAccordAuxIncertitudesPres(String nom) {
        Lancer prepare = LancerSurveille.preparer(new Scene("scenes/" + nom + ".ini"), L, H, false);
        Auto auto = Auto.choisir(prepare, Souhait.erreur(4), 2, Collections.singletonList(new Antialias()));
        for (Reglage reglage : auto.getFront()) {
            Couleur[][] image = new Couleur[L][H];
            auto.getLancer(reglage).TracerPixels((couleur, i, j) -> image[i][j] = couleur, reglage.getReflets(), 2);
            double[] mesure = auto.mesurer(reglage, (i, j) -> image[i][j]);
            double auPlus = reglage.getErreurAuPlus();
            assertTrue(mesure[0] - mesure[1] <= auPlus && mesure[0] + mesure[1] >= auPlus - 2 * reglage.getIncertitude(),
                    reglage + " : " + reglage.getErreur() + " ± " + reglage.getIncertitude() + ", mesuré " + mesure[0] + " ± "
                            + mesure[1]);
        }
    }
}
