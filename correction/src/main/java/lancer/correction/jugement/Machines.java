package lancer.correction.jugement;

import java.io.DataInputStream;
import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import javax.tools.JavaCompiler;
import lancer.correction.Panne;
import lancer.correction.enfant.Compilateur;
import lancer.correction.enfant.Echange;
import lancer.correction.enfant.Execution;
import lancer.correction.enfant.Lecteur;
import lancer.correction.isolement.Arret;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Enfant;
import lancer.correction.isolement.Limites;
import org.ini4j.Ini;
import org.junit.jupiter.api.Test;
import org.junit.platform.commons.JUnitException;
import org.opentest4j.AssertionFailedError;

/** Les machines virtuelles à part : celle qui compile, et celle, relancée à chaque mort, où tourne un rendu. */
final class Machines {

    private final Confinement confinement;
    private final Limites limites;
    /** L'archive des seules classes que voit un rendu avec les siennes. */
    private final Path outillage;

    /**
     * Lieux d'où viennent JUnit, ini4j, le compilateur et nous, pour compiler ; jamais la base, même si elle est dans le
     * chemin des classes.
     */
    private final String chemin = Stream.concat(
            Stream.of(Execution.class, Ini.class, Test.class, AssertionFailedError.class, JUnitException.class),
            ServiceLoader.load(JavaCompiler.class).stream().map(ServiceLoader.Provider::type)
            .filter(c -> c.getName().startsWith("org.eclipse."))).map(Machines::lieu).distinct()
            .collect(Collectors.joining(File.pathSeparator));

    /** @param dossier ce qui y est s'efface */
    Machines(Confinement confinement, Limites limites, Path dossier) throws IOException {
        this.confinement = confinement;
        this.limites = limites;
        if (Files.exists(dossier)) {
            Compilateur.effacer(dossier);
        }
        outillage = Files.createDirectories(dossier).resolve("outillage.jar");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(outillage))) {
            for (Class<?> une : List.of(Execution.class, Ini.class)) {
                copier(une.getPackageName().replace('.', '/'), Path.of(lieu(une)), zip);
            }
        }
    }

    /** Copie les classes d'un paquet : le rendu ne doit voir ni le corrigé, ni les vérifications, ni JUnit. */
    private static void copier(String paquet, Path lieu, ZipOutputStream zip) throws IOException {
        try (FileSystem archive = Files.isDirectory(lieu) ? null : FileSystems.newFileSystem(lieu, (ClassLoader) null);
                Stream<Path> flux = Files.walk((archive == null ? lieu : archive.getPath("/")).resolve(paquet))) {
            for (Path classe : flux.filter(f -> f.toString().endsWith(".class")).collect(Collectors.toList())) {
                zip.putNextEntry(new ZipEntry(paquet + "/" + classe.toString().replace('\\', '/').replaceFirst(".*" + paquet + "/", "")));
                Files.copy(classe, zip);
            }
        }
    }

    /** Lieu d'où vient une classe : une archive, ou un dossier. */
    static String lieu(Class<?> classe) {
        try {
            return Path.of(classe.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    interface LectureDeReponse<T> {
        T lire(DataInputStream reponse) throws IOException;
    }

    /** Une demande qui commence par sa sorte, et a des textes ou des classes. */
    private static Echange.Redaction demande(char sorte, Map<String, byte[]> tout) {
        return message -> {
            message.writeChar(sorte);
            Echange.ecrireTout(message, tout);
        };
    }

    /** Une machine virtuelle à part, tant qu'elle répond comme il faut. */
    private abstract class Machine implements AutoCloseable {

        Enfant enfant;

        /**
         * Lance la machine, si elle ne l'est pas, et attend d'elle une première réponse : ce qui l'arrête ensuite vient de ce qu'on
         * lui donne.
         *
         * @return vrai si elle est neuve
         * @throws Panne si elle ne répond pas
         */
        boolean lancer(Class<?> principale, String chemin, Limites siennes) {
            if (enfant != null) {
                return false;
            }
            boolean visibles = principale == Compilateur.class;
            enfant = new Enfant(confinement.java(principale, chemin, visibles, outillage.getParent(), siennes), siennes);
            try {
                enfant.commencer(Limites.DE_COMPILATION.calcul);
                demander(demande(visibles ? Compilateur.COMPILER : Execution.CLASSES, Map.of()), Echange.REPONSE_MAX,
                        DataInputStream::readAllBytes);
                return true;
            } catch (Arret e) {
                throw new Panne(1, "une machine virtuelle n'a pas pu commencer : " + e.getMessage());
            }
        }

        /** Pose une question, et lit toute la réponse ; ce qui n'en est pas une arrête la machine. */
        <T> T demander(Echange.Redaction demande, int max, LectureDeReponse<T> lecture) throws Arret {
            try {
                DataInputStream reponse = enfant.demander(Echange.message(demande), max);
                try {
                    T lue = lecture.lire(reponse);
                    if (reponse.available() == 0) {
                        return lue;
                    }
                } catch (IOException | ClassCastException e) {
                    // plus courte qu'elle ne le dit, ou d'une autre forme
                }
                throw enfant.arreter("arrêté : a répondu ce qui n'a pas de sens");
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            } catch (Arret e) {
                close();
                throw e;
            }
        }

        @Override
        public void close() {
            if (enfant != null) {
                enfant.close();
                enfant = null;
            }
        }
    }

    /** Un assemblage de classes compilé : les octets de chacune, par son nom, et les fautes. */
    static final class Assemblage {

        final Map<String, byte[]> classes;
        final List<Faute> fautes;
        /** Vrai si une vérification n'y a pas fini. */
        boolean arrete;

        Assemblage(Map<String, byte[]> classes, List<Faute> fautes) {
            this.classes = classes;
            this.fautes = fautes;
        }

        List<Faute> fautesDe(String classe) {
            return fautes.stream().filter(f -> f.classe().equals(classe)).collect(Collectors.toList());
        }
    }

    /** Lit et compile des sources, puis d'autres : aucun rendu ne tourne ici. */
    final class Compilation extends Machine {

        /** Ce que le JDK lit de ces textes, voir {@link Lecteur#lire} ; une valeur chacun. */
        List<?> lire(List<String> textes) throws Arret {
            Map<String, String> tous = new LinkedHashMap<>();
            textes.forEach(t -> tous.put(String.valueOf(tous.size()), t));
            return demander(Compilateur.LIRE, tous, reponse -> {
                List<?> lus = (List<?>) Echange.lireValeur(reponse, o -> null);
                if (lus.size() != textes.size()) {
                    throw new IOException();
                }
                return lus;
            });
        }

        private <T> T demander(char sorte, Map<String, String> textes, LectureDeReponse<T> lecture) throws Arret {
            Map<String, byte[]> octets = new LinkedHashMap<>();
            textes.forEach((nom, texte) -> octets.put(nom, texte.getBytes(StandardCharsets.UTF_8)));
            lancer(Compilateur.class, chemin, Limites.DE_COMPILATION);
            enfant.commencer(Limites.DE_COMPILATION.calcul);
            try {
                return demander(demande(sorte, octets), Echange.GROSSE_REPONSE_MAX, lecture);
            } catch (Arret e) {
                if (e.tue) {
                    throw new Panne(1, "le compilateur a été tué : " + e.getMessage());
                }
                throw e;
            }
        }

        /**
         * @param sources le texte de chaque fichier, par son nom : {@code lancer/Vecteur}
         * @throws Arret si ces sources font échouer le compilateur ; @throws Panne s'il échoue sans elles, ou si un autre le tue
         */
        Assemblage compiler(Map<String, String> sources) throws Arret {
            Assemblage assemblage = demander(Compilateur.COMPILER, sources, reponse -> {
                List<?> fautes = (List<?>) Echange.lireValeur(reponse, o -> null);
                return new Assemblage(Echange.lireTout(reponse), fautes == null ? null : fautes.stream()
                        .map(f -> new Faute((List<?>) f)).collect(Collectors.toList()));
            });
            if (assemblage.fautes == null) {
                close();
                throw new Arret("arrêté : ces sources font échouer le compilateur", false);
            }
            return assemblage;
        }
    }

    /** Machine où tourne un rendu, qui n'a que les classes de son assemblage. */
    final class Rendue extends Machine {

        final Map<String, byte[]> classes;

        Rendue(Map<String, byte[]> classes) {
            this.classes = classes;
        }

        /** Commence une autre demande, qui n'a plus besoin des objets rendus à la précédente. */
        void oublier() throws Arret {
            commencer(1);
            if (!demander(m -> m.writeChar(Execution.OUBLI), Echange.REPONSE_MAX,
                    r -> r.readChar() == Execution.RENDU && r.readInt() == 0)) {
                // des fils courent encore : une machine neuve
                close();
                commencer(1);
            }
        }

        /**
         * @param fois combien de fois le temps ordinaire d'une demande est permis à ce qui suit
         * @throws Arret si ces classes arrêtent une machine neuve
         */
        void commencer(double fois) throws Arret {
            if (lancer(Execution.class, outillage.toString(), limites)) {
                demander(demande(Execution.CLASSES, classes), Echange.REPONSE_MAX, DataInputStream::readChar);
            }
            enfant.commencer(fois * limites.calcul);
        }

        /** Réponse de la sonde sur cette scène. @param max ce que la réponse peut peser, en octets */
        String sonder(int max, String methode, String scene, Object... arguments) throws Arret {
            return demander(m -> {
                m.writeChar(Execution.SONDE);
                Echange.ecrireTexte(m, scene);
                Echange.ecrireTexte(m, methode);
                Echange.ecrireValeur(m, Stream.of(arguments).map(String::valueOf).collect(Collectors.toList()), o -> null);
            }, max, reponse -> Dialogue.reponse(reponse, Echange::lireTexte));
        }
    }
}
