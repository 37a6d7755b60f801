package lancer.mesures.vitesse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Les manches, d'une horloge et d'une machine qui disent ce qu'on veut. */
class ManchesTest {

    private final List<String> ordre = new ArrayList<>();

    /** Dont chaque temps vaut le suivant de ceux-ci, et dont les processeurs ont toujours autant, ou la part donnée. */
    private Manches.Echantillon echantillon(String nom, double part, double... temps) {
        Iterator<Double> suivant = Arrays.stream(temps).boxed().iterator();
        return () -> {
            ordre.add(nom);
            double t = suivant.next();
            return new double[] {t, t < 0 ? -t * part : t * 2};
        };
    }

    @Test
    void laReferenceEtLaMethodeDessinentATourDeRoleEtSeulsLeursRapportsComptent() throws IOException {
        // une machine deux fois plus lente à la deuxième manche ne change rien
        Manches.Temps temps = new Manches(() -> true, false).mesurer(echantillon("A", 2, 10, 20, 10), echantillon("B", 2, 30, 60, 30), 3);
        assertEquals(Arrays.asList("A", "B", "A", "B", "A", "B"), ordre);
        assertEquals(3, temps.rapport().valeur, 1e-9);
        assertEquals(10, temps.reference(), 1e-9);
        assertEquals(0, temps.jetees());
    }

    @Test
    void uneMancheQuEncadreUneMachineTroubleeEstJetee() throws IOException {
        Iterator<Boolean> calmes = Arrays.asList(true, true, false, false, false, true, true, true).iterator();
        Manches.Temps temps = new Manches(calmes::next, false).mesurer(echantillon("A", 2, 10, 10, 10, 10, 10),
                echantillon("B", 2, 30, 900, 900, 30, 30), 3);
        assertEquals(3, temps.rapport().valeur, 1e-9);
        assertEquals(2, temps.jetees());
        assertEquals(5, temps.manches);
    }

    @Test
    void unTroubleFiniEntreDeuxManchesNEnFaitJeterQuUne() throws IOException {
        Iterator<Boolean> calmes = Arrays.asList(true, false, true, true, true).iterator();
        Manches.Temps temps = new Manches(calmes::next, false).mesurer(echantillon("A", 2, 10, 10, 10),
                echantillon("B", 2, 900, 30, 30), 2);
        assertEquals(3, temps.rapport().valeur, 1e-9);
        assertEquals(1, temps.jetees());
    }

    @Test
    void leCoutDUneMethodeEstCeluiDUneMancheOrdinaire() throws IOException {
        Iterator<double[]> a = Arrays.asList(new double[] {10, 20, 50}, new double[] {10, 40, 50}, new double[] {10, 30, 80}).iterator();
        Iterator<double[]> b = Arrays.asList(new double[] {10, 60, 25}, new double[] {10, 120, 25}, new double[] {10, 90, 40}).iterator();
        Manches.Temps temps = new Manches(() -> true, true).mesurer(a::next, b::next, 3);
        assertEquals(25, temps.cout(Manches.MEMOIRE), 1e-9);
        assertEquals(90, temps.cout(Manches.PROCESSEURS), 1e-9);
        assertTrue(Double.isNaN(new Manches(() -> true, true).mesurer(echantillon("A", 2, 10), echantillon("B", 2, 10), 1)
                .cout(Manches.MEMOIRE)), "de qui n'en dit rien, on ne sait rien");
    }

    @Test
    void unDessinPriveDeProcesseursEstJete() throws IOException {
        Iterator<double[]> b = Arrays.asList(new double[] {30, 60}, new double[] {60, 60}, new double[] {30, 60}).iterator();
        Manches.Temps temps = new Manches(() -> true, false).mesurer(echantillon("A", 2, 10, 10, 10), b::next, 2);
        assertEquals(3, temps.rapport().valeur, 1e-9);
        assertEquals(1, temps.jetees());
    }

    @Test
    void uneMachineTropTroubleeEstRefuseeSaufSiLOnYTient() throws IOException {
        double[] dix = new double[200];
        Arrays.fill(dix, 10);
        IOException faute = assertThrows(IOException.class,
                () -> new Manches(() -> false, false).mesurer(echantillon("A", 2, dix), echantillon("B", 2, dix), 3));
        assertTrue(faute.getMessage().contains("100 manches jetées sur 100 ; aucun temps n'est changé. Fermez"), faute.getMessage());
        Manches agitee = new Manches(() -> false, true);
        assertEquals(0, agitee.mesurer(echantillon("A", 2, dix), echantillon("B", 2, dix), 3).jetees());
    }

    @Test
    void lEtalonVoitQuUnAutreTravailPrendLesCoeurs() throws InterruptedException {
        Etalon etalon = new Etalon();
        Thread[] autres = new Thread[4 * Runtime.getRuntime().availableProcessors()];
        for (int k = 0; k < autres.length; k++) {
            autres[k] = new Thread(() -> {
                while (!Thread.currentThread().isInterrupted()) {
                    Math.sqrt(System.nanoTime());
                }
            });
            autres[k].start();
        }
        int calmes = 0;
        for (int k = 0; k < 10; k++) {
            calmes += etalon.estCalme() ? 1 : 0;
        }
        for (Thread autre : autres) {
            autre.interrupt();
            autre.join();
        }
        assertTrue(calmes <= 2, calmes + " fois sur 10");
    }
}
