package lancer.correction.jugement;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.tools.ToolProvider;
import lancer.correction.Panne;
import lancer.correction.depot.Projet;
import lancer.correction.depot.Rendu;
import lancer.correction.enfant.Texte;
import lancer.correction.isolement.Arret;
import lancer.correction.isolement.Confinement;
import org.apache.commons.io.FileUtils;

/** Juge tous les rendus, plusieurs à la fois. */
public class Jury implements AutoCloseable {

    private static final int ENSEMBLE_MAX = 4;
    /** Durée permise à un rendu, en fois son temps de calcul : une machine chargée le fait attendre. */
    private static final int MUR = 10;

    final Machines machines;
    private final Path travail;
    /** Machines virtuelles de compilation disponibles. */
    private final Queue<Machines.Compilation> compilations = new ConcurrentLinkedQueue<>();
    private final Confinement confinement;
    private final long graine;
    /** Temps de calcul et de sommeil permis à un rendu, en secondes : chaque réponse a sa limite, mais leur somme n'en aurait pas. */
    int dureeMax = 300;
    private Reference reference;

    /**
     * @param graine le nombre d'où viennent les valeurs des vérifications
     * @throws Panne si cette machine ne peut juger
     */
    public Jury(Confinement confinement, long graine) {
        boolean sansCompilateur = ToolProvider.getSystemJavaCompiler() == null;
        if (Runtime.version().feature() < 17 || sansCompilateur) {
            throw new Panne(1, "la correction demande un JDK 17 ou plus récent ; ici : " + Runtime.version().feature()
                    + (sansCompilateur ? ", sans son compilateur" : ""));
        }
        this.confinement = confinement;
        this.graine = graine;
        try {
            travail = Files.createTempDirectory("correction").toRealPath();
            machines = new Machines(confinement, travail);
        } catch (IOException e) {
            throw new Panne(1, "dossier de travail inutilisable : " + e);
        }
    }

    /** Le corrigé, jugé une fois. */
    public Reference reference() {
        if (reference == null) {
            try {
                // la machine virtuelle qui a compilé le corrigé compile ensuite le premier rendu
                compilations.add(machines.new Compilation());
                reference = new Reference(machines, compilations.peek(), graine);
            } catch (Arret e) {
                throw new Panne(1, "le corrigé n'a pu être jugé : " + e.getMessage());
            }
        }
        return reference;
    }

    /** @param fini appelé pour chaque rendu jugé, dans un fil quelconque, l'un après l'autre */
    public void juger(List<Rendu> rendus, Consumer<Resultat> fini) {
        reference();
        ExecutorService ensemble = Executors.newFixedThreadPool(Math.min(ENSEMBLE_MAX, Runtime.getRuntime().availableProcessors()));
        try {
            List<Future<?>> promis = rendus.stream().map(rendu -> ensemble.submit(() -> {
                Resultat resultat = limiter(rendu);
                synchronized (this) {
                    fini.accept(resultat);
                }
                return resultat;
            })).collect(Collectors.toList());
            for (Future<?> un : promis) {
                un.get();
            }
        } catch (InterruptedException | ExecutionException e) {
            throw new Panne(1, "jugement interrompu : " + e);
        } finally {
            ensemble.shutdownNow();
        }
    }

    /** Juge un rendu dans un fil que l'on abandonne s'il dure trop. */
    private Resultat limiter(Rendu rendu) throws InterruptedException {
        Resultat resultat = new Resultat(rendu, confinement.manque);
        FutureTask<Resultat> tache = new FutureTask<>(() -> juger(rendu, resultat));
        Thread fil = new Thread(tache, "jury");
        fil.setDaemon(true);
        fil.start();
        try {
            for (long tours = 0; tours < MUR * dureeMax && resultat.depense.sum() <= dureeMax; tours++) {
                try {
                    return tache.get(1, TimeUnit.SECONDS);
                } catch (TimeoutException e) {
                    // elle n'a pas fini
                }
            }
            tache.cancel(true);
            return refuse(rendu, List.of("arrêté : plus de " + dureeMax + " s en tout"));
        } catch (ExecutionException e) {
            Throwable cause = e.getCause();
            boolean panne = cause instanceof Panne || cause instanceof OutOfMemoryError;
            String dite = Texte.protege(String.valueOf(cause instanceof Panne ? cause.getMessage() : cause));
            // un rendu qui fait échouer le correcteur n'empêche pas de juger les autres
            Resultat refus = refuse(rendu, List.of(panne ? "non corrigé : " + dite
                    : "arrêté : le correcteur n'a pas su le lire (" + dite + ")"));
            refus.nonCorrige = panne;
            return refus;
        }
    }

    private Resultat juger(Rendu rendu, Resultat resultat) {
        if (rendu.sources.isEmpty()) {
            return refuse(rendu, rendu.refus);
        }
        Machines.Compilation libre = compilations.poll();
        Machines.Compilation compilation = libre == null ? machines.new Compilation() : libre;
        try (JugeRendu juge = new JugeRendu(reference, compilation, machines, Projet.lire(rendu, compilation, reference.cours),
                resultat)) {
            juge.juger();
        } catch (Arret e) {
            return refuse(rendu, List.of(e.getMessage() + " (à la compilation, ou en prenant ses classes)"));
        } finally {
            compilations.add(compilation);
        }
        rendu.refus.forEach(resultat::regarder);
        Texte.abreger(resultat.remarques);
        Texte.abreger(resultat.aRegarder);
        Texte.abreger(resultat.fautes);
        return resultat;
    }

    private Resultat refuse(Rendu rendu, List<String> causes) {
        Resultat resultat = new Resultat(rendu, confinement.manque);
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
        FileUtils.deleteQuietly(travail.toFile());
    }
}
