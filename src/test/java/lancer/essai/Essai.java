package lancer.essai;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.io.UnsupportedEncodingException;
import java.lang.reflect.Method;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import lancer.Main;
import lancer.scene.LecteurSections;

/** De quoi essayer le programme entier, par sa ligne de commande : ce qu'il a rendu, et les images qu'il a écrites. */
public final class Essai {

    /** Ce que dit le programme quand sa recherche cachait une réponse, et que les boucles dessinent à sa place. */
    private static final String REPLI = "image dessinée par les boucles, plus lentement";

    private static final Method ICI = programme(Essai.class.getClassLoader());

    /** Statut de sortie. */
    public final int code;

    /** Ce qui a été écrit sur la sortie standard et sur la sortie d'erreur. */
    public final String sortie;
    public final String erreur;

    private Essai(int code, String sortie, String erreur) {
        this.code = code;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    /** Le programme, avec les classes de ce chemin, variantes comprises. */
    public static Essai executer(String... args) {
        return executer(ICI, args);
    }

    /** Comme {@link #executer(String...)}, avec ces flux ; rend le statut. */
    public static int executer(PrintStream sortie, PrintStream erreur, String... args) {
        return executer(ICI, sortie, erreur, args);
    }

    /**
     * Le programme, avec les seules classes de la base, d'ini4j et de ces dossiers ou archives, comme {@code java -cp} : une
     * variante qui est dans le chemin des classes des essais n'y est que si elle est nommée.
     */
    public static Essai executerAvec(List<Path> classes, String... args) throws IOException {
        try (Isole isole = new Isole(classes)) {
            return isole.executer(args);
        }
    }

    /** Le programme de {@link #executerAvec}, pour plusieurs exécutions. */
    public static final class Isole implements Closeable {

        private final URLClassLoader classes;
        private final Method executer;

        public Isole(List<Path> ajoutees) throws IOException {
            this(List.of(), ajoutees);
        }

        /** @param devant dossiers dont les classes passent avant celles du programme */
        public Isole(List<Path> devant, List<Path> ajoutees) throws IOException {
            List<URL> chemin = new ArrayList<>();
            for (Path p : devant) {
                chemin.add(p.toUri().toURL());
            }
            chemin.add(origine(Main.class).toUri().toURL());
            chemin.add(origine(org.ini4j.Config.class).toUri().toURL());
            for (Path p : ajoutees) {
                chemin.add(p.toUri().toURL());
            }
            classes = new URLClassLoader(chemin.toArray(new URL[0]), ClassLoader.getSystemClassLoader().getParent());
            executer = programme(classes);
        }

        public Essai executer(String... args) {
            return Essai.executer(executer, args);
        }

        /** Le programme, dont la recherche cache une réponse : il le dit. */
        public Essai executerAvecRepli(String... args) {
            Essai essai = executerToujours(executer, args);
            if (!essai.erreur.contains(REPLI)) {
                throw new AssertionError("rien ne dit que les boucles dessinent : " + essai);
            }
            return essai;
        }

        @Override
        public void close() throws IOException {
            classes.close();
        }
    }

    /** Le programme entier, sans quitter la machine virtuelle : {@link Main} ne l'offre pas à d'autres paquets que le sien. */
    private static Method programme(ClassLoader classes) {
        try {
            Method executer = classes.loadClass(Main.class.getName())
                    .getDeclaredMethod("executer", String[].class, PrintStream.class, PrintStream.class);
            executer.setAccessible(true);
            return executer;
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Essai executer(Method programme, String... args) {
        Essai essai = executerToujours(programme, args);
        exigerLaRecherche(essai.erreur);
        return essai;
    }

    /** Une recherche qui se trompe ne passe pas inaperçue parce que les boucles dessinent à sa place. */
    public static void exigerLaRecherche(String dit) {
        if (dit != null && dit.contains(REPLI)) {
            throw new AssertionError("la recherche cachait une réponse : " + dit);
        }
    }

    private static Essai executerToujours(Method programme, String... args) {
        ByteArrayOutputStream sortie = new ByteArrayOutputStream();
        ByteArrayOutputStream erreur = new ByteArrayOutputStream();
        try {
            int code = executer(programme, new PrintStream(sortie, true, "UTF-8"), new PrintStream(erreur, true, "UTF-8"), args);
            return new Essai(code, sortie.toString("UTF-8"), erreur.toString("UTF-8"));
        } catch (UnsupportedEncodingException e) {
            throw new IllegalStateException(e);
        }
    }

    private static int executer(Method programme, PrintStream sortie, PrintStream erreur, String... args) {
        try {
            return (int) programme.invoke(null, args, sortie, erreur);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Ce qui est sur la sortie d'erreur, moins les formes qui finissent la liste des types de section, celle-ci exceptée. */
    public String sansAutresFormes(String forme) {
        return erreur.replaceAll(", Blinn(?:, (?!" + forme + "\\b)\\w+)*(, " + forme + ")?(?:, \\w+)*", ", Blinn$1");
    }

    /** Le programme a rendu ce statut, et n'a dit que cette ligne. */
    public void exigerRefus(int statut, String message) {
        assertEquals("lancer : " + message + System.lineSeparator(), erreur);
        assertEquals(statut, code);
        assertEquals("", sortie);
    }

    /** De quoi comprendre un essai qui échoue. */
    @Override
    public String toString() {
        return "statut " + code + ", sortie « " + sortie + " », erreur « " + erreur + " »";
    }

    /** Le dossier ou l'archive d'où vient cette classe. */
    public static Path origine(Class<?> classe) {
        try {
            return Path.of(classe.getProtectionDomain().getCodeSource().getLocation().toURI());
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Le message que dit ce texte : {@code {fichier}} y est cette scène, {@code {matière}} la liste des clés d'une matière. */
    public static String message(String texte, Path scene) {
        return texte.replace("{fichier}", scene.toString()).replace("{matière}", String.join(", ", LecteurSections.CLES_MATIERE))
                .replace("\n", System.lineSeparator());
    }

    /** La valeur d'une ligne de {@code --statistiques}. */
    public long statistique(String nom) {
        for (String ligne : sortie.split("\n")) {
            if (ligne.startsWith(nom + ": ")) {
                return Long.parseLong(ligne.substring(nom.length() + 2));
            }
        }
        throw new AssertionError("pas de « " + nom + " » dans : " + sortie);
    }

    /** Écrit ces lignes dans un fichier de scène. */
    public static Path scene(Path fichier, String... lignes) throws IOException {
        return Files.write(fichier, List.of(lignes), StandardCharsets.UTF_8);
    }

    /** Le texte d'un fichier du dépôt, dont git a pu changer les fins de ligne. */
    public static String texte(String fichier) throws IOException {
        return Files.readString(Path.of(fichier)).replace("\r\n", "\n");
    }

    /** Une ressource d'essai de la classe, en texte. */
    public static String ressource(Class<?> classe, String nom) throws IOException {
        return new String(octets(classe, nom), StandardCharsets.UTF_8);
    }

    /** Une ressource d'essai de la classe. */
    public static byte[] octets(Class<?> classe, String nom) throws IOException {
        try (InputStream entree = classe.getResourceAsStream(nom)) {
            if (entree == null) {
                throw new AssertionError("ressource absente : " + nom);
            }
            return entree.readAllBytes();
        }
    }

    /** Les composantes d'une image PFM couleur, dans l'ordre du fichier : la ligne du bas d'abord. */
    public static float[] pfm(byte[] octets) {
        int debut = 0;
        for (int lignes = 0; lignes < 3; debut++) {
            lignes += octets[debut] == '\n' ? 1 : 0;
        }
        ByteBuffer donnees = ByteBuffer.wrap(octets, debut, octets.length - debut).order(ByteOrder.LITTLE_ENDIAN);
        float[] composantes = new float[(octets.length - debut) / Float.BYTES];
        donnees.asFloatBuffer().get(composantes);
        return composantes;
    }

    /** Dessine une scène par la ligne de commande, et rend ses composantes non limitées ; tout avertissement est un échec. */
    public static float[] dessiner(Path dossier, Path scene, String... options) throws IOException {
        return dessinee(executer(arguments(dossier, scene, options)), dossier);
    }

    /** Comme {@link #dessiner}, avec les seules classes que dit {@link #executerAvec}. */
    public static float[] dessinerAvec(List<Path> classes, Path dossier, Path scene, String... options) throws IOException {
        return dessinee(executerAvec(classes, arguments(dossier, scene, options)), dossier);
    }

    private static String[] arguments(Path dossier, Path scene, String... options) {
        return suite(options, "--lineaire", dossier.resolve("image.pfm").toString(), scene.toString());
    }

    /** Ces arguments, puis ceux-là. */
    public static String[] suite(String[] arguments, String... suite) {
        return Stream.concat(Stream.of(arguments), Stream.of(suite)).toArray(String[]::new);
    }

    private static float[] dessinee(Essai essai, Path dossier) throws IOException {
        if (essai.code != 0 || !essai.erreur.isEmpty()) {
            throw new AssertionError("statut " + essai.code + " : " + essai.erreur);
        }
        return pfm(Files.readAllBytes(dossier.resolve("image.pfm")));
    }

    /**
     * L'image que {@link #dessiner} vient d'écrire dans ce dossier est celle de référence, aux arrondis des doubles et des flottants
     * près. {@code make -f outils/Makefile references} met l'image à la place d'une référence dont elle s'écarte.
     */
    public static void verifierReference(String reference, Path dossier) throws IOException {
        Path image = dossier.resolve("image.pfm");
        double ecart = Ressources.ecart(pfm(Files.readAllBytes(image)), pfm(octets(Essai.class, "/reference/" + reference)));
        if (ecart > 1e-6 && Boolean.getBoolean("references.refaites")) {
            Files.copy(image, Path.of("src/test/resources/reference", reference), StandardCopyOption.REPLACE_EXISTING);
            System.out.println("changée : " + reference);
        } else if (!(ecart <= 1e-6)) {
            throw new AssertionError(reference + " : écart " + ecart);
        }
    }
}
