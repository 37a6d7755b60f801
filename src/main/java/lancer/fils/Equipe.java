package lancer.fils;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;

/**
 * Fils qui se partagent des tâches numérotées : chacun prend la première que personne n'a prise, jusqu'à la
 * dernière. Le premier échec les arrête tous. Une équipe fait un travail à la fois.
 */
public final class Equipe {

    /** Pile d'un fil, en octets : mille réflexions sont permises, de deux appels chacune. */
    private static final long PILE = 16 << 20;

    private final String nom;
    private final AtomicInteger suivante = new AtomicInteger();
    private final AtomicInteger faites = new AtomicInteger();
    private final List<Thread> fils = new CopyOnWriteArrayList<>();
    private volatile boolean arretee;
    private volatile Throwable echec;

    /** @param nom le début du nom des fils */
    public Equipe(String nom) {
        this.nom = nom;
    }

    /**
     * Fait les tâches de 0 à {@code nombre} − 1, et rend la main quand aucun fil n'y travaille plus.
     *
     * @param ouvriers ce que fait chaque fil d'une tâche
     * @throws CancellationException si {@link #arreter()} a été appelé, ou le fil appelant interrompu (il le reste)
     */
    public void faire(int nombre, List<? extends IntConsumer> ouvriers) {
        suivante.set(0);
        faites.set(0);
        echec = null;
        fils.clear();
        try {
            for (IntConsumer ouvrier : ouvriers) {
                Thread fil = new Fil(nombre, ouvrier);
                fil.start();
                fils.add(fil);
                if (arretee) {
                    fil.interrupt();
                }
            }
        } catch (RuntimeException | Error e) {
            // plus de mémoire pour un fil : ceux qui sont partis ne doivent pas travailler sans nous
            echouer(e);
        }
        boolean interrompu = false;
        for (Thread fil : fils) {
            while (fil.isAlive()) {
                try {
                    fil.join();
                } catch (InterruptedException e) {
                    // on nous demande d'abandonner : les fils d'abord, ils s'arrêtent aussitôt
                    interrompu = true;
                    arreter();
                }
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
        verifier();
    }

    /**
     * Abandonne le travail en cours, et tous les suivants : chaque fil est interrompu, et s'arrête là où il y obéit
     * ({@link lancer.contrat.Recherche#obeir()}, {@link #verifier()}).
     */
    public void arreter() {
        arretee = true;
        for (Thread fil : fils) {
            fil.interrupt();
        }
    }

    /** @throws CancellationException si l'équipe est arrêtée */
    public void verifier() {
        if (arretee) {
            throw new CancellationException("travail arrêté");
        }
    }

    /** Le nombre de tâches faites, du travail en cours ou du dernier. */
    public int getFaites() {
        return faites.get();
    }

    private void echouer(Throwable e) {
        echec = e;
        arreter();
    }

    /** Un fil de l'équipe : il prend une tâche après l'autre. */
    private final class Fil extends Thread {

        private final int nombre;
        private final IntConsumer ouvrier;

        Fil(int nombre, IntConsumer ouvrier) {
            super(null, null, nom + "-" + (fils.size() + 1), PILE);
            this.nombre = nombre;
            this.ouvrier = ouvrier;
            setDaemon(true);
        }

        @Override
        public void run() {
            try {
                for (int k = suivante.getAndIncrement(); k < nombre && !arretee; k = suivante.getAndIncrement()) {
                    ouvrier.accept(k);
                    faites.incrementAndGet();
                }
            } catch (CancellationException e) {
                // arrêté ici ou ailleurs : celui qui a demandé l'arrêt le sait
            } catch (RuntimeException | Error e) {
                echouer(e);
            }
        }
    }
}
