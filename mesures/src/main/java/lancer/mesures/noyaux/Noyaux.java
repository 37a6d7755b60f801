package lancer.mesures.noyaux;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.util.Collection;
import java.util.Locale;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.CommandLineOptionException;
import org.openjdk.jmh.runner.options.CommandLineOptions;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.VerboseMode;

/**
 * Mesure les noyaux du programme par JMH, et montre chaque temps avec son erreur : l'intervalle où la moyenne se trouve, à 99,9 %.
 *
 * <pre>
 * java -cp mesures/target/mesures.jar lancer.mesures.noyaux.Noyaux [options de JMH] [expression qui choisit les noyaux]
 * </pre>
 */
public final class Noyaux {

    private static final String LIGNE = "%-32s %-22s %12s   %-12s %s%n";

    private Noyaux() {
    }

    /** @param args les options de JMH ; {@code -h} les montre */
    public static void main(String[] args) {
        try {
            CommandLineOptions options = new CommandLineOptions(args);
            if (options.shouldHelp()) {
                options.showHelp();
            } else {
                mesurer(options, System.out);
            }
        } catch (CommandLineOptionException e) {
            System.err.println("Noyaux : option de JMH impossible : " + e.getMessage());
            System.exit(2);
        } catch (RunnerException e) {
            System.err.println("Noyaux : " + e.getMessage());
            System.exit(1);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static void mesurer(CommandLineOptions options, PrintStream sortie) throws RunnerException {
        OptionsBuilder mesure = new OptionsBuilder();
        mesure.parent(options).shouldFailOnError(true);
        if (!options.verbosity().hasValue()) {
            mesure.verbosity(VerboseMode.SILENT);
            sortie.println("Mesure des noyaux, sans rien dire pendant une minute environ…");
        }
        montrer(new Runner(mesure.build()).run(), sortie);
    }

    private static void montrer(Collection<RunResult> resultats, PrintStream sortie) {
        sortie.print(String.format(LIGNE, "noyau", "cas", "temps", "erreur", "unité"));
        for (RunResult resultat : resultats) {
            Result<?> temps = resultat.getPrimaryResult();
            String nom = resultat.getParams().getBenchmark().replaceAll(".*\\.(\\w+\\.\\w+)$", "$1");
            StringBuilder cas = new StringBuilder();
            for (String cle : resultat.getParams().getParamsKeys()) {
                cas.append(cas.length() == 0 ? "" : ", ").append(cle).append('=').append(resultat.getParams().getParam(cle));
            }
            sortie.print(String.format(LIGNE, nom, cas, nombre(temps.getScore()), "± " + nombre(temps.getScoreError()),
                    temps.getScoreUnit()));
        }
    }

    private static String nombre(double valeur) {
        return Double.isNaN(valeur) ? "?" : String.format(Locale.ROOT, "%.2f", valeur);
    }
}
