package lancer.correction.enfant;

import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.Diagnostic;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;

/**
 * Compile, dans une autre machine virtuelle, par le compilateur d'Eclipse, qui écrit même les classes fautives. La demande contient les
 * sources, par nom. La réponse contient les fautes, puis les classes. Les fichiers provisoires sont effacés. Une demande commence par sa
 * sorte : {@link #COMPILER}, ou {@link #LIRE} des textes.
 */
public final class Compilateur {

    public static final char COMPILER = 'C';
    public static final char LIRE = 'L';

    /** Dernière version de Java que ce compilateur connaît. */
    private static final int NIVEAU_MAX = 25;

    private static final int FAUTES_MAX = 500;
    private static final int CLASSES_MAX = 2000;

    private Compilateur() {
    }

    public static void main(String[] args) throws IOException {
        // le compilateur d'Eclipse, et non celui du JDK, qui est aussi un service
        JavaCompiler compilateur = ServiceLoader.load(JavaCompiler.class).stream().map(ServiceLoader.Provider::get)
                .filter(c -> c.getClass().getName().startsWith("org.eclipse.")).findFirst().get();
        // un seul gestionnaire de fichiers pour tous : il garde ouvertes les archives des classes
        StandardJavaFileManager gestion = compilateur.getStandardFileManager(null, Locale.ROOT, StandardCharsets.UTF_8);
        Echange.servir(demande -> {
            char sorte = demande.readChar();
            Map<String, byte[]> textes = Echange.lireTout(demande);
            return sorte == COMPILER ? compiler(compilateur, gestion, textes)
                    : m -> Echange.ecrireValeur(m, Lecteur.lire(textes.values().stream().map(t -> new String(t, StandardCharsets.UTF_8))
                    .collect(Collectors.toList())), o -> null);
        });
    }

    private static Echange.Redaction compiler(JavaCompiler compilateur, StandardJavaFileManager gestion, Map<String, byte[]> textes)
            throws IOException {
        Path dossier = Files.createTempDirectory("compilation").toRealPath();
        try {
            return compiler(compilateur, gestion, dossier, textes);
        } catch (IOException | RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
            // une source fait échouer le compilateur
            return m -> {
                Echange.ecrireValeur(m, null, o -> null);
                Echange.ecrireTout(m, Map.of());
            };
        } finally {
            effacer(dossier);
        }
    }

    private static Echange.Redaction compiler(JavaCompiler compilateur, StandardJavaFileManager gestion, Path dossier,
            Map<String, byte[]> textes) throws IOException {
        Path sources = dossier.resolve("sources");
        Path classes = Files.createDirectory(dossier.resolve("classes"));
        List<Path> fichiers = new ArrayList<>();
        for (Map.Entry<String, byte[]> texte : textes.entrySet()) {
            Path fichier = sources.resolve(texte.getKey() + ".java");
            Files.createDirectories(fichier.getParent());
            fichiers.add(Files.write(fichier, texte.getValue()));
        }
        // les classes de la correction d'abord : de deux classes de même nom, la première est gardée
        fichiers.sort(Comparator.comparing((Path f) -> !f.getFileName().toString().matches("(Appels|Sonde)\\.java"))
                .thenComparing(f -> f));
        String niveau = String.valueOf(Math.min(NIVEAU_MAX, Runtime.version().feature()));
        List<List<?>> fautes = new ArrayList<>();
        compilateur.getTask(new StringWriter(), gestion, faute -> {
            if (faute.getKind() == Diagnostic.Kind.ERROR && fautes.size() < FAUTES_MAX) {
                fautes.add(List.of(faute.getSource() == null ? "?" : sources.relativize(Paths.get(faute.getSource().toUri()))
                        .toString().replace('\\', '/'), (int) faute.getLineNumber(), faute.getMessage(Locale.ROOT)));
            }
        }, List.of("-source", niveau, "-target", niveau, "-encoding", "UTF-8", "-g", "-nowarn", "-proc:none", "-proceedOnError",
                "-classpath", System.getProperty("java.class.path"), "-d", classes.toString()),
                null, gestion.getJavaFileObjectsFromPaths(fichiers)).call();
        Map<String, byte[]> ecrites = new LinkedHashMap<>();
        try (Stream<Path> flux = Files.walk(classes)) {
            for (Path classe : flux.filter(Files::isRegularFile).sorted().collect(Collectors.toList())) {
                String nom = classes.relativize(classe).toString().replaceFirst("\\.class$", "");
                ecrites.put(nom.replace(File.separatorChar, '.'), Files.readAllBytes(classe));
            }
        }
        if (ecrites.size() > CLASSES_MAX) {
            throw new IOException("trop de classes");
        }
        return reponse -> {
            Echange.ecrireValeur(reponse, fautes, o -> null);
            Echange.ecrireTout(reponse, ecrites);
        };
    }

    public static void effacer(Path dossier) throws IOException {
        try (Stream<Path> flux = Files.walk(dossier)) {
            flux.sorted(Comparator.reverseOrder()).map(Path::toFile).forEach(File::delete);
        }
    }
}
