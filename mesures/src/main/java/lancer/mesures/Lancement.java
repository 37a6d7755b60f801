package lancer.mesures;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Un programme entier, du lancement à la fin : ce qu'il dit et ce qu'il prend. */
public final class Lancement {

    /**
     * Lance une commande, et note, sur la dernière ligne du fichier $0, ses secondes selon bash : réelles, de l'utilisateur, du système.
     * Avant elle, là où GNU time est installé, les kilooctets résidents qu'elle a occupés, au plus.
     */
    private static final String MESURE = "t=(/usr/bin/time -f %M -o \"$0\"); \"${t[@]}\" true 2>/dev/null || t=(); : >\"$0\"; "
            + "TIMEFORMAT='%R %U %S'; { time \"${t[@]}\" \"$@\" 2>&3; } 3>&2 2>>\"$0\"";

    /** Statut de sortie, 126 ou 127 si la commande ne peut être lancée ; ce qu'il a écrit, sur ses deux sorties. */
    public final int statut;
    public final String dit;

    /** Ce qu'il a pris : temps réel et temps des processeurs, en nanosecondes ; plus de mémoire résidente, en octets, NaN sans GNU time. */
    public final double[] pris;

    /** @param note fichier où noter ce qu'il prend */
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

    /** @throws IOException si le statut n'est pas 0 : Ctrl+C peut l'avoir arrêté */
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
