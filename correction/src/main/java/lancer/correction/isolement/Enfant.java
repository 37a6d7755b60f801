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
 * Une autre machine virtuelle, qui traite une demande à la fois. Le correcteur surveille son temps de calcul, ses réponses et le nombre de
 * ses processus. L'attente est comptée en tours de surveillance, et non en temps réel : la mise en veille de la machine ne compte pas.
 *
 * <p>Les demandes sont numérotées. Une réponse inattendue ou trop longue n'est pas lue : cette machine virtuelle est arrêtée.
 */
public final class Enfant implements AutoCloseable {

    private static final long TOUR_MS = 100;
    private static final long PAGE = 4096;
    /** Unités de temps par seconde de Linux (sysconf, {@code _SC_CLK_TCK}). */
    private static final double TICS = 100;
    /** Mémoire de la machine virtuelle hors du tas et de ses programmes, en mégaoctets. */
    private static final long HORS_DU_TAS = 400;
    private static final byte[] FIN = new byte[0];
    /** Statut d'un processus tué, par le système à court de mémoire ou par un utilisateur. */
    private static final int TUE = 128 + 9;
    /** Numéro attendu entre deux demandes. */
    private static final int RIEN = 0;

    private final Process processus;
    private final Limites limites;
    private final BlockingQueue<byte[]> reponses = new LinkedBlockingQueue<>();
    /** Fil qui écrit les demandes : un rendu qui ne les lit pas ne bloque que ce fil. */
    private final ExecutorService ecrivain = Executors.newSingleThreadExecutor(tache -> fil(tache, "écrivain"));
    private int demandes = RIEN;
    private volatile int attendu = RIEN;
    private volatile int longueurMax;
    private volatile boolean inattendu;
    private double calculMax;
    /** Temps de processeur au premier et au dernier contrôle de la demande ; instant du dernier. */
    private double debut;
    private double dernier;
    private long controle;
    /** Nombre de fils, et mémoire en octets, au dernier contrôle. */
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

    /** Commence une demande : le temps de processeur permis, en secondes, est compté à partir d'ici. */
    public void commencer(double calculPermis) {
        calculMax = calculPermis;
        debut = Double.NaN;
        controle = System.nanoTime();
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
        ecrivain.execute(() -> {
            try {
                Echange.envoyer(processus.getOutputStream(), numero, demande);
            } catch (IOException e) {
                // le processus est mort, ou ferme son entrée : l'attente le constatera
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

    /** @return vrai si le processus a calculé depuis le contrôle précédent */
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

    /** Temps de processeur, en secondes, d'un processus et de ses descendants finis (proc(5), {@code stat}). */
    private double mesurer(ProcessHandle processus) {
        try {
            String stat = Files.readString(Paths.get("/proc", "" + processus.pid(), "stat"), StandardCharsets.ISO_8859_1);
            // le nom du programme, qui précède, peut contenir n'importe quel caractère
            String[] champs = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
            fils += Integer.parseInt(champs[17]);
            tenue += Long.parseLong(champs[21]) * PAGE;
            return IntStream.range(11, 15).mapToLong(k -> Long.parseLong(champs[k])).sum() / TICS;
        } catch (IOException | RuntimeException e) {
            // le processus est fini, ou ce système n'a pas /proc
            return processus.info().totalCpuDuration().orElse(Duration.ZERO).toMillis() / 1e3;
        }
    }

    /** Arrête la machine virtuelle, dont la réponse n'est pas dans les limites. */
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

    /** Tue la machine virtuelle et ses descendants. */
    @Override
    public void close() {
        ecrivain.shutdownNow();
        List<ProcessHandle> descendance = processus.descendants().collect(Collectors.toList());
        processus.destroyForcibly();
        descendance.forEach(ProcessHandle::destroyForcibly);
    }
}
