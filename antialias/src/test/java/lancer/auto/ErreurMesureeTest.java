package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import lancer.Scene;
import lancer.antialias.Antialias;
import lancer.fils.Traceur;
import lancer.dessin.LancerSurveille;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Ce que disent les essais des réglages de l'anticrénelage : l'erreur attendue, et le temps promis. */
class ErreurMesureeTest {

    private static final int L = 160;
    private static final int H = 120;

    @ParameterizedTest
    @ValueSource(strings = {"bowling", "brume", "diffus", "miroirs", "ombres", "scene1", "tournesol"})
    void lErreurMesureeEstEntreCellesQuiEtaientAttendues(String nom) {
        Traceur prepare = LancerSurveille.preparer(new Scene("scenes/" + nom + ".ini"), L, H, false);
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

    /** Quelle que soit la machine : plus un temps est court, moins il promet, et une milliseconde ne promet rien. */
    @Test
    void unTempsQueRienNePrometDonneLePlusRapide() {
        Scene scene = new Scene("scenes/scene1.ini");
        boolean promis = true;
        for (double voulu = 0.3; voulu > 0.001 / 1.1; voulu /= 1.1) {
            Auto auto = Auto.choisir(LancerSurveille.preparer(scene, 200, 150, false), Souhait.temps(voulu), 2,
                    Collections.singletonList(new Antialias()), enCours -> { });
            assertTrue(auto.estTenable() || auto.getChoisi().toString().equals(auto.getEssayes().get(0).toString()),
                    auto.getChoisi() + " pour " + voulu + " s");
            promis = auto.estTenable();
        }
        assertFalse(promis);
    }
}
