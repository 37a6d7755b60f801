package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UnsupportedEncodingException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import lancer.SceneFautive;
import lancer.commande.Messages;
import lancer.mesures.juge.DeuxProgrammes;
import lancer.mesures.juge.PovRay;
import lancer.mesures.stabilite.Mesures;
import lancer.systeme.ErreurSysteme;

/**
 * Vitesse et précision : exécute les mesures du {@link Catalogue}, puis dessine les courbes et écrit les tableaux. Lancé par
 * {@code make mesures}, avec au plus une option.
 *
 * <p>Statut de sortie : 0 si tout est mesuré ; 1 si un programme ou la machine a échoué ({@code mesures/resultats} ne change pas) ; 2 si la
 * demande est fausse.
 */
public final class Vitesse {

    private static final List<String> OPTIONS = Arrays.asList("--comptes", "--temps", "--stabilite", "--dessiner", "--verifier");

    /** Dossier des résultats d'une mesure complète, et de ses courbes. */
    private static final Path RESULTATS = Paths.get("mesures/resultats");

    /** Dossier où les mesures se font, avant d'y être copiées. */
    private static final Path TRAVAIL = Paths.get("mesures/target/vitesse");

    private final Set<String> options;
    private final PrintStream sortie;

    private Vitesse(PrintStream sortie, String... args) {
        this.sortie = sortie;
        options = new HashSet<>(Arrays.asList(args));
        if (options.size() < args.length || !OPTIONS.containsAll(options)) {
            throw new IllegalArgumentException("options permises, une fois chacune : " + String.join(" ", OPTIONS));
        }
    }

    /** @param args voir la description de la classe */
    public static void main(String[] args) throws UnsupportedEncodingException {
        System.exit(executer(args, new PrintStream(System.out, true, "UTF-8"), new PrintStream(System.err, true, "UTF-8")));
    }

    /** Exécute {@link #main} sans arrêter Java. */
    static int executer(String[] args, PrintStream sortie, PrintStream erreurs) {
        // les courbes ne demandent pas d'écran : un écran qui ne répond pas ne doit pas les empêcher
        System.setProperty("java.awt.headless", "true");
        try {
            new Vitesse(sortie, args).faire();
            return 0;
        } catch (SceneFautive | IllegalArgumentException e) {
            erreurs.println("Vitesse : " + e.getMessage());
            return 2;
        } catch (IOException e) {
            erreurs.println("Vitesse : " + e.getMessage() + (e instanceof FileSystemException
                    ? " : " + ErreurSysteme.raison(e, ((FileSystemException) e).getFile()) : ""));
            return 1;
        } catch (RuntimeException | OutOfMemoryError e) {
            erreurs.println("Vitesse : " + Messages.message(e));
            return 1;
        }
    }

    private boolean demande(String option) {
        return options.isEmpty() || options.contains(option);
    }

    private void faire() throws IOException {
        if (!Files.isDirectory(Paths.get("scenes"))) {
            throw new IllegalArgumentException("pas de dossier scenes ici ; à lancer à la racine du projet");
        }
        long debut = System.nanoTime();
        Files.createDirectories(TRAVAIL);
        if (options.contains("--verifier")) {
            new Verification(RESULTATS, TRAVAIL, sortie).faire();
            return;
        }
        PovRay povray = povray();
        Mesureur mesureur = new Mesureur(TRAVAIL, povray, sortie, Taille.PUBLIEE, false, r -> Arrays.asList("-jar", r.jar()));
        Resultats mesures = Resultats.lire(RESULTATS).tels(Catalogue.demandees());
        // les fils d'abord : rien n'a encore chargé la machine
        if (demande("--temps")) {
            for (Groupe groupe : Catalogue.temps()) {
                mesureur.chronometrer(groupe, mesures);
            }
        }
        if (demande("--comptes")) {
            for (Groupe groupe : Catalogue.comptes()) {
                mesureur.compter(groupe, mesures);
            }
        }
        if (demande("--comptes") || demande("--stabilite")) {
            new Mesures(false).ecrire(TRAVAIL);
        }
        if (demande("--comptes") && povray != null) {
            DeuxProgrammes.dessiner(povray, TRAVAIL);
        }
        if (!options.contains("--dessiner")) {
            mesures.ecrire(TRAVAIL);
        }
        for (String nom : Arrays.asList(Resultats.CSV, Mesures.CSV, DeuxProgrammes.PNG)) {
            if (Files.exists(TRAVAIL.resolve(nom))) {
                Files.move(TRAVAIL.resolve(nom), RESULTATS.resolve(nom), StandardCopyOption.REPLACE_EXISTING);
            }
        }
        new Rapport(RESULTATS).ecrire(true);
        sortie.println("Fait en " + (System.nanoTime() - debut) / 1_000_000_000 + " s : " + RESULTATS);
    }

    private PovRay povray() {
        try {
            return new PovRay(PovRay.COMMANDE, TRAVAIL);
        } catch (IOException e) {
            sortie.println("Sans POV-Ray : " + e.getMessage());
            return null;
        }
    }
}
