package lancer.correction.enfant;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
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
 * Compile, dans une machine virtuelle à part, avec le compilateur d'Eclipse, qui écrit toutes les classes même fautives.
 * Les sources viennent dans la demande, par leur nom, et la réponse a les fautes, puis les classes : de ce qu'il lui faut
 * écrire entre temps, il ne reste rien. Une demande commence par sa sorte : {@link #COMPILER}, ou {@link #LIRE} des textes.
 */
public final class Compilateur {

    public static final char COMPILER = 'C';
    public static final char LIRE = 'L';

    /** La dernière version de Java que ce compilateur connaisse. */
    private static final int NIVEAU_MAX = 25;

    private static final int FAUTES_MAX = 500;
    private static final int CLASSES_MAX = 2000;

    private Compilateur() {
    }

    public static void main(String[] args) throws IOException {
        PrintStream sortie = System.out;
        System.setOut(System.err);
        // celui d'Eclipse, et non celui du JDK, qui est un service lui aussi
        JavaCompiler compilateur = ServiceLoader.load(JavaCompiler.class).stream().map(ServiceLoader.Provider::get)
                .filter(c -> c.getClass().getName().startsWith("org.eclipse.")).findFirst().get();
        // un seul pour tous : il garde ouvertes les archives où il trouve les classes
        StandardJavaFileManager gestion = compilateur.getStandardFileManager(null, Locale.ROOT, StandardCharsets.UTF_8);
        DataInputStream demandes = new DataInputStream(System.in);
        while (true) {
            int numero = demandes.readInt();
            DataInputStream demande = new DataInputStream(new ByteArrayInputStream(demandes.readNBytes(demandes.readInt())));
            if (demande.readChar() == LIRE) {
                List<String> textes = Echange.lireTout(demande).values().stream().map(t -> new String(t, StandardCharsets.UTF_8))
                        .collect(Collectors.toList());
                Echange.envoyer(sortie, numero, Echange.message(m -> Echange.ecrireValeur(m, Lecteur.lire(textes), o -> null)));
                continue;
            }
            Path dossier = Files.createTempDirectory("compilation");
            byte[] reponse;
            try {
                reponse = compiler(compilateur, gestion, dossier.toRealPath(), Echange.lireTout(demande));
            } catch (IOException | RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
                // ce que le compilateur ne supporte pas : il ne servira plus
                reponse = Echange.message(m -> {
                    Echange.ecrireValeur(m, null, o -> null);
                    Echange.ecrireTout(m, Map.of());
                });
            }
            effacer(dossier);
            Echange.envoyer(sortie, numero, reponse);
        }
    }

    private static byte[] compiler(JavaCompiler compilateur, StandardJavaFileManager gestion, Path dossier,
            Map<String, byte[]> textes) throws IOException {
        Path sources = Files.createDirectory(dossier.resolve("sources"));
        Path classes = Files.createDirectory(dossier.resolve("classes"));
        List<Path> fichiers = new ArrayList<>();
        for (Map.Entry<String, byte[]> texte : textes.entrySet()) {
            Path fichier = sous(sources, texte.getKey() + ".java");
            Files.createDirectories(fichier.getParent());
            fichiers.add(Files.write(fichier, texte.getValue()));
        }
        // nos propres classes d'abord : de deux classes de même nom, la première est la bonne
        fichiers.sort(Comparator.comparing((Path f) -> !f.getFileName().toString().matches("(Appels|Sonde)\\.java"))
                .thenComparing(f -> f));
        String niveau = String.valueOf(Math.min(NIVEAU_MAX, Runtime.version().feature()));
        List<String> options = List.of("-source", niveau, "-target", niveau, "-encoding", "UTF-8", "-g", "-nowarn",
                "-proc:none", "-proceedOnError", "-classpath", System.getProperty("java.class.path"), "-d",
                classes.toString());
        List<List<?>> fautes = new ArrayList<>();
        compilateur.getTask(new StringWriter(), gestion, faute -> {
            if (faute.getKind() == Diagnostic.Kind.ERROR && fautes.size() < FAUTES_MAX) {
                fautes.add(List.of(faute.getSource() == null ? "?" : sources.relativize(Paths.get(faute.getSource().toUri()))
                        .toString().replace('\\', '/'), (int) faute.getLineNumber(), faute.getMessage(Locale.ROOT)));
            }
        }, options, null, gestion.getJavaFileObjectsFromFiles(fichiers.stream().map(Path::toFile)
                .collect(Collectors.toList()))).call();
        Map<String, byte[]> ecrites = new LinkedHashMap<>();
        List<Path> toutes = contenu(classes);
        if (toutes.size() > CLASSES_MAX) {
            throw new IOException("trop de classes");
        }
        for (Path classe : toutes) {
            if (Files.isRegularFile(classe)) {
                String nom = classes.relativize(classe).toString().replaceFirst("\\.class$", "");
                ecrites.put(nom.replace(File.separatorChar, '.'), Files.readAllBytes(classe));
            }
        }
        return Echange.message(reponse -> {
            Echange.ecrireValeur(reponse, fautes, o -> null);
            Echange.ecrireTout(reponse, ecrites);
        });
    }

    /**
     * Le fichier de ce nom, dans ce dossier. Tout chemin fait de ce que dit un rendu passe par ici.
     *
     * @throws IllegalArgumentException s'il n'est pas dans ce dossier
     */
    private static Path sous(Path dossier, String nom) {
        Path fichier = dossier.resolve(nom).normalize();
        if (!fichier.startsWith(dossier) || fichier.equals(dossier)) {
            throw new IllegalArgumentException("hors de son dossier : " + nom);
        }
        return fichier;
    }

    /** Efface un dossier et tout ce qu'il contient. */
    public static void effacer(Path dossier) throws IOException {
        List<Path> contenu = contenu(dossier);
        for (int k = contenu.size() - 1; k >= 0; k--) {
            Files.delete(contenu.get(k));
        }
    }

    private static List<Path> contenu(Path dossier) throws IOException {
        try (Stream<Path> flux = Files.walk(dossier)) {
            return flux.sorted().collect(Collectors.toList());
        }
    }
}
