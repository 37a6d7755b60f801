package lancer.correction.depot;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonDeserializer;
import com.google.gson.JsonPrimitive;
import com.google.gson.JsonSerializer;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.StringWriter;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Base64;
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

    /** Les demandes et les réponses : des objets, par les noms de leurs champs. */
    private static final Gson JSON = new GsonBuilder().disableHtmlEscaping()
            .registerTypeAdapter(byte[].class, (JsonSerializer<byte[]>) (octets, type, json) ->
                    new JsonPrimitive(Base64.getEncoder().encodeToString(octets)))
            .registerTypeAdapter(byte[].class, (JsonDeserializer<byte[]>) (texte, type, json) ->
                    Base64.getDecoder().decode(texte.getAsString())).create();

    /** Dernière version de Java que ce compilateur connaît. */
    private static final int NIVEAU_MAX = 25;

    private static final int FAUTES_MAX = 500;
    private static final int CLASSES_MAX = 2000;

    /** Des textes à lire, ou des sources à compiler par leur nom, {@code lancer/Vecteur}. */
    public static final class Demande {

        private final List<String> aLire;
        private final Map<String, String> sources;

        public Demande(List<String> aLire, Map<String, String> sources) {
            this.aLire = aLire;
            this.sources = sources;
        }
    }

    /** Les fichiers lus, ou les fautes et les classes compilées ; sans aucune classe, le compilateur échoue. */
    public static final class Reponse {

        public Lecteur.Fichier[] lus;
        public final List<Faute> fautes = new ArrayList<>();
        public final Map<String, byte[]> classes = new LinkedHashMap<>();
    }

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

    public static byte[] ecrire(Object message) {
        return JSON.toJson(message).getBytes(StandardCharsets.UTF_8);
    }

    /** @throws RuntimeException si le message n'a pas cette forme */
    public static <T> T lire(Class<T> type, DataInputStream message) throws IOException {
        return JSON.fromJson(new String(message.readAllBytes(), StandardCharsets.UTF_8), type);
    }

    public static void main(String[] args) throws IOException {
        Compilateur ici = new Compilateur();
        Echange.servir(System.in, System.out, message -> {
            Demande demande = lire(Demande.class, message);
            Reponse reponse = new Reponse();
            if (!demande.aLire.isEmpty()) {
                reponse.lus = Lecteur.lire(demande.aLire);
                return ecrire(reponse);
            }
            Path dossier = Files.createTempDirectory("compilation").toRealPath();
            try {
                ici.compiler(dossier, demande.sources, reponse);
            } catch (IOException | RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
                // une source fait échouer le compilateur
                reponse.classes.clear();
            } finally {
                FileUtils.deleteQuietly(dossier.toFile());
            }
            return ecrire(reponse);
        });
    }

    private void compiler(Path dossier, Map<String, String> sources, Reponse reponse) throws IOException {
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
            if (faute.getKind() == Diagnostic.Kind.ERROR && reponse.fautes.size() < FAUTES_MAX) {
                reponse.fautes.add(new Faute(faute.getSource() == null ? "?" : dossier.relativize(Paths.get(faute.getSource().toUri()))
                        .toString().replace('\\', '/'), (int) faute.getLineNumber(), faute.getMessage(Locale.ROOT)));
            }
        }, List.of("-source", niveau, "-target", niveau, "-encoding", "UTF-8", "-g", "-nowarn", "-proc:none", "-proceedOnError",
                "-classpath", System.getProperty("java.class.path")), null,
                gestion.getJavaFileObjectsFromPaths(fichiers)).call();
        ecrites.stream().limit(CLASSES_MAX + 1).forEach(c -> reponse.classes.put(c.nom.replace('/', '.'), c.ecrit.toByteArray()));
        if (ecrites.size() > CLASSES_MAX) {
            throw new IllegalStateException("trop de classes");
        }
    }
}
