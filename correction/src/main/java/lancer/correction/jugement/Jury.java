package lancer.correction.jugement;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.Panne;
import lancer.correction.depot.Projet;
import lancer.correction.depot.Rendu;
import lancer.correction.isolement.Arret;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Limites;

/**
 * Juge tous les rendus, plusieurs à la fois, et se souvient de chacun : ce qui n'a pas changé n'est pas jugé de
 * nouveau.
 */
public final class Jury implements AutoCloseable {

    private static final int ENSEMBLE_MAX = 4;

    private final Path souvenirs;
    private final Machines machines;
    private final String regles;
    private final Reference reference;

    /** @param travail dossier de travail ; @throws Panne si la machine ne peut juger */
    public Jury(Path travail, Confinement confinement, Limites limites) {
        if (Runtime.version().feature() < 17) {
            throw new Panne(1, "la correction demande un JDK 17 ou plus récent ; ici : " + Runtime.version().feature());
        }
        this.souvenirs = travail.resolve("souvenirs");
        try {
            Files.createDirectories(souvenirs);
            machines = new Machines(confinement, limites, travail.resolve("machines"));
            String ici = confinement.estConfine() + " " + Runtime.version() + " " + duProgramme();
            regles = ici + " " + limites;
            String nom = "reference-" + hexa(sha256().digest(ici.getBytes(StandardCharsets.UTF_8)));
            reference = new Reference(machines, souvenirs.resolve(nom));
        } catch (IOException e) {
            throw new Panne(1, "dossier de travail inutilisable : " + e);
        } catch (Arret e) {
            throw new Panne(1, "le corrigé n'a pu être jugé : " + e.getMessage());
        }
    }

    /** L'empreinte de ce qui juge : un programme changé juge de nouveau. */
    private static String duProgramme() {
        Path lieu = Machines.lieu();
        MessageDigest calcul = sha256();
        try (Stream<Path> flux = Files.walk(lieu)) {
            for (Path fichier : flux.filter(Files::isRegularFile).sorted().collect(Collectors.toList())) {
                calcul.update(Files.readAllBytes(fichier));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return hexa(calcul.digest());
    }

    public Reference getReference() {
        return reference;
    }

    /** @param fini appelé pour chaque rendu, dès qu'il est jugé, avec son rang ; dans l'ordre où ils finissent */
    public List<Resultat> juger(List<Rendu> rendus, BiConsumer<Integer, Resultat> fini) {
        int ensemble = Math.max(1, Math.min(ENSEMBLE_MAX, Math.min(rendus.size(), Runtime.getRuntime()
                .availableProcessors())));
        ExecutorService equipe = Executors.newFixedThreadPool(ensemble, tache -> {
            Thread fil = new Thread(tache, "jury");
            fil.setDaemon(true);
            return fil;
        });
        BlockingQueue<Machines.Compilation> compilations = new LinkedBlockingQueue<>();
        for (int k = 0; k < ensemble; k++) {
            compilations.add(machines.new Compilation());
        }
        List<Future<Resultat>> promesses = new ArrayList<>();
        for (int k = 0; k < rendus.size(); k++) {
            int rang = k;
            promesses.add(equipe.submit(() -> {
                Machines.Compilation compilation = compilations.take();
                Resultat resultat;
                try {
                    resultat = juger(rendus.get(rang), compilation);
                } finally {
                    compilations.add(compilation);
                }
                synchronized (fini) {
                    fini.accept(rang, resultat);
                }
                return resultat;
            }));
        }
        equipe.shutdown();
        List<Resultat> resultats = new ArrayList<>();
        try {
            for (Future<Resultat> promesse : promesses) {
                resultats.add(promesse.get());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new Panne(1, "interrompu");
        } catch (ExecutionException e) {
            throw e.getCause() instanceof Panne ? (Panne) e.getCause()
                    : new Panne(1, "échec de la correction : " + e.getCause());
        } finally {
            compilations.forEach(Machines.Compilation::close);
        }
        return resultats;
    }

    private Resultat juger(Rendu rendu, Machines.Compilation compilation) throws IOException {
        if (!rendu.getRefus().isEmpty()) {
            return refuse(rendu, rendu.getRefus());
        }
        Path souvenir = souvenirs.resolve(empreinte(rendu));
        Object connu = Souvenirs.relire(souvenir);
        if (connu instanceof Resultat) {
            return (Resultat) connu;
        }
        Resultat resultat;
        try (Juge juge = new Juge(reference, new Chantier(compilation, reference.getAppels()), machines,
                Projet.lire(rendu))) {
            resultat = juge.juger();
        } catch (Arret e) {
            resultat = refuse(rendu, List.of("la compilation n'a pas abouti : " + e.getMessage()));
        } catch (RuntimeException | StackOverflowError e) {
            // un rendu que nous n'avons pas su traiter ne doit pas coûter leur note aux autres
            resultat = refuse(rendu, List.of("échec du correcteur sur ce rendu, à juger à la main : " + e));
        }
        Souvenirs.ecrire(souvenir, resultat);
        return resultat;
    }

    private static Resultat refuse(Rendu rendu, List<String> causes) {
        Resultat resultat = new Resultat();
        resultat.refus.addAll(causes);
        resultat.remarques.addAll(rendu.getRemarques());
        return resultat;
    }

    private String empreinte(Rendu rendu) {
        MessageDigest calcul = sha256();
        calcul.update(regles.getBytes(StandardCharsets.UTF_8));
        rendu.getRemarques().forEach(r -> calcul.update(r.getBytes(StandardCharsets.UTF_8)));
        for (Map.Entry<String, byte[]> source : rendu.getSources().entrySet()) {
            calcul.update((source.getKey() + "\0" + source.getValue().length + "\0").getBytes(StandardCharsets.UTF_8));
            calcul.update(source.getValue());
        }
        return hexa(calcul.digest());
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    private static String hexa(byte[] octets) {
        return String.format("%064x", new BigInteger(1, octets));
    }

    @Override
    public void close() {
        reference.close();
    }
}
