package lancer.correction.isolement;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lancer.correction.Panne;
import lancer.correction.enfant.Echange;

/**
 * Une machine virtuelle à part, à qui l'on demande une chose après l'autre. Elle est surveillée du dehors : ce qu'elle
 * calcule, ce qu'elle écrit, combien de processus elle lance. Le temps d'attente se compte en tours de la surveillance,
 * non à l'horloge : une machine suspendue puis reprise n'a pas attendu.
 *
 * <p>Les demandes sont numérotées. Ce qui vient sans avoir été demandé, ou plus gros qu'il n'est permis, n'est pas lu :
 * c'est la fin de cette machine, qui ne répond plus à rien.
 */
public final class Enfant implements AutoCloseable {

    private static final long TOUR_MS = 100;
    private static final long PAGE = 4096;
    /** Unités de temps par seconde, dans ce que dit Linux (sysconf, {@code _SC_CLK_TCK}). */
    private static final double TICS = 100;
    /** Mémoire que prennent, en plus de la mémoire de Java, la machine virtuelle et les programmes qu'elle lance. */
    private static final long HORS_DU_TAS = 400;
    private static final byte[] FIN = new byte[0];
    /** Statut de qui est tué, par le système qui n'a plus de mémoire ou par une main. */
    private static final int TUE = 128 + 9;
    /** Le numéro attendu quand rien n'est demandé. */
    private static final int RIEN = 0;

    private final Process processus;
    private final Limites limites;
    private final BlockingQueue<byte[]> reponses = new LinkedBlockingQueue<>();
    /** Fil qui écrit les demandes : un rendu qui n'en lirait aucune ne doit bloquer que lui. */
    private final ExecutorService ecrivain = Executors.newSingleThreadExecutor(tache -> fil(tache, "écrivain"));
    private int demandes = RIEN;
    private volatile int attendu = RIEN;
    private volatile int longueurMax;
    private volatile boolean inattendu;
    private double calculMax;
    /** Le temps de processeur au premier contrôle de la demande, et au dernier ; quand celui-ci a eu lieu. */
    private double debut;
    private double dernier;
    private long controle;
    /** Nombre de fils et mémoire tenue, en octets, au dernier contrôle. */
    private int fils;
    private long tenue;

    public Enfant(List<String> commande, Limites limites) {
        this.limites = limites;
        CompletableFuture<Process> lancement = new CompletableFuture<>();
        fil(() -> lancer(commande, lancement), "lecteur").start();
        try {
            processus = lancement.join();
        } catch (CompletionException e) {
            throw new Panne(1, "une machine virtuelle n'a pas pu être lancée : " + e.getCause().getMessage());
        }
    }

    private static Thread fil(Runnable tache, String nom) {
        Thread fil = new Thread(tache, nom);
        fil.setDaemon(true);
        return fil;
    }

    /** Lance, et lit jusqu'à la fin, dans le même fil : bubblewrap est tué quand finit celui qui l'a lancé. */
    private void lancer(List<String> commande, CompletableFuture<Process> lancement) {
        try {
            Process enfant = new ProcessBuilder(commande).redirectError(ProcessBuilder.Redirect.DISCARD).start();
            lancement.complete(enfant);
            lire(enfant.getInputStream());
        } catch (IOException | RuntimeException e) {
            // lancé, il est mort : c'est la fin, elle aussi
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

    /** Une demande commence : le temps de processeur permis, en secondes, se compte à partir d'ici. */
    public void commencer(double calculPermis) {
        calculMax = calculPermis;
        debut = Double.NaN;
        controle = System.nanoTime();
    }

    /**
     * Envoie une demande, et attend sa réponse.
     *
     * @param max ce que la réponse peut peser, en octets
     * @throws Arret si elle ne vient pas dans les limites ; la machine est alors arrêtée
     */
    public DataInputStream demander(byte[] demande, int max) throws Arret {
        longueurMax = max;
        int numero = ++demandes;
        attendu = numero;
        ecrivain.execute(() -> {
            try {
                Echange.envoyer(processus.getOutputStream(), numero, demande);
            } catch (IOException e) {
                // il est mort, ou ferme son entrée : l'attente le dira
            }
        });
        return new DataInputStream(new ByteArrayInputStream(attendre()));
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
                immobile = controler() ? 0 : immobile + 1;
            }
            if (reponse != null) {
                return reponse;
            }
            if (immobile * TOUR_MS > 1000 * limites.attente) {
                throw arreter("arrêté : plus de " + (int) limites.attente + " s sans rien faire, bloqué ou endormi");
            }
        }
    }

    /** @return vrai si l'enfant a calculé depuis le contrôle précédent */
    private boolean controler() throws Arret {
        List<ProcessHandle> tous = processus.descendants().collect(Collectors.toList());
        if (tous.size() > Limites.PROCESSUS) {
            throw arreter("arrêté : lance sans fin d'autres programmes");
        }
        tous.add(processus.toHandle());
        tenue = 0;
        fils = 0;
        double maintenant = tous.stream().mapToDouble(this::mesurer).sum();
        if (fils > Limites.FILS) {
            throw arreter("arrêté : lance sans fin des fils");
        }
        boolean travaille = !(maintenant - dernier <= TOUR_MS / 2e4);
        dernier = maintenant;
        controle = System.nanoTime();
        debut = Double.isNaN(debut) ? maintenant : debut;
        if (maintenant - debut > calculMax) {
            throw arreter("arrêté : plus de " + Math.round(calculMax) + " s de calcul, une boucle sans fin ?");
        }
        if (tenue > (limites.memoire + HORS_DU_TAS) << 20) {
            throw arreter("arrêté : mémoire épuisée");
        }
        return travaille;
    }

    /** Temps de processeur, en secondes, d'un processus et de ceux qu'il a lancés et qui ont fini (proc(5), {@code stat}). */
    private double mesurer(ProcessHandle processus) {
        try {
            String stat = Files.readString(Paths.get("/proc", "" + processus.pid(), "stat"), StandardCharsets.ISO_8859_1);
            // après le nom, où un programme met ce qu'il veut
            String[] champs = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
            fils += Integer.parseInt(champs[17]);
            tenue += Long.parseLong(champs[21]) * PAGE;
            return IntStream.range(11, 15).mapToLong(k -> Long.parseLong(champs[k])).sum() / TICS;
        } catch (IOException | RuntimeException e) {
            // il a fini, ou ce système ne le dit pas ainsi
            return processus.info().totalCpuDuration().orElse(Duration.ZERO).toMillis() / 1e3;
        }
    }

    /** Arrête la machine, qui n'a pas répondu comme il le fallait. */
    public Arret arreter(String cause) {
        close();
        return new Arret(cause, false);
    }

    private Arret mort() {
        int statut = -1;
        try {
            statut = processus.waitFor(1, TimeUnit.SECONDS) ? processus.exitValue() : -1;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        close();
        return inattendu ? new Arret("arrêté : a répondu ce qu'on ne lui demandait pas", false)
                : statut == 3 ? new Arret("arrêté : mémoire épuisée", false)
                : new Arret("arrêté : il s'est arrêté de lui-même (System.exit ?), statut " + statut, statut == TUE);
    }

    /** Tue la machine virtuelle, et tout ce qu'elle a lancé. */
    @Override
    public void close() {
        ecrivain.shutdownNow();
        List<ProcessHandle> descendance = processus.descendants().collect(Collectors.toList());
        processus.destroyForcibly();
        descendance.forEach(ProcessHandle::destroyForcibly);
    }
}
