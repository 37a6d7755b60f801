package lancer.correction.jugement;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.tools.ToolProvider;
import lancer.correction.Panne;
import lancer.correction.depot.Alias;
import lancer.correction.depot.Projet;
import lancer.correction.depot.Rendu;
import lancer.correction.enfant.Echange;
import lancer.correction.isolement.Arret;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Limites;

/** Juge tous les rendus, plusieurs à la fois. */
public final class Jury implements AutoCloseable {

    private static final int ENSEMBLE_MAX = 4;
    private static final int TOUR_MS = 20;
    /** Durée permise à un rendu, en secondes : chacune de ses réponses à temps, leur somme serait sans fin. */
    private static final int ENTIER_MAX = 300;
    /** Propriété où {@code lancer.Tests} lit la sienne. */
    private static final String GRAINE = "tests.graine";
    private static final ThreadMXBean FILS = ManagementFactory.getThreadMXBean();

    private final Machines machines;
    private final Limites limites;
    /** Machines qui compilent, et qu'aucun rendu n'occupe. */
    private final Deque<Machines.Compilation> compilations = new ArrayDeque<>();
    public final Reference reference;
    /** Noms que l'enseignant déclare. */
    private Alias alias;

    /**
     * @param travail dossier de travail
     * @param graine le nombre d'où viennent les valeurs des vérifications
     * @throws Panne si la machine ne peut juger
     */
    public Jury(Path travail, Confinement confinement, Limites limites, long graine) {
        boolean sansCompilateur = ToolProvider.getSystemJavaCompiler() == null;
        if (Runtime.version().feature() < 17 || sansCompilateur) {
            throw new Panne(1, "la correction demande un JDK 17 ou plus récent ; ici : " + Runtime.version().feature()
                    + (sansCompilateur ? ", sans son compilateur" : ""));
        }
        this.limites = limites;
        System.setProperty(GRAINE, String.valueOf(graine));
        try {
            machines = new Machines(confinement, limites, travail.resolve("machines"));
            // chaud, ce qui a compilé le corrigé compile le premier rendu
            compilations.add(machines.new Compilation());
            reference = new Reference(machines, compilations.peek(), confinement.manque, graine);
        } catch (IOException e) {
            throw new Panne(1, "dossier de travail inutilisable : " + e);
        } catch (Arret e) {
            throw new Panne(1, "le corrigé n'a pu être jugé : " + e.getMessage());
        }
    }

    /** @param fini appelé pour chaque rendu, dès qu'il est jugé, avec son rang ; dans l'ordre où ils finissent */
    public List<Resultat> juger(List<Rendu> rendus, Alias declares, BiConsumer<Integer, Resultat> fini) {
        alias = declares;
        Resultat[] resultats = new Resultat[rendus.size()];
        try {
            List<Integer> rangs = IntStream.range(0, resultats.length).boxed().collect(Collectors.toList());
            // une panne peut venir d'un voisin qui prenait tout : seul, un rendu se juge peut-être
            for (boolean seul : new boolean[] {false, true}) {
                juger(rendus, rangs, seul ? 1 : Math.min(ENSEMBLE_MAX, Runtime.getRuntime().availableProcessors()), (rang, resultat) -> {
                    resultats[rang] = resultat;
                    if (seul || !resultat.nonCorrige) {
                        rangs.remove(rang);
                        fini.accept(rang, resultat);
                    }
                });
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new Panne(1, "interrompu");
        }
        return Arrays.asList(resultats);
    }

    /** Un rendu en train d'être jugé, dans son propre fil : s'il n'en finit pas, on l'y laisse. */
    private final class Rangee {

        private final int rang;
        private final Machines.Compilation compilation;
        private final Thread fil;
        private final long debut = System.nanoTime();
        private volatile Resultat resultat;

        Rangee(int rang, Rendu rendu, Machines.Compilation compilation) {
            this.rang = rang;
            this.compilation = compilation;
            fil = new Thread(() -> {
                try {
                    resultat = juger(rendu, compilation);
                } catch (Panne | OutOfMemoryError e) {
                    resultat = nonCorrige(rendu, String.valueOf(e instanceof Panne ? e.getMessage() : e));
                } catch (Throwable e) {
                    // quoi qu'il nous fasse, ce rendu ne coûte sa note qu'à lui
                    resultat = refuse(rendu, List.of("arrêté : le correcteur n'a pas su le lire (" + Echange.protege(e.toString()) + ")"));
                }
            }, "jury");
            fil.setDaemon(true);
            fil.start();
        }

        /** @return ce qu'on en a trouvé, {@code null} s'il faut encore attendre */
        Resultat attendre(Rendu rendu) throws InterruptedException {
            fil.join(TOUR_MS);
            boolean propre = FILS.getThreadCpuTime(fil.getId()) > limites.propre * 1e9;
            if (resultat != null || !propre && System.nanoTime() - debut < ENTIER_MAX * 1e9) {
                return resultat;
            }
            fil.interrupt();
            compilation.close();
            return refuse(rendu, List.of(propre ? "arrêté : plus de " + Math.round(limites.propre)
                    + " s de calcul du correcteur lui-même" : "arrêté : plus de " + ENTIER_MAX + " s en tout"));
        }
    }

    private void juger(List<Rendu> rendus, List<Integer> rangs, int ensemble, BiConsumer<Integer, Resultat> fini)
            throws InterruptedException {
        Deque<Integer> file = new ArrayDeque<>(rangs);
        List<Rangee> enCours = new ArrayList<>();
        while (!file.isEmpty() || !enCours.isEmpty()) {
            while (enCours.size() < ensemble && !file.isEmpty()) {
                Machines.Compilation libre = compilations.isEmpty() ? machines.new Compilation() : compilations.poll();
                enCours.add(new Rangee(file.peek(), rendus.get(file.poll()), libre));
            }
            for (Rangee rangee : List.copyOf(enCours)) {
                Resultat resultat = rangee.attendre(rendus.get(rangee.rang));
                if (resultat != null) {
                    enCours.remove(rangee);
                    if (resultat == rangee.resultat) {
                        compilations.add(rangee.compilation);
                    }
                    fini.accept(rangee.rang, resultat);
                }
            }
        }
    }

    private Resultat juger(Rendu rendu, Machines.Compilation compilation) {
        if (rendu.sources.isEmpty()) {
            return refuse(rendu, rendu.refus);
        }
        Resultat resultat = null;
        try {
            // de plusieurs copies, celle qui réussit le plus
            for (Projet copie : Projet.copies(rendu, compilation::lire, reference.cours, alias.de(rendu.id))) {
                try (Juge juge = new Juge(reference, compilation, machines, copie, new Resultat(rendu.id, rendu.nom))) {
                    Resultat sien = juge.juger();
                    resultat = resultat == null || sien.reussis() > resultat.reussis() ? sien : resultat;
                }
            }
        } catch (Arret e) {
            return refuse(rendu, List.of(e.getMessage() + " (à la compilation, ou en prenant ses classes)"));
        }
        rendu.refus.forEach(resultat::regarder);
        Echange.abreger(resultat.remarques);
        Echange.abreger(resultat.aRegarder);
        Echange.abreger(resultat.fautes);
        return resultat;
    }

    private static Resultat nonCorrige(Rendu rendu, String cause) {
        Resultat resultat = refuse(rendu, List.of("non corrigé : " + Echange.protege(cause)));
        resultat.nonCorrige = true;
        return resultat;
    }

    private static Resultat refuse(Rendu rendu, List<String> causes) {
        Resultat resultat = new Resultat(rendu.id, rendu.nom);
        resultat.refus.addAll(causes);
        resultat.remarques.addAll(rendu.remarques);
        return resultat;
    }

    @Override
    public void close() {
        compilations.forEach(Machines.Compilation::close);
        reference.close();
        System.clearProperty(GRAINE);
    }
}
