package lancer.scene;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;

/** La mémoire que demande un fil, comptée par la machine virtuelle : la même à chaque fois, au contraire d'un temps. */
final class Memoire {

    /**
     * Octets demandés à la mémoire par octet lu, rendus ou non : un caractère nul en devient six, passés plusieurs fois de main en main.
     * S'y ajoutent le tampon de lecture et la recherche des variantes.
     */
    private static final long PAR_OCTET = 400;
    private static final long FIXE = 1 << 20;

    private static final com.sun.management.ThreadMXBean FILS = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();

    private Memoire() {
    }

    /** Ce que ce fil a demandé depuis qu'il vit, rendu ou non, en octets. */
    static long demandee() {
        return FILS.getThreadAllocatedBytes(Thread.currentThread().getId());
    }

    /** Depuis {@code avant}, ce fil n'a pas demandé plus que ne vaut la lecture d'un fichier de cette taille. */
    static void verifier(long avant, long taille, String cas) {
        long memoire = demandee() - avant;
        assertTrue(memoire <= FIXE + PAR_OCTET * taille, cas + " : " + memoire + " octets de mémoire");
    }
}
