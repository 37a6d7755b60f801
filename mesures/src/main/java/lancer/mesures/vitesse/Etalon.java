package lancer.mesures.vitesse;

import java.lang.management.ManagementFactory;
import java.util.Arrays;

/**
 * Un calcul toujours le même, par autant de fils que de cœurs : ce que la machine nous laisse. Elle est troublée si ces fils n'ont pas
 * eu {@value #PART_MIN} du temps de leurs cœurs, ou s'ils ont mis {@value #LENTEUR_MAX} fois leur meilleur temps.
 */
final class Etalon {

    static final double PART_MIN = 0.85;
    static final double LENTEUR_MAX = 1.25;

    private static final int PAS = 24_000_000;
    private static final int ECHAUFFEMENT = 10;

    private final int fils = Runtime.getRuntime().availableProcessors();
    private double meilleurNs = Double.POSITIVE_INFINITY;

    /** Résultat du calcul : sans quoi la machine virtuelle pourrait l'omettre. */
    private volatile long rendu;

    Etalon() {
        for (int k = 0; k < ECHAUFFEMENT; k++) {
            estCalme();
        }
    }

    /** Vrai si la machine vient d'être à nous. */
    boolean estCalme() {
        // de chaque fil, à sa montre, sa durée et ce qu'il a eu de son cœur : le temps qu'il met à partir n'est celui de personne
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
