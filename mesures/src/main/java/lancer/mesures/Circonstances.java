package lancer.mesures;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.time.LocalDateTime;
import java.time.temporal.ChronoUnit;
import java.util.stream.Stream;

/** Circonstances d'une mesure, sans lesquelles un temps ne peut être comparé. */
public final class Circonstances {

    public final String machine = premiereLigne("sh", "-c", "grep -q '^model name' /proc/cpuinfo"
            + " && sed -n 's/^model name[^:]*: //p' /proc/cpuinfo || sysctl -n machdep.cpu.brand_string || uname -m");
    public final int coeurs = Runtime.getRuntime().availableProcessors();
    public final String jvm = System.getProperty("java.vm.name") + " " + System.getProperty("java.version");
    public final String date = LocalDateTime.now().truncatedTo(ChronoUnit.SECONDS).toString();

    /** Le commit mesuré, suivi de « + » si les sources ont changé depuis. */
    public final String commit = commit();

    private static String commit() {
        String commit = premiereLigne("git", "rev-parse", "--short", "HEAD");
        // les mesures elles-mêmes écrivent dans resultats, qui n'est pas une source
        String change = premiereLigne("git", "status", "--porcelain", "--", ":/", ":(top,exclude)mesures/resultats");
        if (commit.isEmpty()) {
            return "inconnu";
        }
        return change.isEmpty() ? commit : commit + "+";
    }

    /** Le nombre de commits qui ont changé ces dossiers depuis celui-ci ; vide s'il n'est pas connu. */
    public static String changements(String depuis, String... dossiers) {
        return premiereLigne(Stream.concat(Stream.of("git", "rev-list", "--count", depuis + "..HEAD", "--"), Stream.of(dossiers))
                .toArray(String[]::new));
    }

    /** La première ligne qu'écrit cette commande ; vide si elle n'écrit rien ou ne peut être lancée. */
    private static String premiereLigne(String... commande) {
        try (BufferedReader sortie = new BufferedReader(new InputStreamReader(
                new ProcessBuilder(commande).start().getInputStream(), StandardCharsets.UTF_8))) {
            String ligne = sortie.readLine();
            return ligne == null ? "" : ligne;
        } catch (IOException e) {
            return "";
        }
    }
}
