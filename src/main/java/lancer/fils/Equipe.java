package lancer.fils;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;

/**
 * Des fils qui se partagent des tâches numérotées : chaque fil prend la première tâche libre. Le premier échec les
 * arrête tous. Une équipe fait un travail à la fois.
 *
 * <p>Un fil qui n'avance pas pendant dix secondes est retenu. Si tous les fils restants sont retenus, l'équipe échoue
 * sans les attendre. Ils n'empêchent pas l'arrêt du programme.
 */
public final class Equipe {

    /** Pile d'un fil, en octets : mille réflexions sont permises, et chacune demande deux appels. */
    private static final long PILE = 16 << 20;

    /** Durée d'immobilité après laquelle un fil est retenu, et durée au-dessous de laquelle il avance. */
    private static final long PATIENCE_NS = 10_000_000_000L;
    private static final long DOUTE_NS = 3_000_000_000L;

    /** Temps entre deux observations des fils, en millisecondes. */
    private static final long PERIODE_MS = 1000;

    private final String nom;
    private final AtomicInteger suivante = new AtomicInteger();
    private final AtomicInteger faites = new AtomicInteger();
    private final List<Fil> fils = new CopyOnWriteArrayList<>();
    private volatile boolean arretee;
    private volatile Throwable echec;
    private boolean lenteurDite;
    /** Temps total d'observation, et instant de la dernière observation. */
    private long horloge;
    private long dernierRegard = System.nanoTime();

    /** @param nom le début du nom des fils */
    public Equipe(String nom) {
        this.nom = nom;
    }

    /**
     * Exécute les tâches de 0 à {@code nombre} − 1, et attend la fin des fils.
     *
     * @param ouvriers le travail de chaque fil sur une tâche
     * @param calculs le calcul observé de chaque fil
     * @throws CancellationException après {@link #arreter()}, ou si le fil appelant est interrompu (il le reste)
     */
    public void faire(int nombre, List<? extends IntConsumer> ouvriers, List<? extends Calcul> calculs) {
        suivante.set(0);
        faites.set(0);
        echec = null;
        fils.clear();
        try {
            for (int k = 0; k < ouvriers.size(); k++) {
                Fil fil = new Fil(nombre, ouvriers.get(k), calculs.get(k));
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
        boolean interrompu = false;
        for (Fil fil = vivant(); fil != null && !tousRetenus(); fil = vivant()) {
            try {
                fil.join(PERIODE_MS);
            } catch (InterruptedException e) {
                // l'interruption du fil appelant arrête d'abord tous les autres
                interrompu = true;
                arreter();
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

    private Fil vivant() {
        for (Fil fil : fils) {
            if (fil.isAlive()) {
                return fil;
            }
        }
        return null;
    }

    /** Dit si tous les fils restants sont retenus : c'est un échec. Signale aussi un fil lent parmi d'autres. */
    private boolean tousRetenus() {
        long regard = System.nanoTime();
        // la mise en veille de la machine n'est pas une immobilité des fils
        horloge += Math.min(regard - dernierRegard, DOUTE_NS);
        dernierRegard = regard;
        boolean tous = true;
        boolean unAvance = false;
        Fil lent = null;
        for (Fil fil : fils) {
            if (fil.isAlive()) {
                fil.regarder();
                tous &= horloge - fil.immobile >= PATIENCE_NS;
                unAvance |= horloge - fil.immobile < DOUTE_NS;
                lent = horloge - fil.arrive >= PATIENCE_NS ? fil : lent;
            }
        }
        if (lent != null && tous && !arretee) {
            echouer(lent.calcul.nommer(new Retenu(lent)));
        } else if (lent != null && unAvance && !lenteurDite) {
            lenteurDite = true;
            lent.calcul.ralentir(new Retenu(lent));
        }
        return tous;
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

    /** Le nombre de tâches faites du travail en cours ou, à défaut, du dernier. */
    public int getFaites() {
        return faites.get();
    }

    private void echouer(Throwable e) {
        echec = e;
        arreter();
    }

    private final class Fil extends Thread {

        private final int nombre;
        private final IntConsumer ouvrier;
        private final Calcul calcul;
        /** Calcul et progrès à la dernière observation, et instants de leurs derniers changements. */
        private long lieu;
        private long progres;
        private long arrive = horloge;
        private long immobile = horloge;

        Fil(int nombre, IntConsumer ouvrier, Calcul calcul) {
            super(null, null, nom + "-" + (fils.size() + 1), PILE);
            this.nombre = nombre;
            this.ouvrier = ouvrier;
            this.calcul = calcul;
            setDaemon(true);
        }

        private void regarder() {
            long ici = calcul.getLieu();
            long fait = calcul.getProgres(this);
            arrive = ici == lieu ? arrive : horloge;
            immobile = ici == lieu && fait == progres ? immobile : horloge;
            lieu = ici;
            progres = fait;
        }

        @Override
        public void run() {
            try {
                for (int k = suivante.getAndIncrement(); k < nombre && !arretee; k = suivante.getAndIncrement()) {
                    ouvrier.accept(k);
                    faites.incrementAndGet();
                }
            } catch (CancellationException e) {
                // un arrêt demandé n'est pas un échec
            } catch (RuntimeException | Error e) {
                echouer(e);
            }
        }
    }
}
