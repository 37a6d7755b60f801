package lancer.correction.isolement;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import lancer.correction.Panne;

/**
 * Une machine virtuelle à part, à qui l'on demande une chose après l'autre. Elle est surveillée du dehors : ce qu'elle
 * calcule, ce qu'elle écrit, combien de processus elle lance. Le temps d'attente se compte en tours de la surveillance,
 * non à l'horloge : une machine suspendue puis reprise n'a pas attendu.
 */
public final class Enfant implements AutoCloseable {

    private static final long TOUR_MS = 100;
    private static final long SORTIE_MAX = 64 << 20;
    private static final long PAGE = 4096;
    /** Ce que prennent, en plus de la mémoire de Java, la machine virtuelle et les programmes qu'elle lance. */
    private static final long HORS_DU_TAS = 400;
    private static final String FIN = "\0fin";

    private final Process processus;
    private final Limites limites;
    private final BlockingQueue<String> lignes = new LinkedBlockingQueue<>();
    private volatile boolean sortieDemesuree;
    private double calculMax;
    /** Le temps de processeur au premier contrôle de la demande, et au dernier ; quand celui-ci a eu lieu. */
    private double debut;
    private double dernier;
    private long controle;

    /** @param prefixe ce par quoi commencent les lignes qui comptent ; les autres sont laissées */
    public Enfant(List<String> commande, String prefixe, Limites limites) {
        this.limites = limites;
        CompletableFuture<Process> lancement = new CompletableFuture<>();
        Thread lecteur = new Thread(() -> lancer(commande, prefixe, lancement), "lecteur");
        lecteur.setDaemon(true);
        lecteur.start();
        try {
            processus = lancement.join();
        } catch (CompletionException e) {
            throw new Panne(1, "une machine virtuelle n'a pas pu être lancée : " + e.getCause().getMessage());
        }
    }

    /** Lance, et lit jusqu'à la fin, dans le même fil : bubblewrap est tué quand finit celui qui l'a lancé. */
    private void lancer(List<String> commande, String prefixe, CompletableFuture<Process> lancement) {
        try {
            Process enfant = new ProcessBuilder(commande).redirectError(ProcessBuilder.Redirect.DISCARD).start();
            lancement.complete(enfant);
            lire(enfant.getInputStream(), prefixe);
        } catch (IOException | RuntimeException e) {
            // lancé, il est mort : c'est la fin, elle aussi
            lancement.completeExceptionally(e);
        }
        lignes.add(FIN);
    }

    private void lire(InputStream flux, String prefixe) throws IOException {
        char[] tampon = new char[1 << 16];
        long total = 0;
        StringBuilder ligne = new StringBuilder();
        try (Reader sortie = new BufferedReader(new InputStreamReader(flux, StandardCharsets.UTF_8))) {
            for (int n = sortie.read(tampon); n >= 0 && !sortieDemesuree; n = sortie.read(tampon)) {
                total += n;
                for (int k = 0; k < n; k++) {
                    if (tampon[k] != '\n') {
                        ligne.append(tampon[k]);
                        continue;
                    }
                    if (ligne.indexOf(prefixe) == 0) {
                        lignes.add(ligne.substring(prefixe.length()));
                    }
                    ligne.setLength(0);
                }
                sortieDemesuree = total > SORTIE_MAX;
            }
        }
    }

    /** Envoie une ligne. */
    public void dire(String ligne) throws Arret {
        try {
            OutputStream entree = processus.getOutputStream();
            entree.write((ligne + "\n").getBytes(StandardCharsets.UTF_8));
            entree.flush();
        } catch (IOException e) {
            throw mort();
        }
    }

    /** Une demande commence : le temps de processeur permis, en secondes, se compte à partir d'ici. */
    public void commencer(double calculPermis) {
        calculMax = calculPermis;
        debut = Double.NaN;
        controle = System.nanoTime();
    }

    /** La ligne suivante, si elle vient dans les limites. */
    public String attendre() throws Arret {
        int immobile = 0;
        while (true) {
            String ligne;
            try {
                ligne = lignes.poll(TOUR_MS, TimeUnit.MILLISECONDS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw arreter("interrompu");
            }
            if (FIN.equals(ligne)) {
                throw mort();
            }
            if (System.nanoTime() - controle > TOUR_MS * 1_000_000) {
                immobile = controler() ? 0 : immobile + 1;
            }
            if (ligne != null) {
                return ligne;
            }
            if (immobile * TOUR_MS > 1000 * limites.attente) {
                throw arreter("arrêté : plus de " + (int) limites.attente + " s sans rien faire, bloqué ou endormi");
            }
        }
    }

    /** @return vrai si l'enfant a calculé depuis le contrôle précédent */
    private boolean controler() throws Arret {
        List<ProcessHandle> tous = processus.descendants().collect(Collectors.toList());
        if (tous.size() > limites.processus) {
            throw arreter("arrêté : lance sans fin d'autres programmes");
        }
        tous.add(processus.toHandle());
        // le temps de processeur, en secondes, de l'enfant et de ce qu'il a lancé
        double maintenant = tous.stream().map(p -> p.info().totalCpuDuration().orElse(Duration.ZERO))
                .mapToLong(Duration::toMillis).sum() / 1e3;
        boolean travaille = !(maintenant - dernier <= TOUR_MS / 2e4);
        dernier = maintenant;
        controle = System.nanoTime();
        debut = Double.isNaN(debut) ? maintenant : debut;
        if (maintenant - debut > calculMax) {
            throw arreter("arrêté après " + Math.round(calculMax) + " s de calcul : une boucle sans fin ?");
        }
        if (sortieDemesuree) {
            throw arreter("arrêté : imprime sans fin");
        }
        if (tous.stream().mapToLong(Enfant::occupe).sum() > (limites.memoire + HORS_DU_TAS) << 20) {
            throw arreter("mémoire épuisée");
        }
        return travaille;
    }

    /** La mémoire qu'occupe un processus, en octets ; 0 là où le système ne le dit pas ainsi. */
    private static long occupe(ProcessHandle processus) {
        try {
            String[] pages = Files.readString(Paths.get("/proc", "" + processus.pid(), "statm")).split(" ");
            return Long.parseLong(pages[1]) * PAGE;
        } catch (IOException | RuntimeException e) {
            return 0;
        }
    }

    private Arret arreter(String cause) {
        close();
        return new Arret(cause);
    }

    private Arret mort() {
        int statut;
        try {
            processus.waitFor(1, TimeUnit.SECONDS);
            statut = processus.isAlive() ? -1 : processus.exitValue();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            statut = -1;
        }
        close();
        return new Arret(sortieDemesuree ? "arrêté : imprime sans fin"
                : statut == 3 ? "mémoire épuisée" : "le programme s'est arrêté de lui-même (System.exit ?), statut "
                + statut);
    }

    /** Tue la machine virtuelle, et tout ce qu'elle a lancé. */
    @Override
    public void close() {
        List<ProcessHandle> descendance = processus.descendants().collect(Collectors.toList());
        processus.destroyForcibly();
        descendance.forEach(ProcessHandle::destroyForcibly);
    }
}
