package lancer.mesures;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import lancer.Constantes;

/** Ce qui est demandé au banc. */
final class OptionsBanc {

    static final String USAGE = "usage : Banc [--scenes NOMS] [--secondes N] [--fils N] [--csv FICHIER] [--petit]";

    private static final double SECONDES = 150;
    private static final double SECONDES_PETIT = 2;
    private static final int SECONDES_MAX = 86400;
    private static final int FILS_MAX = 1024;

    /** Une scène dont une image prend plus longtemps est sautée, à moins que le temps accordé ne soit plus grand encore. */
    private static final long LIMITE_NS = TimeUnit.SECONDS.toNanos(10);

    /** La taille de l'image de {@code --petit}. */
    private static final int LARGEUR_PETIT = 160;
    private static final int HAUTEUR_PETIT = 120;

    final List<SceneDuBanc> scenes;
    final Reglages reglages;
    final Path csv;

    private OptionsBanc(List<SceneDuBanc> scenes, Reglages reglages, Path csv) {
        this.scenes = scenes;
        this.reglages = reglages;
        this.csv = csv;
    }

    /** @throws IllegalArgumentException si un argument ne va pas, avec un message d'une ligne */
    static OptionsBanc lire(String... args) {
        String noms = null;
        double secondes = 0;
        int fils = Runtime.getRuntime().availableProcessors();
        String csv = "mesures/resultats/banc.csv";
        boolean petit = false;
        for (int k = 0; k < args.length; k++) {
            String valeur = k + 1 < args.length ? args[k + 1] : "";
            switch (args[k]) {
                case "--petit":
                    petit = true;
                    continue;
                case "--scenes":
                    noms = valeur;
                    break;
                case "--secondes":
                    secondes = entier(args[k], valeur, SECONDES_MAX);
                    break;
                case "--fils":
                    fils = entier(args[k], valeur, FILS_MAX);
                    break;
                case "--csv":
                    csv = valeur;
                    break;
                default:
                    throw new IllegalArgumentException("option inconnue : « " + args[k] + " » ; " + USAGE);
            }
            if (valeur.isEmpty()) {
                throw new IllegalArgumentException("option sans sa valeur : " + args[k] + " ; " + USAGE);
            }
            k++;
        }
        List<SceneDuBanc> scenes = choisir(SceneDuBanc.toutes(petit), noms);
        double total = secondes > 0 ? secondes : petit ? SECONDES_PETIT : SECONDES;
        long dureeNs = (long) (total / scenes.size() * TimeUnit.SECONDS.toNanos(1));
        Reglages reglages = new Reglages(petit ? LARGEUR_PETIT : Constantes.LARGEUR_IMAGE,
                petit ? HAUTEUR_PETIT : Constantes.HAUTEUR_IMAGE, fils, dureeNs, Math.max(LIMITE_NS, dureeNs));
        return new OptionsBanc(scenes, reglages, Paths.get(csv));
    }

    private static List<SceneDuBanc> choisir(List<SceneDuBanc> toutes, String noms) {
        if (noms == null) {
            return toutes;
        }
        List<SceneDuBanc> choisies = new ArrayList<>();
        String[] demandes = noms.split("[, ]+");
        for (String demande : demandes) {
            if (toutes.stream().noneMatch(s -> s.est(demande))) {
                throw new IllegalArgumentException("scène inconnue : « " + demande + " » ; attendu, séparés par des virgules : "
                        + toutes.stream().map(s -> s.nom).collect(Collectors.joining(" ")) + ", ou flocon, foule");
            }
        }
        for (SceneDuBanc scene : toutes) {
            for (String demande : demandes) {
                if (scene.est(demande) && !choisies.contains(scene)) {
                    choisies.add(scene);
                }
            }
        }
        return choisies;
    }

    private static int entier(String nom, String texte, int max) {
        try {
            int n = Integer.parseInt(texte);
            if (n >= 1 && n <= max) {
                return n;
            }
        } catch (NumberFormatException e) {
            // dit plus bas, comme un nombre hors limites
        }
        throw new IllegalArgumentException("valeur impossible pour " + nom + " : « " + texte + " » ; attendu : un entier de 1 à " + max);
    }
}
