package lancer.mesures;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import lancer.commande.Pannes;

/**
 * Le banc d'essai : dessine les scènes de 10 à un million de sphères, vérifie chaque image, montre et note les temps.
 *
 * <pre>
 * java -cp mesures/target/mesures.jar lancer.mesures.Banc [--scenes NOMS] [--secondes N] [--fils N] [--csv FICHIER] [--petit]
 * </pre>
 *
 * Statut de sortie : 0 tout est juste ; 1 une image est fausse, ou n'a pu être dessinée ; 2 la demande était fausse.
 */
public final class Banc {

    /** Mesure la scène d'un fichier. */
    interface Essai {
        Mesure mesurer(Path fichier) throws IOException;
    }

    private Banc() {
    }

    /** @param args voir la description de la classe */
    public static void main(String[] args) {
        System.exit(executer(args, System.out, System.err, MachineSeparee::new));
    }

    /**
     * Ce que fait {@link #main}, sans quitter Java.
     *
     * @param essai de quoi mesurer selon ces réglages
     * @return le statut de sortie
     */
    static int executer(String[] args, PrintStream sortie, PrintStream erreurs, Function<Reglages, Essai> essai) {
        try {
            OptionsBanc options = OptionsBanc.lire(args);
            return mesurer(options, sortie, essai.apply(options.reglages));
        } catch (IllegalArgumentException e) {
            erreurs.println("Banc : " + e.getMessage());
            return 2;
        } catch (IOException | RuntimeException e) {
            erreurs.println("Banc : " + (e instanceof IOException ? e.toString() : Pannes.message(e)));
            return 1;
        }
    }

    private static int mesurer(OptionsBanc options, PrintStream sortie, Essai essai) throws IOException {
        Circonstances circonstances = new Circonstances();
        Tableau tableau = new Tableau(sortie);
        FichierCsv csv = new FichierCsv(options.csv, circonstances, options.reglages);
        tableau.entete(circonstances, options.reglages);
        Map<String, Mesure> precedentes = new HashMap<>();
        Set<String> sautees = new HashSet<>();
        int statut = 0;
        Path dossier = Files.createTempDirectory("banc");
        dossier.toFile().deleteOnExit();
        try {
            for (SceneDuBanc scene : options.scenes) {
                if (sautees.contains(scene.famille)) {
                    tableau.sansTemps(scene.nom, "sautée : plus chère que la précédente");
                    continue;
                }
                Mesure mesure = essai.mesurer(scene.fichier(dossier));
                scene.oublier(dossier);
                switch (mesure.issue) {
                    case MESUREE:
                        tableau.mesure(scene.nom, mesure, precedentes.put(scene.famille, mesure));
                        csv.ajouter(scene.nom, mesure);
                        break;
                    case SAUTEE:
                        tableau.sansTemps(scene.nom, "sautée : " + mesure.raison);
                        sautees.add(scene.famille);
                        break;
                    default:
                        tableau.sansTemps(scene.nom, "PAS DE TEMPS, " + mesure.raison);
                        statut = 1;
                }
            }
        } finally {
            for (SceneDuBanc scene : options.scenes) {
                scene.oublier(dossier);
            }
            Files.deleteIfExists(dossier);
        }
        tableau.pied(options.csv);
        return statut;
    }
}
