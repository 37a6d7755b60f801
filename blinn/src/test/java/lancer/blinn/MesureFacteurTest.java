package lancer.blinn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Locale;
import java.util.stream.IntStream;
import lancer.Vecteur;
import lancer.contrat.Specularite;
import lancer.essai.Essai;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Quel facteur rend le reflet de Blinn le plus proche de celui de Phong, au sens des moindres carrés ? L'œil et la lampe sont loin, la
 * surface est une sphère. Un point du reflet est repéré par son écart au centre, où l'incidence i est l'angle de N et L, et par l'azimut
 * de cet écart : 0° dans le plan d'incidence, 90° en travers.
 */
class MesureFacteurTest {

    private static final int PAS = 100;

    /** Un quart du reflet : les quatre sont symétriques. */
    private static final double[] TOUT = IntStream.range(0, 40).mapToDouble(a -> 90 * (a + 0.5) / 40).toArray();

    /** L'écart quadratique des deux reflets, rapporté au reflet de Phong : 0 s'ils sont égaux. Angles en degrés. */
    private static double ecart(double facteur, double ns, double incidence, double... azimuts) {
        double i = Math.toRadians(incidence);
        Vecteur L = new Vecteur(Math.sin(i), 0, Math.cos(i));
        Vecteur V = new Vecteur(Math.sin(i), 0, -Math.cos(i));
        // au-delà de six écarts types, plus rien ne brille
        double ecartMax = Math.min(Math.PI / 2, 6 / (2 * Math.cos(i) * Math.sqrt(ns)));
        double difference = 0;
        double total = 0;
        for (int k = 0; k < azimuts.length * PAS; k++) {
            double azimut = Math.toRadians(azimuts[k / PAS]);
            double ecart = ecartMax * (k % PAS + 0.5) / PAS;
            double sinus = Math.sin(ecart);
            Vecteur N = new Vecteur(sinus * Math.cos(azimut), sinus * Math.sin(azimut), Math.cos(ecart));
            if (N.dot(L) > 0 && N.dot(V) < 0) {
                Vecteur R = V.sub(N.mul(2 * V.dot(N))).normalized();
                double phong = Specularite.PHONG.eclat(V, N, L, R, ns);
                double d = phong - new Blinn(facteur).eclat(V, N, L, R, ns);
                difference += d * d * sinus;
                total += phong * phong * sinus;
            }
        }
        return Math.sqrt(difference / total);
    }

    private static double meilleur(double ns, double incidence, double... azimuts) {
        double meilleur = 3;
        for (double pas = 1.5; pas > 1e-6; pas /= 2) {
            double moins = meilleur - pas;
            double plus = meilleur + pas;
            double autre = ecart(moins, ns, incidence, azimuts) < ecart(plus, ns, incidence, azimuts) ? moins : plus;
            meilleur = ecart(autre, ns, incidence, azimuts) < ecart(meilleur, ns, incidence, azimuts) ? autre : meilleur;
        }
        return meilleur;
    }

    /** 4 dans le plan d'incidence, 4·cos²i en travers. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 15, 30, 45, 60, 75})
    void unPetitRefletSuitLaFormeClose(double i) {
        double cos2 = Math.pow(Math.cos(Math.toRadians(i)), 2);
        assertEquals(4, meilleur(1e5, i, 0), 2e-3);
        assertEquals(4 * cos2, meilleur(1e5, i, 90), 2e-3);
        assertEquals(2 * (1 + cos2), meilleur(1e5, i, 45), 2e-3);
    }

    @Test
    void leTableauDuReadmeEstCeluiDeLaMesure() throws IOException {
        String readme = Essai.texte("README.md");
        for (double ns : new double[] {5, 20, 100, 1000}) {
            rangee(readme, "ns = %.0f, tout le reflet |", ns, ns, TOUT);
        }
        for (double azimut : new double[] {0, 45, 90}) {
            rangee(readme, "ns = 100, azimut %.0f° |", azimut, 100, azimut);
        }
    }

    private static void rangee(String readme, String titre, double nombre, double ns, double... azimuts) {
        StringBuilder rangee = new StringBuilder(String.format(Locale.ROOT, "| " + titre, nombre));
        for (double i : new double[] {0, 15, 30, 45, 60, 75}) {
            double facteur = meilleur(ns, i, azimuts);
            rangee.append(String.format(Locale.ROOT, azimuts == TOUT ? " %.2f (%.0f %%) |" : " %.2f |", facteur,
                    100 * ecart(facteur, ns, i, azimuts)));
        }
        assertTrue(readme.contains("\n" + rangee + "\n"), "à recopier dans README.md : " + rangee);
    }
}
