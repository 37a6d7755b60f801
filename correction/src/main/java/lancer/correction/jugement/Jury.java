package lancer.correction.jugement;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.tools.ToolProvider;
import lancer.correction.Panne;
import lancer.correction.depot.Depot;
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
    /** Durée maximale d'un rendu, en secondes : chaque réponse a sa limite, mais leur somme n'en aurait pas. */
    private static final int ENTIER_MAX = 300;
    /** Propriété de Java que lit {@code lancer.Tests}. */
    private static final String GRAINE = "tests.graine";

    private final Machines machines;
    private final Limites limites;
    /** Machines virtuelles de compilation disponibles. */
    private final Queue<Machines.Compilation> compilations = new ConcurrentLinkedQueue<>();
    private final Confinement confinement;
    private final long graine;
    private Reference reference;

    /**
     * @param travail dossier de travail
     * @param graine le nombre d'où viennent les valeurs des vérifications
     * @throws Panne si cette machine ne peut juger
     */
    public Jury(Path travail, Confinement confinement, Limites limites, long graine) {
        boolean sansCompilateur = ToolProvider.getSystemJavaCompiler() == null;
        if (Runtime.version().feature() < 17 || sansCompilateur) {
            throw new Panne(1, "la correction demande un JDK 17 ou plus récent ; ici : " + Runtime.version().feature()
                    + (sansCompilateur ? ", sans son compilateur" : ""));
        }
        this.limites = limites;
        this.confinement = confinement;
        this.graine = graine;
        try {
            machines = new Machines(confinement, limites, travail.resolve("machines"));
        } catch (IOException e) {
            throw new Panne(1, "dossier de travail inutilisable : " + e);
        }
    }

    /** Lit les rendus d'une classe : voir {@link Depot#lire}. */
    public List<Rendu> lire(Path rendus) {
        if (!Files.isReadable(rendus)) {
            throw new Panne(2, "aucun rendu à cet endroit : " + rendus + " ; attendu : un dossier, ou un .zip");
        }
        try (Machines.Lecture lecture = machines.new Lecture(rendus.toRealPath())) {
            return Depot.lire(rendus, lecture);
        } catch (IOException e) {
            throw new Panne(2, "rendus illisibles : " + e.getMessage());
        }
    }

    /** Le corrigé, jugé une fois. */
    public Reference reference() {
        if (reference == null) {
            System.setProperty(GRAINE, String.valueOf(graine));
            try {
                // la machine virtuelle qui a compilé le corrigé compile ensuite le premier rendu
                compilations.add(machines.new Compilation());
                reference = new Reference(machines, compilations.peek(), confinement.manque, graine);
            } catch (Arret e) {
                throw new Panne(1, "le corrigé n'a pu être jugé : " + e.getMessage());
            }
        }
        return reference;
    }

    /** @param fini appelé pour chaque rendu jugé, dans un fil quelconque */
    public List<Resultat> juger(List<Rendu> rendus, Consumer<Resultat> fini) {
        reference();
        ExecutorService ensemble = Executors.newFixedThreadPool(Math.min(ENSEMBLE_MAX, Runtime.getRuntime().availableProcessors()));
        try {
            List<Future<Resultat>> premiers = rendus.stream().map(rendu -> ensemble.submit(() -> {
                Resultat resultat = surveiller(rendu);
                if (!resultat.nonCorrige) {
                    fini.accept(resultat);
                }
                return resultat;
            })).collect(Collectors.toList());
            List<Resultat> resultats = new ArrayList<>();
            for (Future<Resultat> premier : premiers) {
                resultats.add(premier.get());
            }
            for (int rang = 0; rang < resultats.size(); rang++) {
                if (resultats.get(rang).nonCorrige) {
                    // un autre rendu a pu prendre toutes les ressources : seul, celui-ci peut être jugé
                    resultats.set(rang, surveiller(rendus.get(rang)));
                    fini.accept(resultats.get(rang));
                }
            }
            return resultats;
        } catch (InterruptedException | ExecutionException e) {
            throw new Panne(1, "jugement interrompu : " + e);
        } finally {
            ensemble.shutdownNow();
        }
    }

    /** Juge un rendu dans son propre fil, qui est abandonné s'il ne finit pas. */
    private Resultat surveiller(Rendu rendu) throws InterruptedException {
        Machines.Compilation libre = compilations.poll();
        Machines.Compilation compilation = libre == null ? machines.new Compilation() : libre;
        AtomicReference<Resultat> resultat = new AtomicReference<>();
        Thread fil = new Thread(() -> {
            try {
                resultat.set(juger(rendu, compilation));
            } catch (Panne | OutOfMemoryError e) {
                resultat.set(refuse(rendu, List.of("non corrigé : "
                        + Echange.protege(String.valueOf(e instanceof Panne ? e.getMessage() : e)))));
                resultat.get().nonCorrige = true;
            } catch (Throwable e) {
                // un rendu qui fait échouer le correcteur n'empêche pas de juger les autres
                resultat.set(refuse(rendu, List.of("arrêté : le correcteur n'a pas su le lire (" + Echange.protege(e.toString()) + ")")));
            }
        }, "jury");
        fil.setDaemon(true);
        fil.start();
        String trop = "";
        for (long debut = System.nanoTime(); fil.isAlive() && trop.isEmpty(); fil.join(TOUR_MS)) {
            trop = ManagementFactory.getThreadMXBean().getThreadCpuTime(fil.getId()) > limites.propre * 1e9
                    ? Math.round(limites.propre) + " s de calcul du correcteur lui-même"
                    : System.nanoTime() - debut > ENTIER_MAX * 1e9
                    ? ENTIER_MAX + " s en tout" : "";
        }
        if (trop.isEmpty()) {
            compilations.add(compilation);
            return resultat.get();
        }
        fil.interrupt();
        compilation.close();
        return refuse(rendu, List.of("arrêté : plus de " + trop));
    }

    private Resultat juger(Rendu rendu, Machines.Compilation compilation) {
        if (rendu.sources.isEmpty()) {
            return refuse(rendu, rendu.refus);
        }
        Resultat resultat = null;
        try {
            // de plusieurs copies, celle qui réussit le plus de critères est gardée
            for (Projet copie : Projet.copies(rendu, compilation::lire, reference.squelette)) {
                try (JugeRendu juge = new JugeRendu(reference, compilation, machines, copie, new Resultat(rendu.id, rendu.nom))) {
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

    private static Resultat refuse(Rendu rendu, List<String> causes) {
        Resultat resultat = new Resultat(rendu.id, rendu.nom);
        resultat.refus.addAll(causes);
        resultat.remarques.addAll(rendu.remarques);
        return resultat;
    }

    @Override
    public void close() {
        compilations.forEach(Machines.Compilation::close);
        if (reference != null) {
            reference.close();
        }
        System.clearProperty(GRAINE);
    }
}
