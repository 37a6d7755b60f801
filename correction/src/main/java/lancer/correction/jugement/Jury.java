package lancer.correction.jugement;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
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

/**
 * Juge tous les rendus, plusieurs à la fois, et se souvient de chacun : ce qui n'a pas changé n'est pas jugé de
 * nouveau.
 */
public final class Jury implements AutoCloseable {

    private static final int ENSEMBLE_MAX = 4;
    private static final int TOUR_MS = 20;
    /** Durée permise à un rendu, en secondes : chacune de ses réponses à temps, leur somme serait sans fin. */
    private static final int ENTIER_MAX = 300;
    private static final ThreadMXBean FILS = ManagementFactory.getThreadMXBean();

    private final Path souvenirs;
    private final Machines machines;
    private final Limites limites;
    /** Machines qui compilent, et qu'aucun rendu n'occupe. */
    private final Deque<Machines.Compilation> compilations = new ArrayDeque<>();
    private final Set<Integer> abandonnes = new HashSet<>();
    /** Empreinte de ce qui juge : changé, il juge de nouveau. */
    private final String regles;
    public final Reference reference;
    /** Noms que l'enseignant déclare, lus à côté des pages quand on commence à juger. */
    public Alias alias;

    /** @param travail dossier de travail ; @throws Panne si la machine ne peut juger */
    public Jury(Path travail, Confinement confinement, Limites limites) {
        boolean sansCompilateur = ToolProvider.getSystemJavaCompiler() == null;
        if (Runtime.version().feature() < 17 || sansCompilateur) {
            throw new Panne(1, "la correction demande un JDK 17 ou plus récent ; ici : " + Runtime.version().feature()
                    + (sansCompilateur ? ", sans son compilateur" : ""));
        }
        this.limites = limites;
        this.souvenirs = travail.resolve("souvenirs");
        try {
            Files.createDirectories(souvenirs);
            machines = new Machines(confinement, limites, travail.resolve("machines"));
            regles = List.of(confinement.confine, Runtime.version(), limites.calcul, limites.attente, limites.memoire,
                    Files.getLastModifiedTime(Paths.get(Machines.lieu(Machines.class)))).toString();
            // chaud, ce qui a compilé le corrigé compile le premier rendu
            compilations.add(machines.new Compilation());
            reference = new Reference(machines, compilations.peek());
        } catch (IOException e) {
            throw new Panne(1, "dossier de travail inutilisable : " + e);
        } catch (Arret e) {
            throw new Panne(1, "le corrigé n'a pu être jugé : " + e.getMessage());
        }
    }

    /** @param fini appelé pour chaque rendu, dès qu'il est jugé, avec son rang ; dans l'ordre où ils finissent */
    public List<Resultat> juger(List<Rendu> rendus, BiConsumer<Integer, Resultat> fini) {
        alias = new Alias(souvenirs.resolve("../../alias.csv").normalize(), rendus.stream().map(r -> r.id).collect(Collectors.toList()));
        Resultat[] resultats = new Resultat[rendus.size()];
        try {
            List<Integer> rangs = IntStream.range(0, resultats.length).boxed().collect(Collectors.toList());
            // une panne peut venir d'un voisin qui prenait tout : seul, un rendu se juge peut-être
            for (boolean seul : new boolean[] {false, true}) {
                juger(rendus, rangs, seul ? 1 : Math.min(ENSEMBLE_MAX, Runtime.getRuntime().availableProcessors()), (rang, resultat) -> {
                    resultats[rang] = resultat;
                    if (seul || !resultat.nonCorrige || abandonnes.contains(rang)) {
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
                } catch (Throwable e) {
                    // quoi qu'il nous fasse, ce rendu ne coûte leur note qu'à lui
                    resultat = nonCorrige(rendu, String.valueOf(e instanceof Panne ? e.getMessage() : e));
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
            abandonnes.add(rang);
            fil.interrupt();
            compilation.close();
            return nonCorrige(rendu, propre ? "arrêté : plus de " + Math.round(limites.propre)
                    + " s de calcul du correcteur lui-même" : "arrêté : plus de " + ENTIER_MAX + " s en tout");
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

    private Resultat juger(Rendu rendu, Machines.Compilation compilation) throws IOException, GeneralSecurityException {
        if (!rendu.refus.isEmpty()) {
            return refuse(rendu, rendu.refus);
        }
        Path souvenir = souvenirs.resolve(empreinte(rendu));
        if (Files.exists(souvenir)) {
            return Resultat.lire(souvenir);
        }
        Resultat resultat = null;
        try {
            // de plusieurs copies, celle qui réussit le plus
            for (Projet copie : Projet.copies(rendu, compilation::lire, reference.cours, alias.de(rendu.id))) {
                try (Juge juge = new Juge(reference, compilation, machines, copie)) {
                    Resultat sien = juge.juger();
                    resultat = resultat == null || sien.reussis() > resultat.reussis() ? sien : resultat;
                }
            }
        } catch (Arret e) {
            return refuse(rendu, List.of(e.getMessage() + " (à la compilation)"));
        }
        Echange.abreger(resultat.remarques);
        Echange.abreger(resultat.aRegarder);
        Echange.abreger(resultat.fautes);
        resultat.ecrire(souvenir);
        return resultat;
    }

    private static Resultat nonCorrige(Rendu rendu, String cause) {
        Resultat resultat = refuse(rendu, List.of("non corrigé : " + Echange.protege(cause)));
        resultat.nonCorrige = true;
        return resultat;
    }

    private static Resultat refuse(Rendu rendu, List<String> causes) {
        Resultat resultat = new Resultat();
        resultat.refus.addAll(causes);
        resultat.remarques.addAll(rendu.remarques);
        return resultat;
    }

    private String empreinte(Rendu rendu) throws GeneralSecurityException {
        StringBuilder tout = new StringBuilder(regles + rendu.remarques + rendu.outils + rendu.bibliotheques + alias.de(rendu.id));
        rendu.sources.forEach((nom, texte) -> tout.append("\0").append(nom).append("\0")
                .append(new String(texte, StandardCharsets.ISO_8859_1)));
        byte[] calcul = MessageDigest.getInstance("SHA-256").digest(tout.toString().getBytes(StandardCharsets.UTF_8));
        return String.format("%064x", new BigInteger(1, calcul));
    }

    @Override
    public void close() {
        compilations.forEach(Machines.Compilation::close);
        reference.close();
    }
}
