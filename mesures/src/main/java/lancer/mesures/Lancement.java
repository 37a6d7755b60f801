package lancer.mesures;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** L'exécution d'un programme entier : sa sortie et son coût. */
public final class Lancement {

    /**
     * Script bash : il lance une commande et écrit sur la dernière ligne du fichier $0 ses secondes réelles, d'utilisateur et de système.
     * Si GNU time est installé, la ligne d'avant donne sa plus grande mémoire résidente, en kilooctets.
     */
    private static final String MESURE = "t=(/usr/bin/time -f %M -o \"$0\"); \"${t[@]}\" true 2>/dev/null || t=(); : >\"$0\"; "
            + "TIMEFORMAT='%R %U %S'; { time \"${t[@]}\" \"$@\" 2>&3; } 3>&2 2>>\"$0\"";

    /** La commande java de cette machine virtuelle. */
    public static final String JAVA = Paths.get(System.getProperty("java.home"), "bin", "java").toString();

    /** Statut de sortie, 126 ou 127 si la commande ne peut être lancée ; texte de ses deux sorties. */
    public final int statut;
    public final String dit;

    /** Coût : temps réel et temps des processeurs, en nanosecondes ; plus grande mémoire résidente, en octets, NaN sans GNU time. */
    public final double[] pris;

    /** @param note fichier où le script écrit le coût */
    public Lancement(Path note, Object... commande) throws IOException {
        Process bash = new ProcessBuilder(Stream.concat(Stream.of("bash", "-c", MESURE, note), Arrays.stream(commande)).map(String::valueOf)
                .collect(Collectors.toList())).redirectErrorStream(true).start();
        try (BufferedReader sortie = new BufferedReader(new InputStreamReader(bash.getInputStream(), StandardCharsets.UTF_8))) {
            dit = sortie.lines().collect(Collectors.joining("\n"));
            statut = bash.waitFor();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrompu pendant " + commande[0], e);
        }
        List<String> lignes = Files.readAllLines(note);
        String[] secondes = lignes.get(lignes.size() - 1).replace(',', '.').split(" ");
        pris = new double[] {1e9 * Double.parseDouble(secondes[0]),
            1e9 * (Double.parseDouble(secondes[1]) + Double.parseDouble(secondes[2])),
            statut == 0 && lignes.size() > 1 ? 1024 * Double.parseDouble(lignes.get(0)) : Double.NaN};
    }

    /** @throws IOException si le statut n'est pas 0, par exemple après Ctrl+C */
    public Lancement reussi() throws IOException {
        if (statut != 0) {
            throw new IOException("un programme s'est arrêté, statut " + statut + " : " + derniereLigne());
        }
        return this;
    }

    public String derniereLigne() {
        return dit.trim().replaceFirst("(?s).*\\n\\s*", "");
    }
}
