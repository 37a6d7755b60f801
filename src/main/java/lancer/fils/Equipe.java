package lancer.fils;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;

/**
 * Fils qui se partagent des tâches numérotées : chacun prend la première que personne n'a prise, jusqu'à la
 * dernière. Le premier échec les arrête tous. Une équipe fait un travail à la fois.
 *
 * <p>Un fil qui n'avance pas pendant dix secondes est retenu. Quand tous ceux qui restent le sont, l'équipe échoue sans
 * les attendre : ils ne retiennent pas la machine virtuelle.
 */
public final class Equipe {

    /** Pile d'un fil, en octets : mille réflexions sont permises, de deux appels chacune. */
    private static final long PILE = 16 << 20;

    /** Temps après lequel un fil qui n'avance pas est retenu ; et celui où l'on attend de savoir s'il est le seul. */
    private static final long PATIENCE_NS = 10_000_000_000L;
    private static final long DOUTE_NS = 3_000_000_000L;

    /** Temps entre deux regards aux fils, en millisecondes. */
    private static final long PERIODE_MS = 1000;

    private final String nom;
    private final AtomicInteger suivante = new AtomicInteger();
    private final AtomicInteger faites = new AtomicInteger();
    private final List<Fil> fils = new CopyOnWriteArrayList<>();
    private volatile boolean arretee;
    private volatile Throwable echec;
    private boolean lenteurDite;
    /** Le temps passé à regarder les fils, et l'instant du dernier regard. */
    private long horloge;
    private long dernierRegard = System.nanoTime();

    /** @param nom le début du nom des fils */
    public Equipe(String nom) {
        this.nom = nom;
    }

    /**
     * Fait les tâches de 0 à {@code nombre} − 1, et rend la main quand aucun fil n'y travaille plus.
     *
     * @param ouvriers ce que fait chaque fil d'une tâche
     * @param calculs où l'on voit si le fil de même rang avance
     * @throws CancellationException si {@link #arreter()} a été appelé, ou le fil appelant interrompu (il le reste)
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
            // plus de mémoire pour un fil : ceux qui sont partis ne doivent pas travailler sans nous
            echouer(e);
        }
        boolean interrompu = false;
        for (Fil fil = vivant(); fil != null && !tousRetenus(); fil = vivant()) {
            try {
                fil.join(PERIODE_MS);
            } catch (InterruptedException e) {
                // on nous demande d'abandonner : les fils d'abord, ils s'arrêtent aussitôt
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

    /** Dit si aucun fil qui reste n'avance plus : c'est alors un échec. Un fil lent parmi d'autres se dit. */
    private boolean tousRetenus() {
        long regard = System.nanoTime();
        // une machine qui dort n'est pas un fil qui n'avance pas
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
     * Abandonne le travail en cours, et tous les suivants : chaque fil est interrompu, et s'arrête là où il y obéit
     * ({@link lancer.contrat.Recherche#obeir()}, {@link #verifier()}).
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
        private final Calcul calcul;
        /** Le calcul et le progrès vus la dernière fois, et depuis quand ils sont les mêmes. */
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
                // arrêté ici ou ailleurs : celui qui a demandé l'arrêt le sait
            } catch (RuntimeException | Error e) {
                echouer(e);
            }
        }
    }
}
