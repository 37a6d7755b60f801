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
import lancer.essai.Formule;
import lancer.mesures.stabilite.Methodes;
import lancer.mesures.stabilite.Regime;
import lancer.mesures.stabilite.Stabilite;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.CommandLineOptionException;
import org.openjdk.jmh.runner.options.CommandLineOptions;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.VerboseMode;

/**
 * Mesure par JMH ce que coûte chaque façon de calculer une intersection, et en fait la courbe des méthodes. De chaque machine
 * virtuelle est retenue la plus courte de ses mesures, assez brèves pour que l'une au moins ne soit pas interrompue. Une machine chargée
 * ne fait que ralentir, parfois d'un tiers pendant une minute : le temps est celui de la deuxième machine virtuelle la plus rapide, et
 * son intervalle contient la première et la troisième. Sur dix, dont chacune a une chance sur deux d'être dérangée, trois ne le sont pas
 * 19 fois sur 20. Si un intervalle est trop large, rien n'est écrit. Lancé par {@code make noyaux}.
 */
public final class Noyaux {

    private static final Path RESULTATS = Paths.get("mesures", "resultats");
    private static final Path PAGE = Paths.get("docs", "stabilite.md");
    private static final String LIGNE = "%-16s %-10s %10s   %-10s %s%n";

    /**
     * Part du temps que son intervalle ne doit pas dépasser, de part et d'autre ; sauf en {@code float}, dont les conversions vont du
     * simple au double d'une machine virtuelle à l'autre : son intervalle le dit.
     */
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
            sortie.println("Mesure des méthodes, sans rien dire pendant huit minutes…");
        }
        Map<String, double[]> temps = new TreeMap<>();
        Collection<RunResult> resultats = new Runner(mesure.build()).run();
        sortie.print(String.format(LIGNE, "méthode", "régime", "temps", "erreur", "unité"));
        for (RunResult resultat : resultats) {
            double[] t = temps(resultat);
            String formule = resultat.getParams().getParam("formule");
            String regime = resultat.getParams().getParam("regime");
            temps.put(Methodes.cle(regime, formule), t);
            sortie.print(String.format(LIGNE, formule, regime, nombre(t[0]), "± " + nombre(t[1]), "ns"));
        }
        return temps;
    }

    /** Le temps de la deuxième machine virtuelle la plus rapide, et ce qu'il y a de part et d'autre dans son intervalle. */
    private static double[] temps(RunResult resultat) {
        double[] courtes = resultat.getBenchmarkResults().stream().mapToDouble(machine -> machine.getIterationResults().stream()
                .mapToDouble(mesure -> mesure.getPrimaryResult().getScore()).min().orElse(Double.NaN)).sorted().toArray();
        return courtes.length < 3 ? new double[] {courtes[0], Double.NaN}
                : new double[] {courtes[1], Math.max(courtes[1] - courtes[0], courtes[2] - courtes[1])};
    }

    /**
     * Écrit les mesures, la courbe et la page, si toutes les méthodes ont été mesurées sans être dérangées.
     *
     * @return faux si elles devaient l'être, et n'ont pu
     */
    static boolean noter(Map<String, double[]> temps, Path resultats, PrintStream sortie) throws IOException {
        if (temps.size() < Formule.values().length * Regime.values().length) {
            sortie.println("Toutes les méthodes n'ont pas été mesurées : rien n'est écrit.");
            return true;
        }
        long larges = temps.entrySet().stream().filter(t -> !t.getKey().endsWith(" float"))
                .filter(t -> !(t.getValue()[1] <= TROP_LARGE * t.getValue()[0])).count();
        if (larges > 0 || !Files.isDirectory(resultats)) {
            sortie.println((larges > 0 ? "La machine n'est pas tranquille, ou n'a pas lancé trois machines virtuelles : " + larges
                    + " intervalles sur " + temps.size() + " dépassent 15 % du temps"
                    : "À lancer à la racine du projet, " + resultats + " n'existe pas") + " : rien n'est écrit.");
            return false;
        }
        Methodes.noter(resultats, temps);
        Stabilite.dessiner(resultats);
        PagesMesurees.reecrire(PAGE, Stabilite.pages(resultats));
        sortie.println("Écrits : " + resultats.resolve(Methodes.CSV) + ", methodes.png et les nombres de " + PAGE);
        return true;
    }

    private static String nombre(double valeur) {
        return Double.isNaN(valeur) || Double.isInfinite(valeur) ? "?" : String.format(Locale.ROOT, "%.2f", valeur);
    }
}
