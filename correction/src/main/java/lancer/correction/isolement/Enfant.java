package lancer.correction.isolement;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.DoubleAdder;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.Panne;
import lancer.correction.enfant.Echange;

/**
 * Une autre machine virtuelle, qui traite une demande à la fois. Confinée, elle est un seul programme, dont le correcteur surveille le
 * temps de calcul, les réponses et les fils ; sinon, une durée est tout ce qui la limite. L'attente est comptée en tours de surveillance :
 * la mise en veille de la machine ne compte pas.
 *
 * <p>Les demandes sont numérotées. Une réponse inattendue ou trop longue n'est pas lue : cette machine virtuelle est arrêtée.
 */
public final class Enfant implements AutoCloseable {

    private static final long TOUR_MS = 100;
    private static final byte[] FIN = new byte[0];
    /** Taille, en octets, d'une demande que le tube d'un processus retient toujours : les précédentes ont été lues. */
    private static final int TUBE = 4000;
    /** Statut d'un programme que le système a tué, s'il ne se l'est pas donné lui-même. */
    private static final int TUE = 128 + 9;
    /** Temps permis sans rien faire, toutes demandes ensemble, en fois celui d'une demande. */
    private static final int SOMMEIL = 2;
    /** Nombre de tours permis sans rien faire à une machine qui en remplace une, arrêtée parce qu'elle dormait. */
    private static final int RESTE = 20;
    /** Numéro attendu entre deux demandes. */
    private static final int RIEN = 0;

    private final Process processus;
    private final Limites limites;
    private final boolean confine;
    private final BlockingQueue<byte[]> reponses = new LinkedBlockingQueue<>();
    /** Les programmes de cette machine : bwrap, deux fois, et Java. */
    private List<ProcessHandle> tous = List.of();
    private int demandes = RIEN;
    private volatile int attendu = RIEN;
    private volatile int longueurMax;
    private volatile boolean inattendu;
    private double calculMax;
    /** Secondes de calcul et de sommeil, de celle-ci et de celles qui en partagent le compte. */
    private DoubleAdder depense = new DoubleAdder();
    /** Nombre de tours passés sans rien faire, toutes demandes ensemble. */
    public int endormi;
    /** Temps de processeur au premier et au dernier contrôle de la demande, instants du commencement et du dernier contrôle. */
    private double debut;
    private double dernier;
    private long commencement;
    private long controle;

    public Enfant(List<String> commande, Limites limites, boolean confine) {
        this.limites = limites;
        this.confine = confine;
        CompletableFuture<Process> lancement = new CompletableFuture<>();
        Thread lecteur = new Thread(() -> lancer(commande, lancement), "lecteur");
        lecteur.setDaemon(true);
        lecteur.start();
        try {
            processus = lancement.join();
        } catch (CompletionException e) {
            throw new Panne(1, "une machine virtuelle n'a pas pu être lancée : " + e.getCause().getMessage());
        }
    }

    /** Lance le processus et lit ses réponses dans le même fil : bubblewrap est tué à la fin du fil qui l'a lancé. */
    private void lancer(List<String> commande, CompletableFuture<Process> lancement) {
        try {
            Process enfant = new ProcessBuilder(commande).redirectError(ProcessBuilder.Redirect.DISCARD).start();
            lancement.complete(enfant);
            lire(enfant.getInputStream());
        } catch (IOException | RuntimeException e) {
            // si le processus était déjà lancé, c'est la fin de ses réponses
            lancement.completeExceptionally(e);
        }
        reponses.add(FIN);
    }

    private void lire(InputStream flux) throws IOException {
        DataInputStream sortie = new DataInputStream(flux);
        while (!inattendu) {
            int numero = sortie.readInt();
            int longueur = sortie.readInt();
            inattendu = numero == RIEN || numero != attendu || longueur < 0 || longueur > longueurMax;
            if (!inattendu) {
                byte[] reponse = new byte[longueur];
                sortie.readFully(reponse);
                attendu = RIEN;
                reponses.add(reponse);
            }
        }
    }

    /** Commence une demande : le temps permis, en secondes, est compté à partir d'ici. */
    public void commencer(double calculPermis) {
        calculMax = calculPermis;
        debut = Double.NaN;
        commencement = System.nanoTime();
        controle = commencement;
    }

    /**
     * Envoie une demande, et attend sa réponse.
     *
     * @param max taille maximale de la réponse, en octets
     * @throws Arret si elle ne vient pas dans les limites ; la machine virtuelle est alors arrêtée
     */
    public DataInputStream demander(byte[] demande, int max) throws Arret {
        longueurMax = max;
        int numero = ++demandes;
        attendu = numero;
        if (demande.length <= TUBE) {
            envoyer(numero, demande);
        } else {
            // dans un autre fil : un rendu qui ne lit pas ses demandes ne bloque que lui
            CompletableFuture.runAsync(() -> envoyer(numero, demande));
        }
        return new DataInputStream(new ByteArrayInputStream(attendre()));
    }

    private void envoyer(int numero, byte[] demande) {
        try {
            Echange.envoyer(processus.getOutputStream(), numero, demande);
        } catch (IOException e) {
            // le processus est mort, ou ferme son entrée : l'attente le constatera
        }
    }

    private byte[] attendre() throws Arret {
        int immobile = 0;
        while (true) {
            byte[] reponse;
            try {
                reponse = reponses.poll(TOUR_MS, TimeUnit.MILLISECONDS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw arreter("interrompu");
            }
            if (reponse == FIN) {
                throw mort();
            }
            if (System.nanoTime() - controle > TOUR_MS * 1_000_000) {
                // une réponse est là depuis on ne sait combien de temps : ce fil-ci a pu attendre un cœur
                boolean travaille = controler() || reponse != null;
                immobile = travaille ? 0 : immobile + 1;
                endormi += travaille ? 0 : 1;
            }
            if (reponse != null) {
                return reponse;
            }
            limiter(immobile, limites.attente);
            limiter(endormi, SOMMEIL * limites.attente);
        }
    }

    /** @throws Arret si ces tours passés sans rien faire durent plus que ces secondes */
    private void limiter(int tours, double secondes) throws Arret {
        if (tours * TOUR_MS > 1000 * secondes) {
            throw arreter("arrêté : plus de " + (int) secondes + " s sans rien faire, bloqué ou endormi");
        }
    }

    /** @return vrai si le processus a calculé depuis le contrôle précédent, ou si cela ne se sait pas */
    private boolean controler() throws Arret {
        controle = System.nanoTime();
        if (!confine) {
            double permis = Limites.SANS_CONFINEMENT * calculMax;
            depense.add(TOUR_MS / 1e3);
            if (controle - commencement > permis * 1e9) {
                throw arreter("arrêté : plus de " + Math.round(permis) + " s, trop long ou sans fin");
            }
            return true;
        }
        if (tous.size() < 3) {
            tous = processus.descendants().collect(Collectors.toList());
            tous.add(processus.toHandle());
        }
        double maintenant = 0;
        for (ProcessHandle un : tous) {
            maintenant += mesurer(un);
        }
        boolean travaille = maintenant - dernier > TOUR_MS / 2e4 || attendUnCoeur();
        depense.add(maintenant - dernier + (travaille ? 0 : TOUR_MS / 1e3));
        dernier = maintenant;
        debut = Double.isNaN(debut) ? maintenant : debut;
        if (maintenant - debut > calculMax) {
            throw arreter("arrêté : plus de " + Math.round(calculMax) + " s de calcul, trop long ou sans fin");
        }
        return travaille;
    }

    /** Dit si un de ses fils attend un cœur, ou le disque, d'après le système : sur une machine chargée, ce n'est pas dormir. */
    private boolean attendUnCoeur() {
        return tous.stream().flatMap(un -> Stream.of(Objects.requireNonNullElse(taches(un).listFiles(), new File[0]))).anyMatch(fil -> {
            try {
                return Files.readString(fil.toPath().resolve("stat")).matches("(?s).*\\) [RD] .*");
            } catch (IOException e) {
                // il vient de finir
                return false;
            }
        });
    }

    private static File taches(ProcessHandle un) {
        return Path.of("/proc", String.valueOf(un.pid()), "task").toFile();
    }

    /** Temps de processeur d'un processus, en secondes. */
    private double mesurer(ProcessHandle un) throws Arret {
        String[] fils = taches(un).list();
        if (fils != null && fils.length > Limites.FILS) {
            throw arreter("arrêté : lance sans fin des fils");
        }
        return un.info().totalCpuDuration().orElse(Duration.ZERO).toNanos() / 1e9;
    }

    /** Arrête la machine virtuelle, dont la réponse n'est pas dans les limites. */
    public Arret arreter(String cause) {
        close();
        return new Arret(cause, false);
    }

    private Arret mort() {
        if (inattendu) {
            return arreter("arrêté : a répondu ce qu'on ne lui demandait pas");
        }
        int statut = -1;
        try {
            statut = processus.waitFor(1, TimeUnit.SECONDS) ? processus.exitValue() : -1;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        close();
        return new Arret("arrêté : s'est arrêté, statut " + statut, statut == TUE);
    }

    /** Celle-ci en remplace une autre, qui a passé tant de tours sans rien faire, et continue ce compte de secondes. */
    public void remplacer(int avant, DoubleAdder compte) {
        depense = compte;
        endormi = Math.max(0, Math.min(avant, (int) (1000 * SOMMEIL * limites.attente / TOUR_MS) - RESTE));
    }

    /** Tue la machine virtuelle et ses descendants. */
    @Override
    public void close() {
        List<ProcessHandle> descendance = processus.descendants().collect(Collectors.toList());
        processus.destroyForcibly();
        descendance.forEach(ProcessHandle::destroyForcibly);
    }
}
