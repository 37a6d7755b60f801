package lancer.correction.jugement;

import java.io.File;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import lancer.correction.enfant.Compilateur;
import lancer.correction.enfant.Execution;
import lancer.correction.isolement.Arret;
import lancer.correction.isolement.Confinement;
import lancer.correction.isolement.Enfant;
import lancer.correction.isolement.Limites;
import org.ini4j.Ini;
import org.junit.jupiter.api.Test;
import org.junit.platform.commons.JUnitException;
import org.junit.platform.engine.TestEngine;
import org.junit.platform.launcher.Launcher;
import org.opentest4j.AssertionFailedError;

/** Les machines virtuelles à part : celle qui compile, et celle, relancée à chaque mort, où tourne un rendu. */
final class Machines {

    private final Confinement confinement;
    private final Limites limites;

    Machines(Confinement confinement, Limites limites) {
        this.confinement = confinement;
        this.limites = limites;
    }

    /**
     * Là d'où viennent JUnit, ini4j, le compilateur et nous ; jamais la base, même si elle est dans le chemin des
     * classes.
     */
    private static String chemin() {
        Set<String> lieux = new LinkedHashSet<>();
        for (Class<?> classe : List.of(Execution.class, Launcher.class, TestEngine.class, Test.class,
                JUnitException.class, AssertionFailedError.class, Ini.class)) {
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
                enfant = new Enfant(confinement.java(Compilateur.class, chemin(), dossier, true, larges), "", larges);
            }
            List<Faute> fautes = new ArrayList<>();
            try {
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

    /** Où tourne un rendu, qui n'en voit que son propre dossier. */
    final class Rendue implements AutoCloseable {

        private final Path dossier;
        private Enfant enfant;

        Rendue(Path dossier) {
            this.dossier = dossier;
        }

        /** Temps de processeur ordinairement permis pour une demande, en secondes. */
        double calcul() {
            return limites.calcul;
        }

        /** La réponse à une demande, sans le mot de passe. @param calcul temps de processeur permis, en secondes */
        String demander(double calcul, String... mots) throws Arret {
            if (enfant == null) {
                byte[] hasard = new byte[16];
                new SecureRandom().nextBytes(hasard);
                StringBuilder motDePasse = new StringBuilder();
                for (byte b : hasard) {
                    motDePasse.append(String.format("%02x", b));
                }
                enfant = new Enfant(confinement.java(Execution.class, chemin(), dossier, false, limites), motDePasse
                        + "\t", limites);
                enfant.dire(motDePasse.toString());
            }
            try {
                enfant.dire(String.join("\t", mots));
                return enfant.attendre(calcul);
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
