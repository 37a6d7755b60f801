package lancer.correction.jugement;

import com.google.gson.Gson;
import com.google.gson.JsonParseException;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import javax.tools.JavaCompiler;
import lancer.correction.Panne;
import lancer.correction.depot.Compilateur;
import lancer.correction.depot.Contenu;
import lancer.correction.depot.Depot;
import lancer.correction.depot.Faute;
import lancer.correction.depot.Json;
import lancer.correction.depot.Lecteur;
import lancer.correction.enfant.Echange;
import lancer.correction.enfant.Execution;
import lancer.correction.isolement.Arret;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Enfant;
import lancer.correction.isolement.Limites;
import org.apache.commons.compress.archivers.zip.ZipFile;
import org.apache.commons.io.FileUtils;
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
            Stream.of(Execution.class, Gson.class, FileUtils.class, Ini.class, Test.class, AssertionFailedError.class, JUnitException.class),
            ServiceLoader.load(JavaCompiler.class).stream().map(ServiceLoader.Provider::type)
            .filter(c -> c.getName().startsWith("org.eclipse."))));

    /** @param dossier dossier de travail, à soi seul */
    Machines(Confinement confinement, Limites limites, Path dossier) throws IOException {
        this.confinement = confinement;
        this.limites = limites;
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
    private interface Reponse<T> {
        T lire(DataInputStream reponse) throws IOException;
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
        boolean lancer(Class<?> principale, String chemin, Limites siennes, byte[] premiere, Path... aLire) {
            if (enfant != null) {
                return false;
            }
            boolean executee = principale == Execution.class;
            enfant = new Enfant(confinement.java(principale, chemin, !executee, outillage.getParent(), siennes, aLire), siennes,
                    confinement.confine);
            try {
                enfant.commencer(Limites.DE_COMPILATION.calcul);
                demander(premiere, Echange.REPONSE_MAX, DataInputStream::readAllBytes);
                return true;
            } catch (Arret e) {
                throw new Panne(1, "une machine virtuelle n'a pas pu commencer : " + e.getMessage());
            }
        }

        /** Envoie une demande, et lit toute la réponse ; une réponse de forme inattendue arrête la machine virtuelle. */
        <T> T demander(byte[] demande, int max, Reponse<T> lecture) throws Arret {
            try {
                DataInputStream reponse = enfant.demander(demande, max);
                try {
                    T lue = lecture.lire(reponse);
                    if (reponse.available() == 0) {
                        return lue;
                    }
                } catch (IOException | ClassCastException | NullPointerException | JsonParseException e) {
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
                enfant.close();
                enfant = null;
            }
        }
    }

    /** Machine virtuelle qui lit les dossiers et les archives d'une classe ; elle n'exécute aucun rendu. */
    final class Lecture extends Machine implements Depot.Acces {

        private final Path rendus;
        private final boolean seul;

        /** @param seul vrai si tout ce lieu est un seul rendu */
        Lecture(Path rendus, boolean seul) {
            this.rendus = rendus;
            this.seul = seul;
        }

        @Override
        public Contenu.Reponse demander(Map<String, String> noms) throws Arret {
            lancer(Contenu.class, Machines.chemin(Stream.of(Contenu.class, Gson.class, ZipFile.class, IOSupplier.class, ArrayFill.class)),
                    Limites.DE_COMPILATION, Json.ecrire(new Contenu.Demande("", false, null)), rendus);
            enfant.commencer(Limites.DE_COMPILATION.calcul);
            return demander(Json.ecrire(new Contenu.Demande(confinement.lu(rendus), seul, noms)), Echange.GROSSE_REPONSE_MAX,
                    reponse -> Json.lire(Contenu.Reponse.class, reponse));
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

        /** Lecture de ces textes par le JDK : voir {@link Lecteur#lire}. */
        Lecteur.Fichier[] lire(List<String> textes) throws Arret {
            return textes.isEmpty() ? new Lecteur.Fichier[0] : demander(new Compilateur.Demande(textes, Map.of())).lus;
        }

        private Compilateur.Reponse demander(Compilateur.Demande demande) throws Arret {
            lancer(Compilateur.class, chemin, Limites.DE_COMPILATION, Json.ecrire(new Compilateur.Demande(List.of(), Map.of())));
            enfant.commencer(Limites.DE_COMPILATION.calcul);
            try {
                return demander(Json.ecrire(demande), Echange.GROSSE_REPONSE_MAX, r -> Json.lire(Compilateur.Reponse.class, r));
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
            Compilateur.Reponse reponse = demander(new Compilateur.Demande(List.of(), sources));
            if (reponse.classes.isEmpty()) {
                close();
                throw new Arret("arrêté : ces sources font échouer le compilateur", false);
            }
            return new Assemblage(reponse.classes, reponse.fautes);
        }
    }

    /** Une demande à un rendu, qui commence par sa sorte. */
    private static final class Demande {

        final ByteArrayOutputStream octets = new ByteArrayOutputStream();
        final DataOutputStream message = new DataOutputStream(octets);

        Demande(char sorte) throws IOException {
            message.writeByte(sorte);
        }
    }

    /** Machine virtuelle qui exécute un rendu, avec les seules classes de son assemblage. */
    final class Rendue extends Machine {

        final Map<String, byte[]> classes;

        Rendue(Map<String, byte[]> classes) {
            this.classes = classes;
        }

        private byte[] classes(Map<String, byte[]> lesquelles) throws IOException {
            Demande demande = new Demande(Execution.CLASSES);
            demande.message.writeInt(lesquelles.size());
            for (Map.Entry<String, byte[]> une : lesquelles.entrySet()) {
                Echange.ecrireTexte(demande.message, une.getKey());
                Echange.ecrireOctets(demande.message, une.getValue());
            }
            return demande.octets.toByteArray();
        }

        /** Commence une demande qui n'utilise plus les objets de la précédente. */
        void oublier() throws Arret {
            commencer(1);
            if (ecrire(() -> demander(new Demande(Execution.OUBLI).octets.toByteArray(), Echange.REPONSE_MAX, reponse -> {
                Dialogue.attendreUnResultat(reponse);
                return reponse.readInt();
            })) != 0) {
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
            if (ecrire(() -> lancer(Execution.class, outillage.toString(), limites, classes(Map.of())))) {
                ecrire(() -> demander(classes(classes), Echange.REPONSE_MAX, DataInputStream::readAllBytes));
            }
            enfant.commencer(fois * limites.calcul);
        }

        /** Appelle une méthode, par son numéro ; si elle rend un objet, ses champs le suivent. */
        Object appeler(int methode, List<?> arguments) throws Arret {
            return ecrire(() -> {
                Demande demande = new Demande(Execution.APPEL);
                demande.message.writeInt(methode);
                Echange.ecrire(demande.message, arguments, o -> (Echange.Objet) o);
                return demander(demande.octets.toByteArray(), Echange.REPONSE_MAX, reponse -> {
                    Dialogue.attendreUnResultat(reponse);
                    Object rendu = Echange.lire(reponse, Dialogue.Recu::new);
                    List<?> champs = (List<?>) Echange.lire(reponse, Dialogue.Recu::new);
                    if (rendu instanceof Dialogue.Recu) {
                        ((Dialogue.Recu) rendu).champs = champs;
                    }
                    return rendu;
                });
            });
        }

        /** L'image que dessine cette méthode de la sonde, sur cette scène. */
        byte[] dessiner(String methode, String scene, Object... arguments) throws Arret {
            return ecrire(() -> demander(sonde(Execution.DESSIN, methode, scene, arguments), Echange.GROSSE_REPONSE_MAX, reponse -> {
                Dialogue.attendreUnResultat(reponse);
                return Echange.lireOctets(reponse);
            }));
        }

        /** Ce que dit cette méthode de la sonde, sur cette scène : des noms, chacun suivi de sa valeur. */
        List<?> decrire(String methode, String scene, Object... arguments) throws Arret {
            return ecrire(() -> demander(sonde(Execution.TEXTES, methode, scene, arguments), Echange.REPONSE_MAX, reponse -> {
                Dialogue.attendreUnResultat(reponse);
                return (List<?>) Echange.lire(reponse, Dialogue.Recu::new);
            }));
        }

        private byte[] sonde(char sorte, String methode, String scene, Object... arguments) throws IOException {
            Demande demande = new Demande(sorte);
            Echange.ecrireTexte(demande.message, methode);
            Echange.ecrireOctets(demande.message, scene.getBytes(StandardCharsets.UTF_8));
            Echange.ecrire(demande.message, Stream.of(arguments).map(String::valueOf).collect(Collectors.toList()), o -> null);
            return demande.octets.toByteArray();
        }
    }

    /** Ce qui écrit une demande en mémoire, où rien ne manque. */
    private interface Ecriture<T> {
        T faire() throws IOException, Arret;
    }

    private static <T> T ecrire(Ecriture<T> ecriture) throws Arret {
        try {
            return ecriture.faire();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
