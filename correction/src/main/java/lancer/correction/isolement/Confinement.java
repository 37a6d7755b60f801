package lancer.correction.isolement;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Façon de lancer Java sans réseau ni disque, par bubblewrap, ou sans confinement là où il ne marche pas et où on
 * l'accepte.
 */
public final class Confinement {

    private static final int DISQUE = 64 << 20;
    private static final int BLOC = 512;
    private static final int ESSAI_SECONDES = 20;
    /** Place de Java : Linux en dit le vrai chemin, sans lien. */
    private static final String JAVA = System.getProperty("java.home");
    private static final String BOITE = "/boite.jar";

    public final boolean confine;
    /** Raison qui empêche de confiner, vide s'il n'y en a pas. */
    public final String manque;

    public Confinement(boolean confine, String manque) {
        this.confine = confine;
        this.manque = manque;
    }

    /** Essaie bubblewrap. */
    public static Confinement essayer() {
        List<String> essai = enveloppe();
        essai.add("/usr/bin/true");
        try {
            Process processus = new ProcessBuilder(essai).redirectErrorStream(true).start();
            processus.getOutputStream().close();
            if (!processus.waitFor(ESSAI_SECONDES, TimeUnit.SECONDS)) {
                processus.destroyForcibly();
                return new Confinement(false, "bwrap ne répond pas");
            }
            String dit = new String(processus.getInputStream().readAllBytes(), StandardCharsets.UTF_8).trim();
            return new Confinement(processus.exitValue() == 0, processus.exitValue() == 0 ? ""
                    : "bwrap refuse : " + dit.replaceAll("\\s+", " "));
        } catch (IOException e) {
            return new Confinement(false, "bwrap n'est pas installé (sudo apt-get install bubblewrap)");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return new Confinement(false, "interrompu");
        }
    }

    /**
     * La commande qui lance, dans une machine virtuelle à part, une classe de cette archive. Confinée, elle n'a du disque
     * que Java, une copie de l'archive et un dossier vide ; rien n'y dit comment s'appelle quoi que ce soit ici.
     *
     * @param temporaire où, à défaut de confinement, ces classes écrivent ce qu'elles effaceront
     * @param visibles vrai si les archives de ce chemin se voient à leur place, parce qu'aucun code d'étudiant n'y tourne
     */
    public List<String> java(Class<?> principale, String chemin, boolean visibles, Path temporaire,
            Limites limites) {
        List<String> commande = new ArrayList<>();
        String classes = chemin;
        if (confine) {
            if (!visibles) {
                // par un descripteur : un lien se lirait dans mountinfo, un argument dans la ligne de commande
                commande.addAll(List.of("/bin/sh", "-c", "exec \"$@\" 9<\"$0\"", chemin));
                classes = BOITE;
            }
            commande.addAll(enveloppe());
            List<String> vus = visibles ? List.of(chemin.split(File.pathSeparator)) : List.of();
            vus.forEach(v -> commande.addAll(List.of("--ro-bind", v, v)));
            if (!visibles) {
                commande.addAll(List.of("--ro-bind-data", "9", BOITE));
            }
            commande.addAll(List.of("--remount-ro", "/", "--remount-ro", "/dev", "--chdir", "/tmp"));
        } else if (Files.isExecutable(Paths.get("/bin/sh"))) {
            // à défaut d'un disque à part, au moins pas de fichier sans fin
            commande.addAll(List.of("/bin/sh", "-c", "ulimit -f " + DISQUE / BLOC + "; exec \"$@\"", "sh"));
        }
        commande.addAll(List.of(JAVA + "/bin/java", "-Xmx" + limites.memoire + "m", "-Xss2m",
                "-XX:MaxDirectMemorySize=32m",
                "-XX:MaxMetaspaceSize=192m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1",
                "-XX:+ExitOnOutOfMemoryError", "-XX:-UsePerfData", "-XX:+DisplayVMOutputToStderr",
                // la sortie est celle des réponses, et d'elles seules
                "--add-opens", "java.base/java.io=ALL-UNNAMED",
                "-Djava.awt.headless=true", "-Dfile.encoding=UTF-8", "-Duser.language=fr",
                "-Djava.io.tmpdir=" + (confine ? "/tmp" : temporaire), "-cp", classes,
                principale.getName()));
        return commande;
    }

    private static List<String> enveloppe() {
        List<String> commande = new ArrayList<>(List.of("bwrap", "--unshare-all", "--die-with-parent", "--new-session",
                "--cap-drop", "ALL", "--hostname", "boite", "--clearenv",
                "--setenv", "LANG", "C.UTF-8", "--setenv", "PATH", "/usr/bin", "--ro-bind", "/usr", "/usr"));
        for (String dossier : List.of("/lib", "/lib64", "/bin")) {
            Path ici = Paths.get(dossier);
            if (Files.isSymbolicLink(ici)) {
                commande.addAll(List.of("--symlink", "usr" + dossier, dossier));
            } else if (Files.isDirectory(ici)) {
                commande.addAll(List.of("--ro-bind", dossier, dossier));
            }
        }
        // Debian met une partie de la configuration de Java hors de son dossier
        try (Stream<Path> flux = Files.list(Paths.get("/etc"))) {
            for (String java : flux.map(Path::toString).filter(f -> f.startsWith("/etc/java"))
                    .collect(Collectors.toList())) {
                commande.addAll(List.of("--ro-bind-try", java, java));
            }
        } catch (IOException e) {
            // pas de /etc : rien à montrer
        }
        if (!JAVA.startsWith("/usr/")) {
            commande.addAll(List.of("--ro-bind", JAVA, JAVA));
        }
        // de /proc, Java n'a besoin que de savoir où il est ; le vrai dirait d'où vient ce qu'on voit
        commande.addAll(List.of("--dir", "/proc/self", "--symlink", JAVA + "/bin/java", "/proc/self/exe",
                "--dev", "/dev", "--size", String.valueOf(DISQUE), "--tmpfs", "/tmp"));
        return commande;
    }
}
