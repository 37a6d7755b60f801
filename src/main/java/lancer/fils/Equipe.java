package lancer.fils;

import java.util.Collections;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.IntConsumer;

/**
 * Des fils qui se partagent des tâches numérotées : chaque fil prend la première tâche libre. Le premier échec les
 * arrête tous. Une équipe fait un travail à la fois.
 *
 * <p>Un fil qui ne s'arrête pas est abandonné une seconde après la demande. Il n'empêche pas la fin du programme.
 */
public final class Equipe {

    /** Temps entre deux observations des fils, et temps laissé à un fil pour s'arrêter, en millisecondes. */
    private static final long PERIODE_MS = 1000;

    private final String nom;
    private final Consumer<Fil> siLong;
    private final AtomicInteger suivante = new AtomicInteger();
    private final AtomicInteger faites = new AtomicInteger();
    private final List<Fil> fils = new CopyOnWriteArrayList<>();
    private volatile int nombre = 1;
    private volatile boolean arretee;
    private volatile Throwable echec;

    /** Une équipe dont les fils sont observés avec celui qui les crée. @param nom le début du nom des fils */
    public Equipe(String nom) {
        this(nom, null);
    }

    /** @param siLong reçoit une fois, parmi ces fils et ceux qu'ils créent, chacun dont le repère a dix secondes */
    public Equipe(String nom, Consumer<Fil> siLong) {
        this.nom = nom;
        this.siLong = siLong;
    }

    /** Exécute ce travail dans un fil. Voir {@link #faire(int, List)}. */
    public void faire(Runnable travail) {
        faire(1, Collections.singletonList(new IntConsumer() {
            @Override
            public void accept(int tache) {
                travail.run();
            }
        }));
    }

    /**
     * Exécute les tâches de 0 à {@code taches} − 1, et attend la fin des fils.
     *
     * @param ouvriers le travail de chaque fil sur une tâche
     * @throws CancellationException après {@link #arreter()}, ou si le fil appelant est interrompu (il le reste)
     */
    public void faire(int taches, List<? extends IntConsumer> ouvriers) {
        nombre = taches;
        suivante.set(0);
        faites.set(0);
        echec = null;
        fils.clear();
        List<Fil> observes = siLong == null ? null : new CopyOnWriteArrayList<>();
        try {
            for (IntConsumer ouvrier : ouvriers) {
                Fil fil = new Ouvrier(nom + "-" + (fils.size() + 1), observes, ouvrier);
                fil.start();
                fils.add(fil);
                if (arretee) {
                    fil.interrupt();
                }
            }
        } catch (RuntimeException | Error e) {
            // si un fil ne peut être créé, ceux qui sont partis doivent s'arrêter
            echouer(e);
        }
        attendre(observes);
        if (echec instanceof Error) {
            throw (Error) echec;
        }
        if (echec != null) {
            throw (RuntimeException) echec;
        }
        verifier();
    }

    private void echouer(Throwable e) {
        echec = e;
        arreter();
    }

    /** Attend la fin des fils, et observe leurs repères. L'interruption du fil appelant les arrête d'abord tous. */
    private void attendre(List<Fil> observes) {
        boolean interrompu = false;
        for (int k = 0; k < fils.size();) {
            boolean demande = arretee;
            try {
                fils.get(k).join(PERIODE_MS);
                if (!fils.get(k).isAlive()) {
                    k++;
                } else if (demande) {
                    k = fils.size();
                } else {
                    // le fil courant n'est pas retenu, il attend
                    Fil.signaler();
                    for (Fil fil : observes == null ? Collections.<Fil>emptyList() : observes) {
                        if (fil.dure()) {
                            siLong.accept(fil);
                        }
                    }
                }
            } catch (InterruptedException e) {
                interrompu = true;
                arreter();
            }
        }
        if (interrompu) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Abandonne le travail en cours et tous les suivants. Chaque fil est interrompu, et s'arrête quand il lit
     * l'interruption ({@link lancer.contrat.Recherche#obeir()}, {@link #verifier()}).
     */
    public void arreter() {
        arretee = true;
        for (Fil fil : fils) {
            fil.interrupt();
        }
    }

    /** @throws CancellationException si l'équipe est arrêtée */
    public void verifier() {
        if (arretee) {
            throw new CancellationException("travail arrêté");
        }
    }

    /** La part des tâches faites du travail en cours ou, à défaut, du dernier, de 0 à 1. */
    public double getAvancement() {
        return (double) faites.get() / nombre;
    }

    /** Un fil qui prend les tâches libres, jusqu'à la dernière. */
    private final class Ouvrier extends Fil {

        private final IntConsumer travail;

        Ouvrier(String nom, List<Fil> observes, IntConsumer travail) {
            super(nom, observes);
            this.travail = travail;
        }

        @Override
        public void run() {
            observes.add(this);
            try {
                for (int k = suivante.getAndIncrement(); k < nombre && !arretee; k = suivante.getAndIncrement()) {
                    travail.accept(k);
                    faites.incrementAndGet();
                }
            } catch (RuntimeException | Error e) {
                // un arrêt demandé n'est pas un échec
                if (!arretee || !(e instanceof CancellationException)) {
                    echouer(e);
                }
            } finally {
                observes.remove(this);
            }
        }
    }
}
