package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Le front de Pareto. */
class FrontTest {

    private static Releve point(double rayons, double pas) {
        return Faux.releve(Famille.ECHANTILLONNAGE, Catalogue.COINS, "n=3 seuil=0.05", rayons, pas);
    }

    @Test
    void ilGardeCeQueRienNeBatALaFoisEnCoutEtEnErreurDuMoinsCherAuPlusJuste() {
        Releve a = point(1, 9);
        Releve b = point(2, 5);
        Releve battu = point(3, 6);
        Releve c = point(4, 1);
        Releve memeErreur = point(5, 1);
        Releve memeCout = point(4, 2);
        Front front = new Front(Arrays.asList(memeErreur, c, battu, memeCout, a, b), Cout.RAYONS);
        assertEquals(Arrays.asList(a, b, c), front.get());
        assertFalse(front.contient(battu));
        assertTrue(front.contient(point(4, 1)), "confondu avec qui y est");
    }

    @Test
    void ilDitDeCombienUnReglageEnEstLoin() {
        Releve b = point(2, 5);
        Releve battu = point(3, 6);
        Front front = new Front(Arrays.asList(point(1, 9), b, battu), Cout.RAYONS);
        assertEquals(b, front.mieuxQue(battu).get());
        assertEquals(1.5, front.gain(battu), 1e-12);
        assertEquals(1, front.gain(b));
        assertFalse(front.mieuxQue(b).isPresent());
        assertEquals(1.5, new Front(Arrays.asList(b, battu), Cout.TEMPS).gain(battu), 1e-12);
    }

    @Test
    void dePointsAuHasardAucunNYEstBattuToutAutreLEstEtLOrdreNeChangeRien() {
        for (long graine = 0; graine < 50; graine++) {
            Random hasard = new Random(graine);
            List<Releve> points = new ArrayList<>();
            for (int k = 0; k < 40; k++) {
                points.add(point(1 + hasard.nextInt(12), hasard.nextInt(12)));
            }
            Front front = new Front(points, Cout.RAYONS);
            for (Releve p : points) {
                boolean battu = points.stream().anyMatch(q -> q.rayonsParPixel() <= p.rayonsParPixel()
                        && q.erreurEnPas() <= p.erreurEnPas()
                        && (q.rayonsParPixel() < p.rayonsParPixel() || q.erreurEnPas() < p.erreurEnPas()));
                boolean dessus = front.get().stream()
                        .anyMatch(q -> q.rayonsParPixel() == p.rayonsParPixel() && q.erreurEnPas() == p.erreurEnPas());
                assertEquals(!battu, dessus, "graine " + graine);
            }
            Collections.shuffle(points, hasard);
            assertEquals(front.get().size(), new Front(points, Cout.RAYONS).get().size(), "graine " + graine);
        }
    }
}
