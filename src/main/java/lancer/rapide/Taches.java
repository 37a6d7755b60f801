package lancer.rapide;

import java.util.concurrent.atomic.AtomicInteger;

/** Des constructions sans rapport entre elles, de 0 à {@code nombre} − 1, faites par autant de fils que de cœurs. */
abstract class Taches implements Runnable {

    /** Au-dessous de ce nombre de sphères, un fil coûte plus à lancer qu'il ne fait gagner. */
    private static final int SPHERES_MIN = 200;

    private final int nombre;
    private final AtomicInteger suivante = new AtomicInteger();
    private final int fils;
    private volatile Throwable echec;

    Taches(int nombre, int spheres) {
        this.nombre = nombre;
        fils = spheres < SPHERES_MIN ? 1 : Runtime.getRuntime().availableProcessors();
    }

    /** La construction de rang k. */
    abstract void faire(int k);

    /** Rend la main quand tout est fait. */
    final void tout() {
        Thread[] aides = new Thread[Math.min(fils, nombre) - 1];
        for (int k = 0; k < aides.length; k++) {
            aides[k] = new Thread(this, "preparation-" + (k + 1));
            aides[k].setDaemon(true);
            aides[k].start();
        }
        run();
        boolean interrompu = false;
        for (int k = 0; k < aides.length; ) {
            try {
                aides[k].join();
                k++;
            } catch (InterruptedException e) {
                interrompu = true;
            }
        }
        if (interrompu) {
            Thread.currentThread().interrupt();
        }
        if (echec instanceof Error) {
            throw (Error) echec;
        }
        if (echec != null) {
            throw (RuntimeException) echec;
        }
    }

    @Override
    public final void run() {
        try {
            for (int k = suivante.getAndIncrement(); k < nombre; k = suivante.getAndIncrement()) {
                faire(k);
            }
        } catch (RuntimeException | Error e) {
            echec = e;
        }
    }
}
