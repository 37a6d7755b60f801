package lancer.correction.jugement;

import java.io.ByteArrayInputStream;
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
import lancer.correction.depot.Depot;
import lancer.correction.enfant.Compilateur;
import lancer.correction.enfant.Contenu;
import lancer.correction.enfant.Echange;
import lancer.correction.enfant.Execution;
import lancer.correction.enfant.Lecteur;
import lancer.correction.isolement.Arret;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Enfant;
import lancer.correction.isolement.Limites;
import org.apache.commons.compress.archivers.zip.ZipFile;
import org.apache.commons.io.function.IOSupplier;
import org.apache.commons.lang3.ArrayFill;
import org.ini4j.Ini;
import org.junit.jupiter.api.Test;
import org.junit.platform.commons.JUnitException;
import org.opentest4j.AssertionFailedError;

/** Les autres machines virtuelles : celle qui compile, et celle qui exécute un rendu, relancée après chaque arrêt. */
final class Machines {

    private final Confinement confinement;
    private final Limites limites;
    /** L'archive des classes qu'un rendu voit, avec les siennes. */
    private final Path outillage;

    /** Chemin des classes du compilateur : JUnit, ini4j, le compilateur, la correction. La base n'y est jamais. */
    private final String chemin = chemin(Stream.concat(
            Stream.of(Execution.class, Ini.class, Test.class, AssertionFailedError.class, JUnitException.class),
            ServiceLoader.load(JavaCompiler.class).stream().map(ServiceLoader.Provider::type)
            .filter(c -> c.getName().startsWith("org.eclipse."))));

    /** @param dossier son contenu est effacé */
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

    /** Copie les classes d'un paquet. Le rendu ne doit voir ni le corrigé, ni les vérifications, ni JUnit. */
    private static void copier(String paquet, Path lieu, ZipOutputStream zip) throws IOException {
        try (FileSystem archive = Files.isDirectory(lieu) ? null : FileSystems.newFileSystem(lieu, (ClassLoader) null);
                Stream<Path> flux = Files.walk((archive == null ? lieu : archive.getPath("/")).resolve(paquet))) {
            for (Path classe : flux.filter(f -> f.toString().endsWith(".class")).collect(Collectors.toList())) {
                zip.putNextEntry(new ZipEntry(paquet + "/" + classe.toString().replace('\\', '/').replaceFirst(".*" + paquet + "/", "")));
                Files.copy(classe, zip);
            }
        }
    }

    private static String chemin(Stream<Class<?>> classes) {
        return classes.map(Machines::lieu).distinct().collect(Collectors.joining(File.pathSeparator));
    }

    /** L'archive ou le dossier d'une classe. */
    static String lieu(Class<?> classe) {
        try {
            return Path.of(classe.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Lecture d'une réponse. */
    interface LectureDeReponse<T> {
        T lire(DataInputStream reponse) throws IOException;
    }

    /** Une demande : sa sorte, puis des textes ou des classes. */
    private static Echange.Redaction demande(char sorte, Map<String, byte[]> tout) {
        return message -> {
            message.writeChar(sorte);
            Echange.ecrireTout(message, tout);
        };
    }

    /** Une autre machine virtuelle, relancée si elle a été arrêtée. */
    private abstract class Machine implements AutoCloseable {

        Enfant enfant;

        /**
         * Lance la machine virtuelle si besoin, et attend une première réponse : un arrêt ultérieur vient alors de la demande.
         *
         * @return vrai si elle vient d'être lancée
         * @throws Panne si elle ne répond pas
         */
        boolean lancer(Class<?> principale, String chemin, Limites siennes, Echange.Redaction premiere, Path... aLire) {
            if (enfant != null) {
                return false;
            }
            enfant = new Enfant(confinement.java(principale, chemin, principale != Execution.class, outillage.getParent(), siennes, aLire),
                    siennes);
            try {
                enfant.commencer(Limites.DE_COMPILATION.calcul);
                demander(premiere, Echange.REPONSE_MAX, DataInputStream::readAllBytes);
                return true;
            } catch (Arret e) {
                throw new Panne(1, "une machine virtuelle n'a pas pu commencer : " + e.getMessage());
            }
        }

        /** Envoie une demande, et lit toute la réponse ; une réponse de forme inattendue arrête la machine virtuelle. */
        <T> T demander(Echange.Redaction demande, int max, LectureDeReponse<T> lecture) throws Arret {
            try {
                DataInputStream reponse = enfant.demander(Echange.message(demande), max);
                try {
                    T lue = lecture.lire(reponse);
                    if (reponse.available() == 0) {
                        return lue;
                    }
                } catch (IOException | ClassCastException e) {
                    // réponse trop courte, ou d'une autre forme
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

    /** Machine virtuelle qui lit les dossiers et les archives d'une classe ; elle n'exécute aucun rendu. */
    final class Lecture extends Machine implements Depot.Acces {

        private final Path rendus;

        Lecture(Path rendus) {
            this.rendus = rendus;
        }

        @Override
        public DataInputStream demander(Map<String, byte[]> noms) throws Arret {
            lancer(Contenu.class, Machines.chemin(Stream.of(Contenu.class, ZipFile.class, IOSupplier.class, ArrayFill.class)),
                    Limites.DE_COMPILATION, m -> Echange.ecrireTout(m, Map.of()), rendus);
            enfant.commencer(Limites.DE_COMPILATION.calcul);
            Map<String, byte[]> demande = new LinkedHashMap<>();
            demande.put(confinement.lu(rendus), new byte[0]);
            demande.putAll(noms);
            return demander(m -> Echange.ecrireTout(m, demande), Echange.GROSSE_REPONSE_MAX,
                    reponse -> new DataInputStream(new ByteArrayInputStream(reponse.readAllBytes())));
        }
    }

    /** Un assemblage de classes compilé : les octets de chacune, par nom, et les fautes. */
    static final class Assemblage {

        final Map<String, byte[]> classes;
        final List<Faute> fautes;
        /** Vrai si une vérification de cet assemblage n'a pas fini. */
        boolean arrete;

        Assemblage(Map<String, byte[]> classes, List<Faute> fautes) {
            this.classes = classes;
            this.fautes = fautes;
        }

        List<Faute> fautesDe(String classe) {
            return fautes.stream().filter(f -> f.classe().equals(classe)).collect(Collectors.toList());
        }
    }

    /** Machine virtuelle qui lit et compile des sources ; elle n'exécute aucun rendu. */
    final class Compilation extends Machine {

        /** Lecture de ces textes par le JDK, une valeur par texte : voir {@link Lecteur#lire}. */
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
            lancer(Compilateur.class, chemin, Limites.DE_COMPILATION, demande(Compilateur.COMPILER, Map.of()));
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
         * @param sources le texte de chaque fichier, par nom : {@code lancer/Vecteur}
         * @throws Arret si ces sources font échouer le compilateur ; @throws Panne s'il échoue sans elles, ou s'il est tué
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

    /** Machine virtuelle qui exécute un rendu, avec les seules classes de son assemblage. */
    final class Rendue extends Machine {

        final Map<String, byte[]> classes;

        Rendue(Map<String, byte[]> classes) {
            this.classes = classes;
        }

        /** Commence une demande qui n'utilise plus les objets de la précédente. */
        void oublier() throws Arret {
            commencer(1);
            if (!demander(m -> m.writeChar(Execution.OUBLI), Echange.REPONSE_MAX,
                    r -> r.readChar() == Execution.RENDU && r.readInt() == 0)) {
                // des fils s'exécutent encore : il faut une nouvelle machine virtuelle
                close();
                commencer(1);
            }
        }

        /**
         * @param fois nombre de fois que le temps ordinaire d'une demande est permis
         * @throws Arret si ces classes arrêtent une nouvelle machine virtuelle
         */
        void commencer(double fois) throws Arret {
            if (lancer(Execution.class, outillage.toString(), limites, demande(Execution.CLASSES, Map.of()))) {
                demander(demande(Execution.CLASSES, classes), Echange.REPONSE_MAX, DataInputStream::readChar);
            }
            enfant.commencer(fois * limites.calcul);
        }

        /** Réponse de la sonde sur cette scène. @param max taille maximale de la réponse, en octets */
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
