package lancer.mesures.vitesse;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UnsupportedEncodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.SceneFautive;
import lancer.commande.Messages;
import lancer.mesures.Circonstances;
import lancer.mesures.juge.PovRay;
import lancer.mesures.scenes.Scenes;
import lancer.mesures.stabilite.Mesures;
import lancer.texte.ErreurSysteme;

/**
 * Vitesse et précision : exécute les mesures du {@link Catalogue}, puis dessine les courbes et écrit les tableaux. Lancé par
 * {@code make mesures}, avec {@code --rapide} et au plus une des autres options.
 *
 * <p>Statut de sortie : 0 si tout est juste ; 1 si une image est fausse, ou si la machine a échoué ou n'est pas disponible ({@code
 * mesures/resultats} ne change pas) ; 2 si la demande est fausse.
 */
public final class Vitesse {

    static final String CSV = "vitesse.csv";
    static final String BESOINS = "besoins.csv";

    private static final List<String> OPTIONS = Arrays.asList("--rapide", "--comptes", "--temps", "--noyaux", "--stabilite", "--dessiner");

    /** Dossier des résultats d'une mesure complète, et de ses courbes. */
    private static final String RESULTATS = "mesures/resultats";

    private final Set<String> options;
    private final boolean rapide;
    private final Taille taille;
    private final PrintStream sortie;

    /** Dossier où les mesures se font, et dossier où leurs résultats sont copiés. */
    private final Path travail;
    private final Path resultats;

    private Vitesse(PrintStream sortie, String... args) {
        this.sortie = sortie;
        options = new HashSet<>(Arrays.asList(args));
        if (options.size() < args.length || !OPTIONS.containsAll(options)) {
            throw new IllegalArgumentException("options permises, une fois chacune : " + String.join(" ", OPTIONS));
        }
        rapide = options.contains("--rapide");
        taille = rapide ? new Taille(200, 150) : new Taille(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);
        travail = Paths.get("mesures/target", rapide ? "vitesse-rapide" : "vitesse");
        resultats = rapide ? travail : Paths.get(RESULTATS);
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
            erreurs.println("Vitesse : " + e.getMessage() + (e instanceof FileSystemException ? " : " + ErreurSysteme.raison(e) : ""));
            return 1;
        } catch (RuntimeException | OutOfMemoryError e) {
            erreurs.println("Vitesse : " + Messages.message(e));
            return 1;
        }
    }

    private void faire() throws IOException {
        if (!Files.isDirectory(Paths.get("scenes"))) {
            throw new IllegalArgumentException("pas de dossier scenes ici ; à lancer à la racine du projet");
        }
        long debut = System.nanoTime();
        boolean tout = options.stream().allMatch(o -> o.equals("--rapide"));
        boolean comptes = tout || options.contains("--comptes");
        boolean temps = tout || options.contains("--temps");
        List<String> neufs = new ArrayList<>();
        Files.createDirectories(travail);
        PovRay povray = comptes || temps ? povray() : null;
        // les mesures qui ne dépendent pas de la charge de la machine viennent d'abord
        if (comptes) {
            Comptes lesComptes = new Comptes(taille, povray, travail, sortie);
            lesComptes.ecrire(Catalogue.reglages());
            compterLesBesoins();
            neufs.addAll(Arrays.asList(Comptes.CSV, BESOINS));
            if (povray != null) {
                lesComptes.comparer();
                neufs.add(Comptes.PROGRAMMES);
            }
        }
        if (comptes || options.contains("--stabilite")) {
            sortie.println("stabilité");
            new Mesures(rapide).ecrire(travail);
            neufs.add(Mesures.CSV);
        }
        if (temps) {
            chronometrer(povray, CSV, Catalogue.groupes(rapide));
            neufs.add(CSV);
        }
        if (options.contains("--noyaux")) {
            chronometrer(null, Methodes.CSV, Catalogue.intersections());
            neufs.add(Methodes.CSV);
        }
        Files.createDirectories(resultats);
        for (String nom : resultats.equals(travail) ? Collections.<String>emptyList() : neufs) {
            Files.copy(travail.resolve(nom), resultats.resolve(nom), StandardCopyOption.REPLACE_EXISTING);
        }
        new Rapport(resultats, sortie).ecrire(resultats.equals(Paths.get(RESULTATS)));
        sortie.println("Fait en " + (System.nanoTime() - debut) / 1_000_000_000 + " s : " + resultats);
    }

    private PovRay povray() {
        try {
            return new PovRay(PovRay.COMMANDE, travail);
        } catch (IOException e) {
            sortie.println("Sans POV-Ray : " + e.getMessage());
            return null;
        }
    }

    /** @throws IOException si la machine n'est pas disponible ; une mesure rapide ou agitée garde toutes ses manches */
    private void chronometrer(PovRay povray, String csv, List<Catalogue.Groupe> groupes) throws IOException {
        new Mesureur(rapide, povray, travail.resolve(csv), sortie, m -> new String[] {"-jar", m.jar()}).mesurer(taille, groupes);
    }

    private void compterLesBesoins() throws IOException {
        List<Path> scenes = Scenes.livrees();
        sortie.println("besoins de " + scenes.size() + " scènes");
        Circonstances c = new Circonstances();
        List<String> lignes = scenes.parallelStream().map(s -> new Besoin(s, taille).ligne() + "," + c.commit + "," + c.date)
                .collect(Collectors.toList());
        lignes.add(0, String.join(",", Besoin.COLONNES) + ",commit,date");
        Files.write(travail.resolve(BESOINS), lignes, StandardCharsets.UTF_8);
    }
}
