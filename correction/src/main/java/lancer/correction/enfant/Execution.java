package lancer.correction.enfant;

import java.io.DataInputStream;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.UndeclaredThrowableException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * La machine virtuelle où s'exécute un rendu. Elle ne connaît pas les vérifications : elle reçoit l'ordre d'appeler une méthode, et répond
 * ce que la méthode rend. Elle ne contient ni valeur attendue, ni verdict, ni secret : un rendu ne peut falsifier que sa propre réponse.
 *
 * <p>Une demande commence par sa sorte, et sa réponse par la sienne : le résultat, ou une raison et un lieu.
 */
public final class Execution {

    /** Donne les classes du rendu, une seule fois : le nom puis les octets de chacune. */
    public static final String CLASSES = "C";
    /** Appelle une méthode, par son numéro dans {@code lancer.Appels} ; rend son résultat, puis les champs publics de celui-ci. */
    public static final String APPEL = "A";
    /** Appelle une méthode de la sonde, avec la scène qu'elle lit ; rend une image, en octets, ou une liste de textes. */
    public static final String SONDE = "S";
    /** Oublie les objets déjà rendus ; rend le nombre de fils que le rendu a laissés. */
    public static final String OUBLI = "O";

    /** Sorte d'une réponse : le résultat de la méthode. */
    public static final String RENDU = "R";
    /** Autres sortes de réponses : une exception, une récursion sans fin, une faute de compilation. */
    public static final String EXCEPTION = "E";
    public static final String SANS_FIN = "S";
    public static final String FAUTE = "F";

    /** Début du message que le compilateur met dans une méthode fautive. */
    private static final String NON_COMPILE = "Unresolved compilation problem";

    private Classes classes;
    /** Les méthodes déjà appelées, par leur nom complet : les chercher durerait plus que l'appel. */
    private final Map<String, Method> methodes = new HashMap<>();
    private final List<Object> objets = new ArrayList<>();
    private final Map<Object, Integer> numeros = new IdentityHashMap<>();

    private Execution() {
    }

    /**
     * Chargeur de classes, prioritaire sur les autres classes de même nom. Il définit toutes les classes, puis oublie leurs octets : aucune
     * ne peut lire les autres.
     */
    public static final class Classes extends ClassLoader {

        private final Map<String, byte[]> octets;

        /** @param octets ceux de chaque classe, par nom complet ; @param pere chargeur des autres classes */
        public Classes(Map<String, byte[]> octets, ClassLoader pere) {
            super(pere);
            this.octets = new HashMap<>(octets);
            for (String nom : octets.keySet()) {
                try {
                    loadClass(nom);
                } catch (ClassNotFoundException | LinkageError | RuntimeException | StackOverflowError e) {
                    // cette classe manque, ou Java la refuse (SecurityException) : l'appel qui la nomme échouera
                }
            }
        }

        @Override
        protected Class<?> loadClass(String nom, boolean resoudre) throws ClassNotFoundException {
            synchronized (getClassLoadingLock(nom)) {
                byte[] classe = octets.remove(nom);
                return classe == null ? super.loadClass(nom, resoudre) : defineClass(nom, classe, 0, classe.length);
            }
        }
    }

    public static void main(String[] args) throws IOException {
        InputStream demandes = new FileInputStream(FileDescriptor.in);
        OutputStream reponses = new FileOutputStream(FileDescriptor.out);
        System.setIn(InputStream.nullInputStream());
        PrintStream puits = new Puits();
        System.setOut(puits);
        System.setErr(puits);
        try {
            Echange.servir(demandes, reponses, new Execution()::repondre);
        } finally {
            // les fils que le rendu a laissés ne doivent pas empêcher l'arrêt
            Runtime.getRuntime().halt(0);
        }
    }

    /** Ignore les affichages d'un rendu, sans même les coder : un affichage par rayon ne doit pas passer pour une boucle sans fin. */
    private static final class Puits extends PrintStream {

        Puits() {
            super(OutputStream.nullOutputStream());
        }

        @Override
        public void println(String texte) {
            // rien à faire
        }

        @Override
        public void print(String texte) {
            // rien à faire
        }

        @Override
        public PrintStream format(String modele, Object... arguments) {
            return this;
        }
    }

    private byte[] repondre(DataInputStream message) throws IOException {
        try {
            List<?> demande = (List<?>) Echange.lire(message, o -> objets.get(o.numero));
            return Echange.message(traiter((String) demande.get(0), demande.subList(1, demande.size())), this::nommer);
        } catch (Throwable e) {
            return Echange.message(cause(e instanceof UndeclaredThrowableException ? e.getCause() : e), this::nommer);
        }
    }

    private List<?> traiter(String sorte, List<?> demande) throws IOException {
        if (sorte.equals(CLASSES)) {
            Map<String, byte[]> octets = new HashMap<>();
            for (int k = 0; k < demande.size(); k += 2) {
                octets.put((String) demande.get(k), (byte[]) demande.get(k + 1));
            }
            classes = new Classes(octets, Execution.class.getClassLoader());
            Thread.currentThread().setContextClassLoader(classes);
            return List.of(RENDU);
        } else if (sorte.equals(APPEL)) {
            Object rendu = invoquer("lancer.Appels", "m" + demande.get(0), List.of(Object[].class),
                    (Object) ((List<?>) demande.get(1)).toArray());
            if (rendu instanceof Object[]) {
                rendu = remplacer((Object[]) rendu);
            }
            return Arrays.asList(RENDU, rendu, Arrays.asList((Object[]) invoquer("lancer.Appels", "champs", List.of(Object.class), rendu)));
        } else if (sorte.equals(SONDE)) {
            return List.of(RENDU, sonder((String) demande.get(0), (byte[]) demande.get(1), (List<?>) demande.get(2)));
        }
        objets.clear();
        numeros.clear();
        return List.of(RENDU, Thread.currentThread().getThreadGroup().activeCount() - 1);
    }

    /** Une scène lue d'un fichier, puis des objets et leurs copies, que cette scène contient : chacune prend le numéro du sien. */
    private Object remplacer(Object[] scene) {
        for (int k = 1; k < scene.length; k += 2) {
            Integer numero = numeros.remove(scene[k]);
            numeros.put(scene[k + 1], numero);
            objets.set(numero, scene[k + 1]);
        }
        return scene[0];
    }

    private Echange.Objet nommer(Object objet) {
        numeros.computeIfAbsent(objet, o -> {
            objets.add(o);
            return objets.size() - 1;
        });
        return new Echange.Objet(numeros.get(objet), (String) invoquer("lancer.Appels", "nom", List.of(Object.class), objet));
    }

    /** Appelle une méthode de la sonde, dont le premier argument est un fichier de scène, écrit ici. */
    private Object sonder(String methode, byte[] texte, List<?> arguments) throws IOException {
        Path scene = Path.of(System.getProperty("java.io.tmpdir"), "scene-" + ProcessHandle.current().pid() + ".ini");
        Files.write(scene, texte);
        try {
            return invoquer("lancer.Sonde", methode, List.of(String.class, String[].class), scene.toString(),
                    arguments.toArray(new String[0]));
        } finally {
            Files.deleteIfExists(scene);
        }
    }

    private Object invoquer(String classe, String methode, List<Class<?>> types, Object... arguments) {
        try {
            String nom = classe + "." + methode;
            Method trouvee = methodes.get(nom);
            if (trouvee == null) {
                trouvee = Class.forName(classe, true, classes).getMethod(methode, types.toArray(new Class<?>[0]));
                methodes.put(nom, trouvee);
            }
            return trouvee.invoke(null, arguments);
        } catch (InvocationTargetException e) {
            throw new UndeclaredThrowableException(e.getCause());
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Répond par une exception du rendu, avec la première ligne de son code, ou par une faute de compilation. */
    private static List<?> cause(Throwable e) {
        String message = String.valueOf(e.getMessage());
        String nom = e.getClass().getName();
        Throwable statique = e instanceof NoClassDefFoundError ? e.getCause() : e;
        if (statique instanceof ExceptionInInitializerError) {
            // la première fois, sa cause ; ensuite, ce que Java en a gardé
            Throwable origine = statique.getCause() == null ? statique : statique.getCause();
            String dit = origine != statique ? origine.toString() : String.valueOf(statique.getMessage())
                    .replaceFirst("^Exception ", "").replaceFirst(" \\[in thread [^]]*]$", "");
            if (dit.contains(NON_COMPILE)) {
                return List.of(FAUTE, ou(statique), "");
            }
            return List.of(EXCEPTION, "un champ statique échoue : " + dit.replaceFirst("^(\\w+\\.)+", "") + ou(origine), "");
        } else if (e instanceof StackOverflowError) {
            return List.of(SANS_FIN, "appels sans fin (StackOverflowError)" + ou(e), "");
        } else if (nom.equals("java.lang.Error") && message.startsWith(NON_COMPILE)) {
            return List.of(FAUTE, ou(e), message.replaceFirst("^[^\n]*+\n", "").trim().split("\n")[0]);
        } else if (e instanceof LinkageError && !(e instanceof UnsatisfiedLinkError) && !message.startsWith("java")) {
            // une classe du rendu qui n'a pu être définie manque à toutes celles qui la nomment
            return List.of(FAUTE, ou(e), "");
        }
        return List.of(EXCEPTION, nom.replaceFirst(".*\\.", "") + (e.getMessage() == null ? "" : " : " + message) + ou(e), "");
    }

    private static String ou(Throwable e) {
        for (StackTraceElement ou : e.getStackTrace()) {
            if (ou.getClassName().startsWith("lancer.") && !ou.getClassName().startsWith("lancer.correction.")) {
                return ou.getClassName().matches("lancer\\.(Appels|Sonde)") ? ""
                        : ", " + ou.getFileName() + ":" + ou.getLineNumber() + " (" + ou.getMethodName() + ")";
            }
        }
        return "";
    }
}
