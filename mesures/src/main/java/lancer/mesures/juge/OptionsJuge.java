package lancer.mesures.juge;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import lancer.Constantes;
import lancer.commande.Echec;
import lancer.commande.Options;

/** La ligne de commande du juge. */
final class OptionsJuge {

    private static final String USAGE =
            "usage : Juge [--reflets N] [--taille LxH] [--povray COMMANDE] [--garder DOSSIER] [--csv FICHIER] [SCENE.ini ...]";

    final List<Affaire> affaires;
    final int largeur;
    final int hauteur;

    /** La commande à lancer. */
    final String povray;

    /** Où garder scènes traduites et images, {@code null} pour ne pas les garder. */
    final Path garder;

    /** Où noter les verdicts, {@code null} pour ne pas les noter. */
    final Path csv;

    private OptionsJuge(List<Affaire> affaires, Options dessin, String povray, Path garder, Path csv) {
        this.affaires = affaires;
        this.largeur = dessin.largeur;
        this.hauteur = dessin.hauteur;
        this.povray = povray;
        this.garder = garder;
        this.csv = csv;
    }

    /**
     * @return ce qui est demandé ; sans scène, toutes celles de {@link Affaire#toutes()}
     * @throws IllegalArgumentException si un argument ne va pas
     */
    static OptionsJuge lire(String... args) {
        List<String> fichiers = new ArrayList<>();
        List<String> dessin = new ArrayList<>();
        String povray = "povray";
        Path garder = null;
        Path csv = null;
        for (int k = 0; k < args.length; k++) {
            if (!args[k].startsWith("--")) {
                fichiers.add(args[k]);
                continue;
            }
            String option = args[k];
            if (++k == args.length || args[k].isEmpty()) {
                throw new IllegalArgumentException("option sans sa valeur : " + option + " ; " + USAGE);
            }
            switch (option) {
                case "--reflets":
                case "--taille":
                    dessin.add(option);
                    dessin.add(args[k]);
                    break;
                case "--povray":
                    povray = args[k];
                    break;
                case "--garder":
                    garder = Paths.get(args[k]);
                    break;
                case "--csv":
                    csv = Paths.get(args[k]);
                    break;
                default:
                    throw new IllegalArgumentException("option inconnue : « " + option + " » ; " + USAGE);
            }
        }
        Options lues = duProgramme(dessin);
        if (fichiers.isEmpty() && dessin.contains("--reflets")) {
            throw new IllegalArgumentException("--reflets va avec une scène ; " + USAGE);
        }
        List<Affaire> affaires = new ArrayList<>();
        for (String fichier : fichiers) {
            affaires.add(Affaire.fichier(fichier, lues.reflets));
        }
        return new OptionsJuge(affaires.isEmpty() ? Affaire.toutes() : affaires, lues, povray, garder, csv);
    }

    /** Ces options-là se lisent comme celles du programme. */
    private static Options duProgramme(List<String> arguments) {
        try {
            return Options.lire(arguments.toArray(new String[0]));
        } catch (Echec e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }
}
