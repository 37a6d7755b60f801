package lancer.mesures.vitesse;

import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Une machine virtuelle à part, de ce même chemin des classes, à qui l'on parle ligne par ligne. */
class Processus implements Closeable {

    private final Process processus;
    private final PrintStream entree;
    private final BufferedReader sortie;

    Processus(Class<?> programme, Object... args) throws IOException {
        this(Paths.get(System.getProperty("java.home"), "bin", "java").toString(),
                Stream.concat(Stream.of("-cp", System.getProperty("java.class.path"), programme.getName()), Arrays.stream(args)).toArray());
    }

    /** Un autre programme. */
    Processus(String commande, Object... args) throws IOException {
        processus = new ProcessBuilder(Stream.concat(Stream.of(commande), Arrays.stream(args).map(String::valueOf))
                .collect(Collectors.toList())).redirectError(ProcessBuilder.Redirect.INHERIT).start();
        entree = new PrintStream(processus.getOutputStream(), true, "UTF-8");
        sortie = new BufferedReader(new InputStreamReader(processus.getInputStream(), StandardCharsets.UTF_8));
    }

    /** @throws IllegalStateException si la machine s'est arrêtée, ou dit sa faute */
    String demander(String ligne) throws IOException {
        entree.println(ligne);
        String reponse = sortie.readLine();
        if (reponse == null || reponse.startsWith("faute ")) {
            throw new IllegalStateException(reponse == null ? "une machine virtuelle s'est arrêtée sans rien dire"
                    : reponse.substring("faute ".length()));
        }
        return reponse;
    }

    /** Tout ce qu'elle écrit, une fois finie. @throws IOException si ce n'est pas par le statut 0 : Ctrl+C peut l'arrêter d'abord */
    List<String> lignes() throws IOException {
        List<String> lignes = sortie.lines().collect(Collectors.toList());
        try {
            if (processus.waitFor() != 0) {
                throw new IOException("une machine virtuelle s'est arrêtée, statut " + processus.exitValue());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrompu", e);
        }
        return lignes;
    }

    /** L'arrête ; si l'on est tué avant, elle trouve son entrée fermée. */
    @Override
    public void close() {
        entree.close();
        processus.destroy();
    }
}
