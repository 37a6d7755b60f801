package lancer.mesures.noyaux;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collection;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import lancer.atelier.PagesMesurees;
import lancer.mesures.stabilite.Methodes;
import lancer.mesures.stabilite.Stabilite;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.CommandLineOptionException;
import org.openjdk.jmh.runner.options.CommandLineOptions;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.VerboseMode;

/**
 * Mesure par JMH ce que coûte chaque façon de calculer une intersection, et en fait la courbe des méthodes. Chaque temps a son
 * intervalle, où la moyenne se trouve à 99,9 % ; s'il est trop large, la machine n'était pas tranquille, et rien n'est écrit.
 *
 * <pre>
 * java -cp mesures/target/mesures.jar lancer.mesures.noyaux.Noyaux [options de JMH]
 * </pre>
 */
public final class Noyaux {

    private static final Path RESULTATS = Paths.get("mesures", "resultats");
    private static final Path PAGE = Paths.get("docs", "stabilite.md");
    private static final String LIGNE = "%-16s %-10s %10s   %-10s %s%n";

    /** Part du temps que son intervalle ne doit pas dépasser, de part et d'autre. */
    private static final double TROP_LARGE = 0.15;

    private Noyaux() {
    }

    /** @param args les options de JMH ; {@code -h} les montre */
    public static void main(String[] args) {
        try {
            CommandLineOptions options = new CommandLineOptions(args);
            if (options.shouldHelp()) {
                options.showHelp();
            } else {
                System.exit(noter(mesurer(options, System.out), RESULTATS, System.out) ? 0 : 1);
            }
        } catch (CommandLineOptionException e) {
            System.err.println("Noyaux : option de JMH impossible : " + e.getMessage());
            System.exit(2);
        } catch (RunnerException | IOException e) {
            System.err.println("Noyaux : " + e.getMessage());
            System.exit(1);
        }
    }

    /** @return par {@link Methodes#cle}, le temps et ce qu'il y a de part et d'autre dans son intervalle */
    static Map<String, double[]> mesurer(CommandLineOptions options, PrintStream sortie) throws RunnerException {
        OptionsBuilder mesure = new OptionsBuilder();
        mesure.parent(options).shouldFailOnError(true);
        if (!options.verbosity().hasValue()) {
            mesure.verbosity(VerboseMode.SILENT);
            sortie.println("Mesure des méthodes, sans rien dire pendant trois minutes au plus…");
        }
        Map<String, double[]> temps = new TreeMap<>();
        Collection<RunResult> resultats = new Runner(mesure.build()).run();
        sortie.print(String.format(LIGNE, "méthode", "régime", "temps", "erreur", "unité"));
        for (RunResult resultat : resultats) {
            Result<?> r = resultat.getPrimaryResult();
            String formule = resultat.getParams().getParam("formule");
            String regime = resultat.getParams().getParam("regime");
            temps.put(Methodes.cle(regime, formule), new double[] {r.getScore(), r.getScoreError()});
            sortie.print(String.format(LIGNE, formule, regime, nombre(r.getScore()), "± " + nombre(r.getScoreError()), r.getScoreUnit()));
        }
        return temps;
    }

    /** Écrit les mesures, la courbe et la page, si toutes les méthodes ont été mesurées sans être dérangées. */
    static boolean noter(Map<String, double[]> temps, Path resultats, PrintStream sortie) throws IOException {
        long larges = temps.values().stream().filter(t -> !(t[1] <= TROP_LARGE * t[0])).count();
        if (!Files.isDirectory(resultats) || !Methodes.estComplet(temps.keySet()) || larges > 0) {
            sortie.println(larges > 0 ? larges + " intervalles dépassent 15 % du temps : la machine n'est pas tranquille, rien n'est écrit."
                    : Files.isDirectory(resultats) ? "Toutes les méthodes n'ont pas été mesurées : rien n'est écrit."
                    : "À lancer à la racine du projet : rien n'est écrit, " + resultats + " n'existe pas.");
            return false;
        }
        Methodes.noter(resultats, temps);
        Stabilite.dessiner(resultats);
        PagesMesurees.reecrire(PAGE, Stabilite.pages(resultats));
        sortie.println("Écrits : " + resultats.resolve(Methodes.CSV) + ", methodes.png et les nombres de " + PAGE);
        return true;
    }

    private static String nombre(double valeur) {
        return Double.isNaN(valeur) ? "?" : String.format(Locale.ROOT, "%.2f", valeur);
    }
}
