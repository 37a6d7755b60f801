package lancer.mesures.vitesse;

import java.lang.management.ManagementFactory;
import java.util.concurrent.atomic.AtomicLong;

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

    /** Ce qu'a rendu le calcul : sans quoi la machine virtuelle pourrait l'omettre. */
    private volatile long rendu;

    Etalon() {
        for (int k = 0; k < ECHAUFFEMENT; k++) {
            estCalme();
        }
    }

    /** Vrai si la machine vient d'être à nous. */
    boolean estCalme() {
        AtomicLong processeur = new AtomicLong();
        AtomicLong reel = new AtomicLong();
        AtomicLong leDernier = new AtomicLong();
        Thread[] threads = new Thread[fils];
        for (int k = 0; k < fils; k++) {
            threads[k] = new Thread(() -> {
                // chacun à sa montre : le temps que met un fil à partir n'est celui de personne
                long debut = System.nanoTime();
                long avant = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
                calculer();
                processeur.addAndGet(ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - avant);
                long duree = System.nanoTime() - debut;
                reel.addAndGet(duree);
                leDernier.accumulateAndGet(duree, Math::max);
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
        meilleurNs = Math.min(meilleurNs, leDernier.get());
        return processeur.get() >= PART_MIN * reel.get() && leDernier.get() <= LENTEUR_MAX * meilleurNs;
    }

    private void calculer() {
        long x = 1;
        for (int k = 0; k < PAS; k++) {
            x = x * 6364136223846793005L + 1442695040888963407L;
        }
        rendu = x;
    }
}
