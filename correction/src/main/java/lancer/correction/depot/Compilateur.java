package lancer.correction.depot;

import com.google.gson.Gson;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.StringWriter;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.ServiceLoader;
import javax.tools.Diagnostic;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import lancer.correction.enfant.Echange;
import org.apache.commons.io.FileUtils;

/** Lit ou compile des sources, dans une autre machine virtuelle, par le compilateur d'Eclipse : il écrit même les classes fautives. */
public final class Compilateur {

    /** Lit des textes : la réponse est ce qu'en dit {@link Lecteur}, en JSON. */
    public static final String LIRE = "L";
    /** Compile des sources : la réponse est la liste des fautes, puis celle des classes, vide si le compilateur échoue. */
    public static final String COMPILER = "C";

    private static final Gson JSON = new Gson();

    /** Dernière version de Java que ce compilateur connaît. */
    private static final int NIVEAU_MAX = 25;

    private static final int FAUTES_MAX = 500;
    private static final int CLASSES_MAX = 2000;

    /** Une source à lire, ou une classe à écrire, que le compilateur tient en mémoire. */
    static final class EnMemoire extends SimpleJavaFileObject {

        private final String nom;
        private final String texte;
        private final ByteArrayOutputStream ecrit = new ByteArrayOutputStream();

        /** @param texte {@code null} pour une classe */
        EnMemoire(String nom, String texte) {
            super(URI.create("memoire:///" + nom), texte == null ? Kind.CLASS : Kind.SOURCE);
            this.nom = nom;
            this.texte = texte;
        }

        @Override
        public CharSequence getCharContent(boolean tel) {
            return texte;
        }

        @Override
        public OutputStream openOutputStream() {
            return ecrit;
        }
    }

    private final JavaCompiler compilateur;
    /** Un seul gestionnaire de fichiers pour tous : il garde ouvertes les archives des classes. */
    private final StandardJavaFileManager gestion;

    private Compilateur() {
        // le compilateur d'Eclipse, et non celui du JDK, qui est aussi un service
        compilateur = ServiceLoader.load(JavaCompiler.class).stream().map(ServiceLoader.Provider::get)
                .filter(c -> c.getClass().getName().startsWith("org.eclipse.")).findFirst().get();
        gestion = compilateur.getStandardFileManager(null, Locale.ROOT, StandardCharsets.UTF_8);
    }

    /** Une demande : sa sorte, puis le nom et les octets de chaque texte. */
    public static List<Object> demande(String sorte, Map<String, String> textes) {
        List<Object> demande = new ArrayList<>(List.of(sorte));
        textes.forEach((nom, texte) -> demande.addAll(List.of(nom, texte.getBytes(StandardCharsets.UTF_8))));
        return demande;
    }

    /** Ce que dit une réponse à {@link #LIRE}. @throws RuntimeException si elle n'a pas cette forme */
    public static Lecteur.Fichier[] lus(List<?> reponse) {
        return JSON.fromJson(new String((byte[]) reponse.get(0), StandardCharsets.UTF_8), Lecteur.Fichier[].class);
    }

    public static void main(String[] args) throws IOException {
        Compilateur ici = new Compilateur();
        Echange.servir(System.in, System.out, message -> {
            List<?> demande = (List<?>) Echange.lire(message, o -> null);
            Map<String, String> textes = new LinkedHashMap<>();
            for (int k = 1; k < demande.size(); k += 2) {
                textes.put((String) demande.get(k), new String((byte[]) demande.get(k + 1), StandardCharsets.UTF_8));
            }
            List<?> reponse = demande.get(0).equals(LIRE) ? List.of(JSON.toJson(Lecteur.lire(textes.values()))
                    .getBytes(StandardCharsets.UTF_8)) : ici.compiler(textes);
            return Echange.message(reponse, o -> null);
        });
    }

    private List<?> compiler(Map<String, String> sources) throws IOException {
        List<List<?>> fautes = new ArrayList<>();
        List<Object> classes = new ArrayList<>();
        Path dossier = Files.createTempDirectory("compilation").toRealPath();
        try {
            compiler(dossier, sources, fautes, classes);
        } catch (IOException | RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
            // une source fait échouer le compilateur
            classes.clear();
        } finally {
            FileUtils.deleteQuietly(dossier.toFile());
        }
        return List.of(fautes, classes);
    }

    private void compiler(Path dossier, Map<String, String> sources, List<List<?>> fautes, List<Object> classes) throws IOException {
        List<Path> fichiers = new ArrayList<>();
        for (Map.Entry<String, String> source : sources.entrySet()) {
            Path fichier = dossier.resolve(source.getKey() + ".java");
            Files.createDirectories(fichier.getParent());
            fichiers.add(Files.writeString(fichier, source.getValue()));
        }
        // les classes de la correction d'abord : de deux classes de même nom, la première est gardée
        fichiers.sort(Comparator.comparing(f -> !Source.NOTRES.contains(f.getFileName().toString().replace(".java", ""))));
        List<EnMemoire> ecrites = new ArrayList<>();
        String niveau = String.valueOf(Math.min(NIVEAU_MAX, Runtime.version().feature()));
        compilateur.getTask(new StringWriter(), new ForwardingJavaFileManager<>(gestion) {
            @Override
            public JavaFileObject getJavaFileForOutput(Location lieu, String nom, JavaFileObject.Kind sorte, FileObject voisin) {
                ecrites.add(new EnMemoire(nom, null));
                return ecrites.get(ecrites.size() - 1);
            }
        }, faute -> {
            if (faute.getKind() == Diagnostic.Kind.ERROR && fautes.size() < FAUTES_MAX) {
                fautes.add(List.of(faute.getSource() == null ? "?" : dossier.relativize(Path.of(faute.getSource().toUri()))
                        .toString().replace('\\', '/'), (int) faute.getLineNumber(), faute.getMessage(Locale.ROOT)));
            }
        }, List.of("-source", niveau, "-target", niveau, "-encoding", "UTF-8", "-g", "-nowarn", "-proc:none", "-proceedOnError",
                "-classpath", System.getProperty("java.class.path")), null,
                gestion.getJavaFileObjectsFromPaths(fichiers)).call();
        if (ecrites.size() > CLASSES_MAX) {
            throw new IllegalStateException("trop de classes");
        }
        ecrites.forEach(c -> classes.addAll(List.of(c.nom.replace('/', '.'), c.ecrit.toByteArray())));
    }
}
