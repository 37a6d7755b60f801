package lancer.correction.jugement;

import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lancer.correction.enfant.Compilateur;
import lancer.correction.enfant.Echange;
import lancer.correction.enfant.Execution;
import lancer.correction.isolement.Arret;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Enfant;
import lancer.correction.isolement.Limites;
import org.ini4j.Ini;
import org.junit.jupiter.api.Test;
import org.junit.platform.commons.JUnitException;
import org.junit.platform.engine.TestEngine;
import org.opentest4j.AssertionFailedError;

/** Les machines virtuelles à part : celle qui compile, et celle, relancée à chaque mort, où tourne un rendu. */
final class Machines {

    private final Confinement confinement;
    private final Limites limites;
    private final Path outillage;

    /** @param outillage dossier, à nous, où mettre les seules classes que voit un rendu avec les siennes */
    Machines(Confinement confinement, Limites limites, Path outillage) throws IOException {
        this.confinement = confinement;
        this.limites = limites;
        this.outillage = outillage;
        extraire(Execution.class.getPackageName(), Paths.get(lieu(Execution.class)));
        extraire(Ini.class.getPackageName(), Paths.get(lieu(Ini.class)));
    }

    /** Copie les classes d'un paquet : le rendu ne doit voir ni le corrigé, ni les vérifications, ni JUnit. */
    private void extraire(String paquet, Path lieu) throws IOException {
        try (FileSystem archive = Files.isDirectory(lieu) ? null : FileSystems.newFileSystem(lieu, (ClassLoader) null)) {
            Path racine = archive == null ? lieu : archive.getPath("/");
            try (Stream<Path> flux = Files.walk(racine.resolve(paquet.replace('.', '/')))) {
                for (Path classe : flux.filter(f -> f.toString().endsWith(".class")).collect(Collectors.toList())) {
                    Path copie = outillage.resolve(racine.relativize(classe).toString());
                    Files.createDirectories(copie.getParent());
                    Files.copy(classe, copie, StandardCopyOption.REPLACE_EXISTING);
                }
            }
        }
    }

    /**
     * Là d'où viennent JUnit, ini4j, le compilateur et nous, pour compiler ; jamais la base, même si elle est dans le
     * chemin des classes.
     */
    private static String chemin() {
        Set<String> lieux = new LinkedHashSet<>();
        for (Class<?> classe : List.of(Execution.class, TestEngine.class, Test.class, JUnitException.class,
                AssertionFailedError.class, Ini.class)) {
            lieux.add(lieu(classe));
        }
        for (String nom : List.of("org.junit.jupiter.engine.JupiterTestEngine",
                "org.eclipse.jdt.internal.compiler.tool.EclipseCompiler")) {
            try {
                lieux.add(lieu(Class.forName(nom, false, Machines.class.getClassLoader())));
            } catch (ClassNotFoundException e) {
                throw new IllegalStateException(e);
            }
        }
        return String.join(File.pathSeparator, lieux);
    }

    /** Là d'où nous venons : une archive, ou un dossier de classes. */
    static Path lieu() {
        return Paths.get(lieu(Machines.class));
    }

    private static String lieu(Class<?> classe) {
        try {
            return Paths.get(classe.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Compile, un dossier après l'autre, dans la même machine virtuelle tant qu'elle vit. */
    final class Compilation implements AutoCloseable {

        private final Path dossier;
        private Enfant enfant;

        /** @param dossier le seul endroit où elle écrive */
        Compilation(Path dossier) {
            this.dossier = dossier;
        }

        List<Faute> compiler(Path sources, Path classes) throws Arret {
            if (enfant == null) {
                Limites larges = Limites.deCompilation();
                enfant = new Enfant(confinement.java(Compilateur.class, chemin(), List.of(), dossier, larges), "",
                        larges);
            }
            List<Faute> fautes = new ArrayList<>();
            try {
                enfant.commencer(Limites.deCompilation().calcul);
                enfant.dire(sources + "\t" + classes);
                for (String ligne = enfant.attendre(); !ligne.equals("FIN"); ligne = enfant.attendre()) {
                    String[] mots = ligne.split("\t", 4);
                    if (mots.length == 4 && mots[0].equals("FAUTE")) {
                        fautes.add(new Faute(mots[1], Integer.parseInt(mots[2]), mots[3]));
                    }
                }
            } catch (Arret e) {
                close();
                throw e;
            }
            return fautes;
        }

        @Override
        public void close() {
            if (enfant != null) {
                enfant.close();
                enfant = null;
            }
        }
    }

    /** Où tourne un rendu, qui ne voit que les classes de son assemblage, et des scènes. */
    final class Rendue implements AutoCloseable {

        private final Path classes;
        private final Path scenes;
        private Enfant enfant;

        Rendue(Path classes, Path scenes) {
            this.classes = classes;
            this.scenes = scenes;
        }

        /** Temps de processeur ordinairement permis à une demande, en secondes. */
        double calcul() {
            return limites.calcul;
        }

        /** Ce qui suit est une autre demande, et n'a plus besoin des objets rendus à la précédente. */
        void oublier() throws Arret {
            commencer(limites.calcul);
            if (!demander("N").equals("R\t0")) {
                // des fils courent encore : une machine neuve
                close();
                commencer(limites.calcul);
            }
        }

        /** @param calcul temps de processeur permis à ce qui suit, en secondes */
        void commencer(double calcul) {
            if (enfant == null) {
                enfant = new Enfant(confinement.java(Execution.class, outillage.toString(),
                        List.of(outillage, classes, scenes), null, limites, classes.toString()),
                        Echange.REPONSE, limites);
            }
            enfant.commencer(calcul);
        }

        /** La réponse à une demande. */
        String demander(String demande) throws Arret {
            try {
                enfant.dire(demande);
                return enfant.attendre();
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
}
