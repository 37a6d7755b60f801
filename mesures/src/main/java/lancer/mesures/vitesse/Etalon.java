package lancer.mesures.vitesse;

import java.lang.management.ManagementFactory;
import java.util.Arrays;

/**
 * Un calcul toujours identique, sur tous les cœurs, qui dit si la machine est disponible. Elle ne l'est pas si ces fils ont eu moins de
 * {@value #PART_MIN} du temps de leurs cœurs, ou s'ils ont duré plus de {@value #LENTEUR_MAX} fois leur meilleur temps.
 */
final class Etalon {

    static final double PART_MIN = 0.85;
    static final double LENTEUR_MAX = 1.25;

    private static final int PAS = 24_000_000;
    private static final int ECHAUFFEMENT = 10;

    private final int fils = Runtime.getRuntime().availableProcessors();
    private double meilleurNs = Double.POSITIVE_INFINITY;

    /** Résultat du calcul. Sans lui, la machine virtuelle pourrait supprimer le calcul. */
    private volatile long rendu;

    Etalon() {
        for (int k = 0; k < ECHAUFFEMENT; k++) {
            estCalme();
        }
    }

    /** Dit si la machine était disponible pendant ce calcul. */
    boolean estCalme() {
        // chaque fil mesure sa durée et son temps de processeur : son temps de démarrage n'y est pas
        long[] reel = new long[fils];
        long[] processeur = new long[fils];
        Thread[] threads = new Thread[fils];
        for (int k = 0; k < fils; k++) {
            int fil = k;
            threads[k] = new Thread(() -> {
                long debut = System.nanoTime();
                long avant = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
                calculer();
                processeur[fil] = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - avant;
                reel[fil] = System.nanoTime() - debut;
            }, "etalon");
            threads[k].start();
        }
        try {
            for (Thread thread : threads) {
                thread.join();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
        long leDernier = Arrays.stream(reel).max().getAsLong();
        meilleurNs = Math.min(meilleurNs, leDernier);
        return Arrays.stream(processeur).sum() >= PART_MIN * Arrays.stream(reel).sum() && leDernier <= LENTEUR_MAX * meilleurNs;
    }

    private void calculer() {
        long x = 1;
        for (int k = 0; k < PAS; k++) {
            x = x * 6364136223846793005L + 1442695040888963407L;
        }
        rendu = x;
    }
}
