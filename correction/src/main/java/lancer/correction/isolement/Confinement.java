package lancer.correction.isolement;

import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;

/** Lancement de Java sans réseau ni disque, par bubblewrap ; sans confinement si bubblewrap ne marche pas et que l'enseignant l'accepte. */
public final class Confinement {

    private static final int DISQUE = 64 << 20;
    private static final int BLOC = 512;
    private static final int ESSAI_SECONDES = 20;
    /** Dossier de Java, sans lien. */
    private static final String JAVA = System.getProperty("java.home");
    private static final String BOITE = "/boite.jar";
    /**
     * Par processeur : son numéro (linux/audit.h), celui de l'appel clone, puis ceux des appels refusés, qui lancent un programme ou
     * sortent d'ici : fork, vfork, unshare.
     */
    private static final Map<String, int[]> APPELS = Map.of(
            "amd64", new int[] {0xC000003E, 56, 57, 58, 272},
            "aarch64", new int[] {0xC00000B7, 220, 97});
    private static final int CLONE3 = 435;

    public final boolean confine;
    /** Raison qui empêche de confiner, vide s'il n'y en a pas. */
    public final String manque;
    /** Options supplémentaires de bubblewrap, et fichier de son filtre. */
    private final List<String> enPlus;
    private final Path filtre;

    public Confinement(boolean confine, String manque) {
        this(confine, manque, List.of(), null);
    }

    private Confinement(boolean confine, String manque, List<String> enPlus, Path filtre) {
        this.confine = confine;
        this.manque = manque;
        this.enPlus = enPlus;
        this.filtre = filtre;
    }

    /** Essaie bubblewrap, d'abord en interdisant les espaces d'utilisateurs : les anciennes versions ne savent pas les interdire. */
    public static Confinement essayer() {
        Confinement ferme = essayer(List.of("--unshare-user", "--disable-userns"));
        return ferme.confine ? ferme : essayer(List.of());
    }

    /**
     * Programme (seccomp(2)) qui refuse ces appels, et ceux d'un autre processeur : un rendu peut lancer des fils, mais aucun programme. Si
     * les numéros sont inconnus, rien n'est refusé.
     */
    private static Path filtre() throws IOException {
        int[] a = APPELS.get(System.getProperty("os.arch"));
        List<Integer> programme = new ArrayList<>();
        if (a != null) {
            int refus = a.length + 8;
            // lit le processeur, puis le numéro ; un très grand numéro est celui d'un autre processeur (x32) ; clone3 est refusé, et Java
            // utilise clone
            programme.addAll(List.of(0x20, 4, 0x15 | refus - 2 << 24, a[0], 0x20, 0, 0x35 | refus - 4 << 16, 0x40000000,
                    0x15 | refus - 4 << 16, CLONE3, 0x15 | refus - 9 << 16, a[1]));
            IntStream.range(2, a.length).forEach(k -> programme.addAll(List.of(0x15 | refus - 5 - k << 16, a[k])));
            // permet l'appel ; pour clone, lit ses options et permet CLONE_THREAD
            programme.addAll(List.of(0x05, 2, 0x20, 16, 0x45 | 1 << 24, 0x10000));
        }
        // trois fins du programme : permettre, EPERM, ENOSYS
        programme.addAll(List.of(0x06, 0x7FFF0000, 0x06, 0x00050001, 0x06, 0x00050026));
        ByteBuffer octets = ByteBuffer.allocate(4 * programme.size()).order(ByteOrder.nativeOrder());
        programme.forEach(octets::putInt);
        Path filtre = Files.write(Files.createTempFile("filtre", null), octets.array());
        filtre.toFile().deleteOnExit();
        return filtre;
    }

    private static Confinement essayer(List<String> enPlus) {
        List<String> essai = enveloppe(enPlus);
        // bwrap lit le filtre sur son entrée
        essai.addAll(List.of("--seccomp", "0", "/usr/bin/true"));
        try {
            Path filtre = filtre();
            Process processus = new ProcessBuilder(essai).redirectErrorStream(true).redirectInput(filtre.toFile()).start();
            if (!processus.waitFor(ESSAI_SECONDES, TimeUnit.SECONDS)) {
                processus.destroyForcibly();
                return new Confinement(false, "bwrap ne répond pas");
            }
            String dit = new String(processus.getInputStream().readAllBytes(), StandardCharsets.UTF_8).trim();
            if (processus.exitValue() == 0) {
                return new Confinement(true, "", enPlus, filtre);
            }
            String raison = dit.contains("uid map: Permission denied")
                    ? "AppArmor ne laisse pas bwrap confiner (Ubuntu 23.10 et suivants) ; pour le permettre : make profil-bwrap "
                    + "(--profil-bwrap) ; le message : " : "bwrap refuse : ";
            return new Confinement(false, raison + dit.replaceAll("\\s+", " "));
        } catch (IOException e) {
            return new Confinement(false, System.getProperty("os.name").startsWith("Linux")
                    ? "bwrap n'est pas installé (sudo apt-get install bubblewrap)" : "bwrap n'existe que sous Linux");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return new Confinement(false, "interrompu");
        }
    }

    /**
     * La commande qui lance une classe de cette archive dans une autre machine virtuelle. Confinée, celle-ci ne voit du disque que Java,
     * une copie de l'archive et un dossier vide, sans aucun nom de la machine.
     *
     * @param temporaire dossier provisoire, sans confinement
     * @param visibles vrai si les archives de ce chemin sont visibles, car aucun code d'étudiant ne s'exécute
     */
    public List<String> java(Class<?> principale, String chemin, boolean visibles, Path temporaire, Limites limites) {
        List<String> commande = new ArrayList<>();
        String classes = confine && !visibles ? BOITE : chemin;
        if (Files.isExecutable(Path.of("/bin/sh"))) {
            // à court de mémoire, le noyau tue d'abord ce programme et tout ce qu'il a lancé ; les fichiers sont limités ; l'archive passe
            // par un descripteur, car un lien ou un argument montrerait son nom
            commande.addAll(List.of("/bin/sh", "-c", "{ echo 1000 >/proc/self/oom_score_adj; } 2>/dev/null; ulimit -f " + DISQUE / BLOC
                    + "; f=$1; shift; exec \"$@\""
                    + (classes.equals(BOITE) ? " 8<\"$f\" 9<\"$0\"" : ""), chemin, String.valueOf(filtre)));
        }
        if (confine) {
            commande.addAll(enveloppe(enPlus));
            List<String> vus = visibles ? List.of(chemin.split(File.pathSeparator)) : List.of();
            vus.forEach(v -> commande.addAll(List.of("--ro-bind", v, v)));
            if (!visibles) {
                commande.addAll(List.of("--seccomp", "8", "--ro-bind-data", "9", BOITE));
            }
            commande.addAll(List.of("--remount-ro", "/", "--remount-ro", "/dev", "--chdir", "/tmp"));
        }
        commande.addAll(List.of(JAVA + "/bin/java", "-Xmx" + limites.memoire + "m", "-Xss2m", "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1", "-XX:+ExitOnOutOfMemoryError", "-XX:-UsePerfData",
                // la sortie standard ne sert qu'aux réponses
                "-XX:+DisplayVMOutputToStderr", "-Xlog:disable",
                "-Djava.awt.headless=true", "-Dfile.encoding=UTF-8", "-Dsun.jnu.encoding=UTF-8", "-Duser.language=fr",
                "-Djava.io.tmpdir=" + (confine ? "/tmp" : temporaire)));
        commande.addAll(List.of("-cp", classes, principale.getName()));
        return commande;
    }

    private static List<String> enveloppe(List<String> enPlus) {
        List<String> commande = new ArrayList<>(List.of("bwrap", "--unshare-all", "--die-with-parent", "--new-session",
                "--cap-drop", "ALL", "--hostname", "boite", "--clearenv",
                "--setenv", "LANG", "C.UTF-8", "--setenv", "PATH", "/usr/bin", "--ro-bind", "/usr", "/usr"));
        commande.addAll(enPlus);
        for (String dossier : List.of("/lib", "/lib64", "/bin")) {
            Path ici = Path.of(dossier);
            if (Files.isSymbolicLink(ici)) {
                commande.addAll(List.of("--symlink", "usr" + dossier, dossier));
            } else if (Files.isDirectory(ici)) {
                commande.addAll(List.of("--ro-bind", dossier, dossier));
            }
        }
        // Debian met une partie de la configuration de Java hors de son dossier
        String[] reglages = new File("/etc").list((etc, nom) -> nom.startsWith("java"));
        for (String nom : reglages == null ? new String[0] : reglages) {
            commande.addAll(List.of("--ro-bind-try", "/etc/" + nom, "/etc/" + nom));
        }
        // Java a seulement besoin de /proc/self/exe ; le vrai /proc montrerait l'origine des fichiers, et laisserait écrire oom_score_adj
        commande.addAll(List.of("--dir", "/proc/self", "--symlink", JAVA + "/bin/java", "/proc/self/exe",
                "--dev", "/dev", "--size", String.valueOf(DISQUE), "--tmpfs", "/tmp"));
        // après /tmp, qui cacherait un JDK qui y est
        if (!JAVA.startsWith("/usr/")) {
            commande.addAll(List.of("--ro-bind", JAVA, JAVA));
        }
        // sans leurs bibliothèques, les MXBean, qui montreraient la mémoire de la machine, ne se chargent pas ; --limit-modules, qui les
        // ôterait aussi, prive Java de ses classes préparées, et double le temps de son démarrage
        for (String nom : List.of("management", "management_ext")) {
            String bibliotheque = JAVA + "/lib/lib" + nom + ".so";
            if (Files.exists(Path.of(bibliotheque))) {
                commande.addAll(List.of("--ro-bind", "/dev/null", bibliotheque));
            }
        }
        return commande;
    }
}
