package lancer.mesures.vitesse;

import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Une autre machine virtuelle, de même chemin des classes, qui répond ligne par ligne. */
class Processus implements Closeable {

    /** La commande java de cette machine virtuelle. */
    static final String JAVA = Paths.get(System.getProperty("java.home"), "bin", "java").toString();

    private final Process processus;
    private final PrintStream entree;
    private final BufferedReader sortie;

    Processus(Class<?> programme, Object... args) throws IOException {
        processus = new ProcessBuilder(Stream.concat(Stream.of(JAVA, "-cp", System.getProperty("java.class.path"), programme.getName()),
                Arrays.stream(args)).map(String::valueOf).collect(Collectors.toList()))
                .redirectError(ProcessBuilder.Redirect.INHERIT).start();
        entree = new PrintStream(processus.getOutputStream(), true, "UTF-8");
        sortie = new BufferedReader(new InputStreamReader(processus.getInputStream(), StandardCharsets.UTF_8));
    }

    /** @throws IllegalStateException si l'autre machine virtuelle s'est arrêtée, ou annonce une faute */
    String demander(String ligne) throws IOException {
        entree.println(ligne);
        String reponse = sortie.readLine();
        if (reponse == null || reponse.startsWith("faute ")) {
            throw new IllegalStateException(reponse == null ? "une machine virtuelle s'est arrêtée sans rien dire"
                    : reponse.substring("faute ".length()));
        }
        return reponse;
    }

    /** Arrête l'autre machine virtuelle, qui s'arrête aussi à la fin de son entrée. */
    @Override
    public void close() {
        entree.close();
        processus.destroy();
    }
}
