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
import java.util.function.IntConsumer;

/**
 * Des fils qui se partagent des tâches numérotées : chaque fil prend la première tâche libre. Le premier échec, ou
 * l'interruption du fil appelant, les arrête tous. Un fil qui ne s'arrête pas est abandonné une seconde après, et
 * n'empêche pas la fin du programme. Une équipe fait un travail à la fois.
 */
public final class Equipe {

    /** Taille de la pile d'un fil, en octets : mille réflexions sont permises, et chacune demande deux appels. */
    private static final long PILE = 16 << 20;

    private final AtomicInteger suivante = new AtomicInteger();
    private final AtomicInteger faites = new AtomicInteger();
    private volatile int nombre = 1;
    private volatile boolean arretee;

    /** Exécute ce travail dans un fil. Voir {@link #faire(int, List)}. */
    public void faire(Runnable travail) {
        faire(1, Collections.singletonList(tache -> travail.run()));
    }

    /**
     * Exécute les tâches de 0 à {@code taches} − 1, et attend la fin des fils.
     *
     * @param ouvriers le travail de chaque fil sur une tâche
     * @throws CancellationException si le fil appelant est interrompu (il le reste), ou après un arrêt
     */
    public void faire(int taches, List<? extends IntConsumer> ouvriers) {
        obeir();
        nombre = taches;
        suivante.set(0);
        faites.set(0);
        AtomicInteger crees = new AtomicInteger();
        ExecutorService fils = Executors.newFixedThreadPool(ouvriers.size(), travail -> {
            Thread fil = new Thread(null, travail, "lancer-" + crees.incrementAndGet(), PILE);
            fil.setDaemon(true);
            return fil;
        });
        CompletionService<Void> finis = new ExecutorCompletionService<>(fils);
        boolean acheve = false;
        try {
            for (IntConsumer ouvrier : ouvriers) {
                finis.submit(() -> prendreLesTaches(ouvrier), null);
            }
            for (int k = 0; k < ouvriers.size(); k++) {
                finis.take().get();
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

    private void prendreLesTaches(IntConsumer ouvrier) {
        for (int k = suivante.getAndIncrement(); k < nombre; k = suivante.getAndIncrement()) {
            obeir();
            ouvrier.accept(k);
            faites.incrementAndGet();
        }
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

    /** La part des tâches faites du travail en cours ou, à défaut, du dernier, de 0 à 1. */
    public double getAvancement() {
        return (double) faites.get() / nombre;
    }
}
