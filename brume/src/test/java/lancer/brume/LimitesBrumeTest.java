package lancer.brume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import lancer.Constantes;
import lancer.Couleur;
import org.junit.jupiter.api.Test;

/** Où les formules de la brume, recopiées telles quelles, échouent. */
class LimitesBrumeTest {

    /** {@code 1 − exp(−densite·(d − debut))}, limitée à [0, 1] comme on le fait d'ordinaire. */
    private static double exponentielleNaive(double debut, double densite, double d) {
        return Math.min(1, Math.max(0, 1 - Math.exp(-densite * (d - debut))));
    }

    /** Le ciel est à une distance infinie : une brume sans densité y fait 0·∞, et les limites laissent passer NaN. */
    @Test
    void zeroFoisLInfiniNEstPasUneBrume() {
        assertTrue(Double.isNaN(exponentielleNaive(0, 0, Constantes.INFINI)));
        Brume sansDensite = new Brume(new Couleur(0.25), 0, Double.NaN, 0);
        assertEquals(new Couleur(0.25), sansDensite.traverser(new Couleur(0.9), Constantes.INFINI), "la brume seule");
        assertEquals(new Couleur(0.9), sansDensite.traverser(new Couleur(0.9), 1e300), "un objet, si loin soit-il, n'en a pas");
    }

    /** De 1, 1 − exp(−x) ne garde que les chiffres de x au-dessus de 1e-16 ; {@code expm1} les garde tous. */
    @Test
    void uneBrumeTresLegereSePerdDansUn() {
        assertEquals(0, exponentielleNaive(0, 1e-17, 1), "disparue");
        assertEquals(1e-17, new Brume(new Couleur(1), 0, Double.NaN, 1e-17).k(1), 1e-32);
        double naive = exponentielleNaive(0, 1e-12, 1);
        assertTrue(Math.abs(naive / 1e-12 - 1) > 1e-5, "il en reste quatre chiffres : " + naive);
        assertEquals(1, new Brume(new Couleur(1), 0, Double.NaN, 1e-12).k(1) / 1e-12, 1e-11);
    }

    /** Cumuler les longueurs d'un rayon et de ses reflets mettrait un objet vu dans un miroir derrière deux brumes à la fois. */
    @Test
    void chaqueRayonTraverseSaBrumeEtElleSeule() {
        Brume brume = new Brume(new Couleur(1), 0, 20, 0);
        // objet noir à 8 d'un miroir parfait, lui-même à 4 : 0,4 de brume, puis 0,2 + 0,8·0,4
        double justes = brume.traverser(brume.traverser(new Couleur(), 8), 4).r;
        double cumulees = brume.traverser(brume.traverser(new Couleur(), 8 + 4), 4).r;
        assertEquals(0.2 + 0.8 * 0.4, justes, 1e-15);
        assertEquals(0.2 + 0.8 * 0.6, cumulees, 1e-15, "l'image l'a en forme close : BrumeTest.laBrumeEntreDeuxMiroirsAUneFormeClose");
    }
}
