package lancer.fils;

import java.util.Collections;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletionService;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorCompletionService;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Des fils qui se partagent des tâches numérotées : chaque fil prend la première tâche libre. Le premier échec, ou
 * l'interruption du fil appelant, les arrête tous. Un fil qui ne s'arrête pas est abandonné une seconde après, et
 * n'empêche pas la fin du programme. Une équipe fait un travail à la fois.
 */
public final class Equipe {

    /** Taille de la pile d'un fil, en octets : mille réflexions sont permises, et chacune demande deux appels. */
    private static final long PILE = 16 << 20;

    private final AtomicInteger prochaineTache = new AtomicInteger();
    private volatile boolean arretee;

    /** Exécute ce travail dans un fil. Voir {@link #faire(List)}. */
    public void faire(Runnable travail) {
        faire(Collections.singletonList(travail));
    }

    /**
     * Exécute chacun de ces travaux dans un fil, et attend leur fin. Ils se partagent les tâches, à partir de 0.
     *
     * @throws CancellationException si le fil appelant est interrompu (il le reste), ou après un arrêt
     */
    public void faire(List<? extends Runnable> travaux) {
        obeir();
        prochaineTache.set(0);
        AtomicInteger nombreDeFils = new AtomicInteger();
        ExecutorService fils = Executors.newFixedThreadPool(travaux.size(), travail -> {
            Thread fil = new Thread(null, travail, "lancer-" + nombreDeFils.incrementAndGet(), PILE);
            fil.setDaemon(true);
            return fil;
        });
        CompletionService<Void> achevements = new ExecutorCompletionService<>(fils);
        boolean acheve = false;
        try {
            for (Runnable travail : travaux) {
                achevements.submit(travail, null);
            }
            for (int k = 0; k < travaux.size(); k++) {
                achevements.take().get();
            }
            acheve = true;
        } catch (ExecutionException e) {
            if (e.getCause() instanceof Error) {
                throw (Error) e.getCause();
            }
            throw (RuntimeException) e.getCause();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CancellationException("travail interrompu");
        } finally {
            arretee = !acheve;
            fils.shutdownNow();
            laisserUneSeconde(fils);
        }
    }

    /** Le numéro de la première tâche que nul n'a prise. @throws CancellationException si l'équipe est arrêtée */
    public int prendre() {
        obeir();
        return prochaineTache.getAndIncrement();
    }

    /** Attend la fin de ces fils, une seconde au plus ; l'interruption du fil appelant est gardée pour la suite. */
    private static void laisserUneSeconde(ExecutorService fils) {
        boolean interrompu = Thread.interrupted();
        try {
            fils.awaitTermination(1, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            interrompu = true;
        }
        if (interrompu) {
            Thread.currentThread().interrupt();
        }
    }

    /** @throws CancellationException si l'équipe est arrêtée */
    public void obeir() {
        if (arretee) {
            throw new CancellationException("travail arrêté");
        }
    }
}
