package lancer.atelier;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.time.LocalDateTime;
import java.time.temporal.ChronoUnit;
import java.util.stream.Stream;

/** Sur quoi et quand l'on mesure : sans cela, un temps ne se compare à aucun autre. */
public final class Circonstances {

    /** Ce qui n'a pu être su. */
    private static final String INCONNU = "inconnu";

    public final String machine = processeur();
    public final int coeurs = Runtime.getRuntime().availableProcessors();
    public final String jvm = System.getProperty("java.vm.name") + " " + System.getProperty("java.version");
    public final String date = LocalDateTime.now().truncatedTo(ChronoUnit.SECONDS).toString();

    /** Le commit mesuré, suivi de « + » si les sources ne sont plus les siennes. */
    public final String commit = commit();

    private static String processeur() {
        Path linux = Paths.get("/proc/cpuinfo");
        if (Files.isReadable(linux)) {
            try (Stream<String> lignes = Files.lines(linux)) {
                String nom = lignes.filter(l -> l.startsWith("model name")).findFirst().orElse("");
                if (!nom.isEmpty()) {
                    return nom.substring(nom.indexOf(':') + 1).trim();
                }
            } catch (IOException e) {
                // le nom du processeur n'est pas une raison de ne pas mesurer
            }
        }
        String mac = premiereLigne("sysctl", "-n", "machdep.cpu.brand_string");
        return mac != null && !mac.isEmpty() ? mac : System.getProperty("os.arch");
    }

    private static String commit() {
        String commit = premiereLigne("git", "rev-parse", "--short", "HEAD");
        if (commit == null || commit.isEmpty()) {
            return INCONNU;
        }
        // le banc lui-même écrit dans resultats : ce n'est pas une source
        String change = premiereLigne("git", "status", "--porcelain", "--", ":/", ":(top,exclude)mesures/resultats");
        return change == null || !change.isEmpty() ? commit + "+" : commit;
    }

    /** La première ligne qu'écrit cette commande, vide si elle n'écrit rien, {@code null} si elle ne peut être lancée. */
    private static String premiereLigne(String... commande) {
        try {
            Process processus = new ProcessBuilder(commande).start();
            try (BufferedReader sortie = new BufferedReader(
                    new InputStreamReader(processus.getInputStream(), StandardCharsets.UTF_8))) {
                String ligne = sortie.readLine();
                return ligne == null ? "" : ligne;
            }
        } catch (IOException e) {
            return null;
        }
    }
}
