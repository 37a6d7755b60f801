package lancer.correction.enfant;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.Diagnostic;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;

/**
 * Compile, dans une machine virtuelle à part, avec le compilateur d'Eclipse, qui écrit toutes les classes même
 * fautives. Sur l'entrée standard, une ligne par dossier : {@code sources<tab>classes} ; sur la sortie, une ligne par
 * faute, puis {@code FIN}.
 */
public final class Compilateur {

    /** La dernière version de Java que ce compilateur connaisse. */
    private static final int NIVEAU_MAX = 25;

    private Compilateur() {
    }

    public static void main(String[] args) throws IOException {
        PrintStream sortie = new PrintStream(System.out, true, "UTF-8");
        System.setOut(System.err);
        JavaCompiler compilateur = eclipse();
        BufferedReader demandes = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        // un seul pour tous : il garde ouvertes les archives où il trouve les classes
        StandardJavaFileManager gestion = compilateur.getStandardFileManager(null, Locale.ROOT, StandardCharsets.UTF_8);
        for (String ligne = demandes.readLine(); ligne != null; ligne = demandes.readLine()) {
            String[] mots = ligne.split("\t");
            try {
                compiler(compilateur, gestion, Paths.get(mots[0]), Paths.get(mots[1]), sortie);
            } catch (RuntimeException | StackOverflowError e) {
                sortie.println("FAUTE\t?\t0\tle compilateur a échoué : " + Echange.protege(String.valueOf(e)));
            }
            sortie.println("FIN");
        }
    }

    /** Le compilateur d'Eclipse, et non celui du JDK, qui est un service lui aussi. */
    private static JavaCompiler eclipse() {
        for (JavaCompiler compilateur : ServiceLoader.load(JavaCompiler.class)) {
            if (compilateur.getClass().getName().startsWith("org.eclipse.")) {
                return compilateur;
            }
        }
        throw new IllegalStateException("le compilateur d'Eclipse n'est pas là");
    }

    private static void compiler(JavaCompiler compilateur, StandardJavaFileManager gestion, Path sources, Path classes,
            PrintStream sortie) throws IOException {
        List<File> fichiers;
        try (Stream<Path> flux = Files.walk(sources)) {
            // nos propres classes d'abord : de deux classes de même nom, la première est la bonne
            fichiers = flux.filter(f -> f.toString().endsWith(".java"))
                    .sorted((a, b) -> rang(a) != rang(b) ? rang(a) - rang(b) : a.compareTo(b))
                    .map(Path::toFile).collect(Collectors.toList());
        }
        Files.createDirectories(classes);
        String niveau = String.valueOf(Math.min(NIVEAU_MAX, Runtime.version().feature()));
        List<String> options = new ArrayList<>(List.of("-source", niveau, "-target", niveau, "-encoding", "UTF-8",
                "-g", "-nowarn",
                "-proc:none", "-proceedOnError", "-classpath", System.getProperty("java.class.path"), "-d",
                classes.toString()));
        compilateur.getTask(new StringWriter(), gestion, faute -> {
            if (faute.getKind() == Diagnostic.Kind.ERROR) {
                sortie.println("FAUTE\t" + nom(sources, faute) + "\t" + faute.getLineNumber() + "\t"
                        + Echange.protege(faute.getMessage(Locale.ROOT)));
            }
        }, options, null, gestion.getJavaFileObjectsFromFiles(fichiers)).call();
    }

    private static int rang(Path fichier) {
        return fichier.getFileName().toString().matches("(Appels|Sonde\\w+)\\.java") ? 0 : 1;
    }

    private static String nom(Path sources, Diagnostic<? extends JavaFileObject> faute) {
        return faute.getSource() == null ? "?" : sources.relativize(Paths.get(faute.getSource().toUri())).toString()
                .replace('\\', '/');
    }
}
