package lancer.mesures.juge;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Stream;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.commande.Pannes;
import lancer.texte.Texte;

/**
 * Le juge : POV-Ray, qui ne doit rien à ce programme, dessine les mêmes scènes, et les deux images sont comparées pixel par pixel.
 *
 * <pre>
 * java -cp mesures/target/mesures.jar lancer.mesures.juge.Juge [--reflets N] [--taille LxH] [--povray COMMANDE] [--garder DOSSIER]
 *      [--csv FICHIER] [SCENE.ini ...]
 * </pre>
 *
 * Statut de sortie : 0 les images sont d'accord, ou chaque écart est expliqué ; 1 un écart ne l'est pas, ou le juge n'a pu dessiner ;
 * 2 la demande était fausse.
 */
public final class Juge {

    /** De quoi trouver un juge, qui écrira dans ce dossier. */
    interface Convocation {
        Peintre convoquer(String commande, Path dossier) throws IOException;
    }

    private Juge() {
    }

    /** @param args voir la description de la classe */
    public static void main(String[] args) {
        System.exit(executer(args, System.out, System.err, PovRay::new));
    }

    /**
     * Ce que fait {@link #main}, sans quitter Java.
     *
     * @return le statut de sortie
     */
    static int executer(String[] args, PrintStream sortie, PrintStream erreurs, Convocation convocation) {
        OptionsJuge options;
        try {
            options = OptionsJuge.lire(args);
        } catch (IllegalArgumentException e) {
            erreurs.println("Juge : " + e.getMessage());
            return 2;
        }
        try {
            Path dossier = options.garder != null ? Files.createDirectories(options.garder) : Files.createTempDirectory("juge");
            try {
                return juger(options, dossier, sortie, erreurs, convocation);
            } finally {
                if (options.garder == null) {
                    effacer(dossier);
                }
            }
        } catch (SceneFautive e) {
            erreurs.println("Juge : " + e.getMessage());
            return 2;
        } catch (IOException | RuntimeException e) {
            erreurs.println("Juge : " + Texte.echappe(e instanceof IOException ? e.getMessage() : Pannes.message(e)));
            return 1;
        }
    }

    private static int juger(OptionsJuge options, Path dossier, PrintStream sortie, PrintStream erreurs, Convocation convocation)
            throws IOException {
        Peintre juge;
        try {
            juge = convocation.convoquer(options.povray, dossier);
        } catch (IOException e) {
            erreurs.println("Juge : " + options.povray + " ne se lance pas ; pour l'avoir : sudo apt-get install povray"
                    + " (Debian, Ubuntu), brew install povray (macOS)");
            return 1;
        }
        Verdicts verdicts = new Verdicts(sortie, juge.nom(), options.largeur, options.hauteur);
        for (Affaire affaire : options.affaires) {
            Scene scene = affaire.lire(dossier);
            try {
                verdicts.ajouter(affaire, new Jugement(juge, affaire.nom, scene, affaire.reflets, options.largeur, options.hauteur));
            } catch (Intraduisible e) {
                verdicts.sauter(affaire, e.getMessage());
            }
        }
        verdicts.conclure();
        if (options.csv != null) {
            verdicts.noter(options.csv);
        }
        return verdicts.toutEstExplique() ? 0 : 1;
    }

    private static void effacer(Path dossier) throws IOException {
        try (Stream<Path> fichiers = Files.walk(dossier)) {
            for (Path fichier : (Iterable<Path>) fichiers.sorted(Comparator.reverseOrder())::iterator) {
                Files.delete(fichier);
            }
        }
    }
}
