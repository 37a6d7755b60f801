package lancer.correction.jugement;

import com.google.gson.Gson;
import com.google.gson.JsonParseException;
import java.io.DataInputStream;
import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.ServiceLoader;
import java.util.concurrent.atomic.DoubleAdder;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import javax.tools.JavaCompiler;
import lancer.correction.Panne;
import lancer.correction.depot.Compilateur;
import lancer.correction.depot.Faute;
import lancer.correction.depot.Lecteur;
import lancer.correction.depot.Source;
import lancer.correction.enfant.Echange;
import lancer.correction.enfant.Execution;
import lancer.correction.isolement.Arret;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Enfant;
import lancer.correction.isolement.Limites;
import org.apache.commons.io.FileUtils;
import org.apache.commons.io.function.IOFunction;
import org.ini4j.Ini;
import org.junit.jupiter.api.Test;
import org.junit.platform.commons.JUnitException;
import org.opentest4j.AssertionFailedError;

/** Les autres machines virtuelles : celle qui compile, et celle qui exécute un rendu, relancée après chaque arrêt. */
final class Machines {

    private final Confinement confinement;
    /** Limites de chaque demande à un rendu. */
    Limites limites = Limites.ORDINAIRES;
    /** L'archive des classes qu'un rendu voit, avec les siennes. */
    private final Path outillage;

    /** Chemin des classes du compilateur : JUnit, ini4j, le compilateur, la correction. La base n'y est jamais. */
    private final String chemin = Stream.concat(
            Stream.of(Execution.class, Gson.class, FileUtils.class, Ini.class, Test.class, AssertionFailedError.class,
                    JUnitException.class),
            ServiceLoader.load(JavaCompiler.class).stream().map(ServiceLoader.Provider::type)
            .filter(c -> c.getName().startsWith("org.eclipse.")))
            .map(Machines::lieu).distinct().collect(Collectors.joining(File.pathSeparator));

    /** @param dossier dossier de travail, à soi seul */
    Machines(Confinement confinement, Path dossier) throws IOException {
        this.confinement = confinement;
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

    /** L'archive ou le dossier d'une classe. */
    static String lieu(Class<?> classe) {
        try {
            return Path.of(classe.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Une autre machine virtuelle, relancée si elle a été arrêtée. */
    private abstract class Machine implements AutoCloseable {

        Enfant enfant;
        /** Secondes de calcul et de sommeil de toutes les machines du même compte. */
        DoubleAdder depense = new DoubleAdder();
        private int endormi;

        /**
         * Lance la machine virtuelle si besoin, et attend une première réponse : un arrêt ultérieur vient alors de la demande.
         *
         * @return vrai si elle vient d'être lancée
         * @throws Panne si elle ne répond pas
         */
        boolean lancer(Class<?> principale, String chemin, Limites siennes, byte[] premiere) {
            if (enfant != null) {
                return false;
            }
            boolean executee = principale == Execution.class;
            enfant = new Enfant(confinement.java(principale, chemin, !executee, outillage.getParent(), siennes), siennes,
                    confinement.confine);
            enfant.remplacer(endormi, depense);
            try {
                enfant.commencer(Limites.DE_COMPILATION.calcul);
                demander(premiere, Echange.REPONSE_MAX, DataInputStream::readAllBytes);
                return true;
            } catch (Arret e) {
                throw new Panne(1, "une machine virtuelle n'a pas pu commencer : " + e.getMessage());
            }
        }

        /** Envoie une demande, et lit toute la réponse ; une réponse de forme inattendue arrête la machine virtuelle. */
        <T> T demander(byte[] demande, int max, IOFunction<DataInputStream, T> lecture) throws Arret {
            try {
                DataInputStream reponse = enfant.demander(demande, max);
                try {
                    T lue = lecture.apply(reponse);
                    if (reponse.available() == 0) {
                        return lue;
                    }
                } catch (IOException | ClassCastException | IndexOutOfBoundsException | NullPointerException | JsonParseException e) {
                    // réponse trop courte, ou d'une autre forme
                }
                throw enfant.arreter("arrêté : a répondu ce qui n'a pas de sens");
            } catch (Arret e) {
                close();
                throw e;
            }
        }

        @Override
        public void close() {
            if (enfant != null) {
                endormi = enfant.endormi;
                enfant.close();
                enfant = null;
            }
        }
    }

    /** Un assemblage de classes compilé : les octets de chacune, par nom, et les fautes. */
    static final class Assemblage {

        final Map<String, byte[]> classes = new HashMap<>();
        final List<Faute> fautes = new ArrayList<>();
        /** Vrai si une vérification de cet assemblage n'a pas fini. */
        boolean arrete;

        /** @param reponse voir {@link Compilateur#COMPILER} */
        private Assemblage(List<?> reponse) {
            for (Object une : (List<?>) reponse.get(0)) {
                List<?> faute = (List<?>) une;
                fautes.add(new Faute((String) faute.get(0), (Integer) faute.get(1), (String) faute.get(2)));
            }
            List<?> compilees = (List<?>) reponse.get(1);
            for (int k = 0; k < compilees.size(); k += 2) {
                classes.put((String) compilees.get(k), (byte[]) compilees.get(k + 1));
            }
        }

        List<Faute> fautesDe(String classe) {
            return fautes.stream().filter(f -> f.classe().equals(classe)).collect(Collectors.toList());
        }
    }

    /** Machine virtuelle qui lit et compile des sources ; elle n'exécute aucun rendu. */
    final class Compilation extends Machine implements Source.Lecture {

        @Override
        public Lecteur.Fichier[] lire(List<String> textes) throws Arret {
            Map<String, String> tous = new LinkedHashMap<>();
            textes.forEach(t -> tous.put(String.valueOf(tous.size()), t));
            return demander(Compilateur.LIRE, tous, Compilateur::lus);
        }

        @Override
        public boolean compile(Map<String, String> classes) throws Arret {
            return compiler(classes).fautes.isEmpty();
        }

        private <T> T demander(String sorte, Map<String, String> textes, Function<List<?>, T> lecture) throws Arret {
            lancer(Compilateur.class, chemin, Limites.DE_COMPILATION, Echange.message(List.of(Compilateur.COMPILER), o -> null));
            enfant.commencer(Limites.DE_COMPILATION.calcul);
            try {
                return demander(Echange.message(Compilateur.demande(sorte, textes), o -> null), Echange.COMPILATION_MAX,
                        reponse -> lecture.apply((List<?>) Echange.lire(reponse, o -> null)));
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
            Assemblage compile = demander(Compilateur.COMPILER, sources, Assemblage::new);
            if (compile.classes.isEmpty()) {
                close();
                throw new Arret("arrêté : ces sources font échouer le compilateur", false);
            }
            return compile;
        }
    }

    /** Machine virtuelle qui exécute un rendu, avec les seules classes de son assemblage. */
    final class Rendue extends Machine {

        final Assemblage assemblage;

        Rendue(Assemblage assemblage, DoubleAdder depense) {
            this.assemblage = assemblage;
            this.depense = depense;
        }

        /** Demande ceci à un rendu, et rend ce que donne sa réponse. */
        private <T> T demander(int max, Function<List<?>, T> lecture, Object... demande) throws Arret {
            return demander(Echange.message(Arrays.asList(demande), o -> (Echange.Objet) o), max, reponse ->
                    lecture.apply(Dialogue.resultat((List<?>) Echange.lire(reponse, Dialogue.Recu::new), assemblage.fautes)));
        }

        /** Commence une demande qui n'utilise plus les objets de la précédente. */
        void oublier() throws Arret {
            commencer(1);
            if (!demander(Echange.REPONSE_MAX, r -> r.get(0).equals(0), Execution.OUBLI)) {
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
            if (lancer(Execution.class, outillage.toString(), limites, Echange.message(List.of(Execution.CLASSES), o -> null))) {
                List<Object> demande = new ArrayList<>(List.of(Execution.CLASSES));
                assemblage.classes.forEach((nom, octets) -> demande.addAll(List.of(nom, octets)));
                demander(Echange.REPONSE_MAX, r -> r, demande.toArray());
            }
            enfant.commencer(fois * limites.calcul);
        }

        /** Appelle une méthode, par son numéro ; si elle rend un objet, ses champs le suivent. */
        Object appeler(int methode, List<?> arguments) throws Arret {
            return demander(Echange.REPONSE_MAX, reponse -> {
                if (reponse.get(0) instanceof Dialogue.Recu) {
                    ((Dialogue.Recu) reponse.get(0)).champs = (List<?>) reponse.get(1);
                }
                return reponse.get(0);
            }, Execution.APPEL, methode, arguments);
        }

        /** @throws ClassCastException si cette réponse n'est ni une image, ni une liste de textes, selon ce qui est attendu */
        private <T> T lire(Class<T> sorte, Object reponse) {
            if (sorte == List.class) {
                ((List<?>) reponse).forEach(texte -> ((String) texte).length());
            }
            return sorte.cast(Objects.requireNonNull(reponse));
        }

        /**
         * Ce que rend, de cette sorte, une méthode de la sonde, sur cette scène.
         *
         * @param fois voir {@link #commencer} ; @throws Dialogue.Echec si elle échoue
         */
        <T> T sonder(Class<T> sorte, double fois, String methode, String scene, Object... arguments) throws Arret {
            int max = sorte == byte[].class ? Echange.IMAGE_MAX : Echange.REPONSE_MAX;
            commencer(fois);
            try {
                return demander(max, reponse -> lire(sorte, reponse.get(0)), Execution.SONDE, methode,
                        scene.getBytes(StandardCharsets.UTF_8), Stream.of(arguments).map(String::valueOf).collect(Collectors.toList()));
            } catch (StackOverflowError e) {
                throw new Dialogue.Echec(e.getMessage());
            }
        }
    }
}
