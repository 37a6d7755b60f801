package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
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
    void lErreurMesureeEstEntreCellesQuiEtaientAttendues(String nom) {
        Lancer prepare = LancerSurveille.preparer(new Scene("scenes/" + nom + ".ini"), L, H, false);
        Auto auto = Auto.choisir(prepare, Souhait.erreur(4), 2, Collections.singletonList(new Antialias()), enCours -> { });
        for (Reglage reglage : auto.getFront()) {
            prepare.avec(reglage.finesse.echantillonnage, reglage.seuil)
                    .TracerPixels(auto.surveiller((couleur, i, j) -> { }, reglage), reglage.reflets, 2);
            auto.controler();
            double mesuree = auto.getErreurMesuree();
            assertTrue(mesuree >= reglage.mesureAuMoins && mesuree <= reglage.mesureAuPlus, reglage + " : de " + reglage.mesureAuMoins
                    + " à " + reglage.mesureAuPlus + ", mesuré " + mesuree);
        }
    }
}
