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
import java.util.List;
import java.util.stream.Collectors;
import lancer.Constantes;
import lancer.SceneFautive;
import lancer.atelier.Arguments;
import lancer.atelier.Scenes;
import lancer.commande.Pannes;
import lancer.mesures.juge.PovRay;
import lancer.mesures.stabilite.Stabilite;
import lancer.texte.Texte;

/**
 * La vitesse face à la précision : mesure ce que dit le {@link Catalogue}, puis dessine les courbes et écrit les tableaux.
 *
 * <pre>
 * java -cp mesures/target/mesures.jar lancer.mesures.vitesse.Vitesse [--rapide] [--agitee]
 *      [--temps | --spheres | --noyaux | --comptes | --stabilite | --dessiner] [--dossier DOSSIER]
 * </pre>
 *
 * Statut de sortie : 0 tout est juste ; 1 une image est fausse, ou la machine n'a pas pu, ou elle est trop troublée : rien n'est alors
 * changé à {@code mesures/resultats} ; 2 la demande était fausse.
 */
public final class Vitesse {

    static final String CSV = "vitesse.csv";
    static final String BESOINS = "besoins.csv";

    private static final String USAGE = "[--rapide] [--agitee] [--temps | --spheres | --noyaux | --comptes | --stabilite | --dessiner]"
            + " [--dossier DOSSIER]";

    /** Où finit une mesure complète, avec ses courbes. */
    private static final String RESULTATS = "mesures/resultats";

    private static final Path SCENES = Paths.get("scenes");

    private static final Taille TAILLE = new Taille(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);

    private final Arguments arguments;
    private final boolean rapide;
    private final PrintStream sortie;

    /** Où mesurer, et où porter le tout à la fin. */
    private final Path atelier;
    private final Path resultats;

    private Vitesse(PrintStream sortie, String... args) {
        arguments = new Arguments(USAGE, false, args);
        this.sortie = sortie;
        rapide = arguments.a("--rapide");
        boolean aPart = rapide || arguments.a("--agitee") || arguments.a("--spheres");
        atelier = Paths.get("mesures/target", rapide ? "vitesse-rapide" : arguments.a("--spheres") ? "spheres" : "vitesse");
        resultats = arguments.a("--dossier") ? Paths.get(arguments.valeur("--dossier", "")) : aPart ? atelier : Paths.get(RESULTATS);
    }

    /** @param args voir la description de la classe */
    public static void main(String[] args) throws UnsupportedEncodingException {
        System.exit(executer(args, new PrintStream(System.out, true, "UTF-8"), new PrintStream(System.err, true, "UTF-8")));
    }

    /** Ce que fait {@link #main}, sans quitter Java. */
    static int executer(String[] args, PrintStream sortie, PrintStream erreurs) {
        // les courbes ne demandent pas d'écran, et un écran qui ne répond pas ne doit pas les empêcher
        System.setProperty("java.awt.headless", "true");
        try {
            new Vitesse(sortie, args).faire();
            return 0;
        } catch (SceneFautive | IllegalArgumentException e) {
            erreurs.println("Vitesse : " + e.getMessage());
            return 2;
        } catch (IOException e) {
            erreurs.println("Vitesse : " + e.getMessage() + (e instanceof FileSystemException ? " : " + Texte.panne(e) : ""));
            return 1;
        } catch (RuntimeException | OutOfMemoryError e) {
            erreurs.println("Vitesse : " + Pannes.message(e));
            return 1;
        }
    }

    private void faire() throws IOException {
        if (!Files.isDirectory(SCENES)) {
            throw new IllegalArgumentException("pas de dossier " + SCENES + " ici ; à lancer à la racine du projet");
        }
        long debut = System.nanoTime();
        boolean spheres = arguments.a("--spheres");
        boolean comptes = arguments.a("--comptes");
        boolean temps = arguments.a("--temps");
        boolean tout = !spheres && !comptes && !temps && !arguments.a("--noyaux") && !arguments.a("--stabilite")
                && !arguments.a("--dessiner");
        List<String> neufs = new ArrayList<>();
        Files.createDirectories(atelier);
        PovRay povray = tout || spheres || comptes || temps ? povray() : null;
        // ce qui ne demande pas une machine tranquille d'abord
        if (tout || comptes) {
            Comptes lesComptes = new Comptes(TAILLE, povray, atelier, sortie);
            List<Catalogue.Groupe> reglages = new Catalogue(rapide).reglages();
            lesComptes.ecrire(reglages);
            lesComptes.comparer();
            compterLesBesoins();
            neufs.addAll(Arrays.asList(Comptes.CSV, BESOINS));
            reglages.forEach(g -> neufs.add(g.scene + Comptes.DECOUPES));
            neufs.addAll(povray == null ? Collections.emptyList() : Collections.singletonList(Comptes.PROGRAMMES));
        }
        if (tout || comptes || arguments.a("--stabilite")) {
            sortie.println("stabilité");
            Stabilite.mesurer(atelier, rapide);
            neufs.add(Stabilite.CSV);
        }
        if (tout || temps || spheres) {
            chronometrer(povray, new Catalogue(rapide).groupes().stream().filter(g -> !spheres || g.famille.equals(Catalogue.SPHERES))
                    .collect(Collectors.toList()), CSV);
            neufs.add(CSV);
        }
        if (arguments.a("--noyaux")) {
            chronometrer(null, Catalogue.intersections(), Methodes.CSV);
            neufs.add(Methodes.CSV);
        }
        Files.createDirectories(resultats);
        for (String nom : resultats.equals(atelier) ? new ArrayList<String>() : neufs) {
            Files.copy(atelier.resolve(nom), resultats.resolve(nom), StandardCopyOption.REPLACE_EXISTING);
        }
        if (!spheres) {
            new Rapport(resultats, sortie).ecrire(resultats.equals(Paths.get(RESULTATS)));
        }
        sortie.println("Fait en " + (System.nanoTime() - debut) / 1_000_000_000 + " s : " + resultats);
    }

    private PovRay povray() {
        try {
            return new PovRay(PovRay.COMMANDE, atelier);
        } catch (IOException e) {
            sortie.println("Sans POV-Ray : " + e.getMessage());
            return null;
        }
    }

    /** @throws IOException si la machine est trop troublée ; la mesure rapide s'en passe, et le dit */
    private void chronometrer(PovRay povray, List<Catalogue.Groupe> groupes, String csv) throws IOException {
        try {
            new Mesureur(rapide, arguments.a("--agitee"), TAILLE, povray, atelier.resolve(csv), sortie).mesurer(groupes);
        } catch (Manches.Troublee e) {
            if (!rapide) {
                throw e;
            }
            sortie.println("Sans tous les temps : " + e.getMessage());
        }
    }

    private void compterLesBesoins() throws IOException {
        Taille taille = rapide ? new Taille(200, 150) : TAILLE;
        List<String> lignes = new ArrayList<>();
        lignes.add(String.join(",", Besoin.COLONNES));
        for (Path scene : Scenes.livrees()) {
            lignes.add(new Besoin(scene, taille).ligne());
            sortie.println("besoins de " + scene.getFileName());
        }
        Files.write(atelier.resolve(BESOINS), lignes, StandardCharsets.UTF_8);
    }
}
