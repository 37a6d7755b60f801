package lancer.scene;

import java.lang.management.ManagementFactory;

/** La mémoire que demande un fil, comptée par la machine virtuelle : la même à chaque fois, au contraire d'un temps. */
final class Memoire {

    private static final com.sun.management.ThreadMXBean FILS = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();

    private Memoire() {
    }

    /** Ce que ce fil a demandé depuis qu'il vit, rendu ou non, en octets. */
    static long demandee() {
        return FILS.getThreadAllocatedBytes(Thread.currentThread().getId());
    }
}
