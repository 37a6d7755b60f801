package lancer.mesures.juge;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.commande.Messages;
import lancer.commande.Option;
import lancer.commande.Options;
import lancer.commande.Reglages;
import lancer.mesures.Circonstances;
import lancer.mesures.FichierCsv;
import lancer.mesures.ImageLineaire;
import lancer.mesures.scenes.Scenes;
import lancer.systeme.Echec;
import lancer.systeme.ErreurSysteme;
import lancer.texte.Texte;

/**
 * Compare ce programme à un programme indépendant, POV-Ray : les deux dessinent les mêmes scènes, et les images sont comparées pixel par
 * pixel. Les fichiers lus et dessinés par POV-Ray restent dans {@code target/juge}. Lancé par {@code make juge}. Sans argument, il juge
 * les scènes livrées et note leur accord.
 *
 * <p>Statut de sortie : 0 si les images sont d'accord ; 1 en cas de désaccord, ou si POV-Ray n'a pu dessiner ; 2 si la demande est fausse.
 */
public final class Juge {

    private static final Path CSV = Paths.get("mesures", "resultats", "juge.csv");
    private static final Path DOSSIER = Paths.get("target", "juge");

    private static final String LIGNE = "%-12s %8s %8s %8s %8s %8s %9s %9s  %s%n";

    private final Reglages dessin;
    private final PrintStream sortie;
    private final Circonstances circonstances = new Circonstances();
    private final List<String> csv = new ArrayList<>();
    private boolean accord = true;

    private Juge(PrintStream sortie, String... args) {
        this.sortie = sortie;
        for (String option : args) {
            if (option.startsWith("-") && !option.matches("--(reflets|taille)(=.*)?")) {
                throw new IllegalArgumentException("usage : [--reflets N] [--taille LxH] [SCENE.ini]");
            }
        }
        dessin = Options.lire(args);
    }

    /** @param args le nombre de reflets, la taille et la scène, comme pour le programme ; rien pour les scènes livrées */
    public static void main(String[] args) {
        System.exit(executer(PovRay.COMMANDE, args.length == 0 ? CSV : null, System.out, System.err, args));
    }

    /**
     * Exécute {@link #main} sans arrêter Java.
     *
     * @param povray la commande de POV-Ray
     * @param fichier où noter l'accord, ou {@code null}
     * @return le statut de sortie
     */
    static int executer(String povray, Path fichier, PrintStream sortie, PrintStream erreurs, String... args) {
        try {
            Juge juge = new Juge(sortie, args);
            juge.juger(new PovRay(povray, Files.createDirectories(DOSSIER)));
            if (fichier != null) {
                Files.write(fichier, juge.csv);
            }
            return juge.accord ? 0 : 1;
        } catch (IllegalArgumentException | Echec | SceneFautive e) {
            erreurs.println("Juge : " + e.getMessage());
            return 2;
        } catch (IOException e) {
            String raison = e instanceof FileSystemException ? " : " + ErreurSysteme.raison(e, ((FileSystemException) e).getFile()) : "";
            erreurs.println("Juge : " + Texte.echappe(e.getMessage() + raison));
            return 1;
        } catch (RuntimeException e) {
            erreurs.println("Juge : " + Texte.echappe(Messages.message(e)));
            return 1;
        }
    }

    private void juger(PovRay juge) throws IOException {
        sortie.println("Le juge est " + juge.nom() + " ; " + dessin.get(Option.TAILLE).x + " × " + dessin.get(Option.TAILLE).y
                + " ; écarts en niveaux");
        sortie.printf(LIGNE, "scène", "sphères", "reflets", "dessins", "> 1 pas", "> 1/257", "pire", "moyen", "verdict");
        csv.add("scene,largeur,hauteur,spheres,reflets,dessins,au_dela_pas_8,au_dela_pas_16,pire_pas_8,moyen_pas_8,accord,commit,date");
        if (dessin.scene != null) {
            juger(Paths.get(dessin.scene), dessin.get(Option.REFLETS), juge);
            return;
        }
        for (Path livree : Scenes.livrees()) {
            juger(livree, dessin.get(Option.REFLETS), juge);
        }
        // miroirs avec le nombre de reflets que son commentaire conseille, puis une foule dont quelques pixels sont sur un bord
        juger(Scenes.fichier("miroirs", DOSSIER), 40, juge);
        juger(Scenes.fichier("foule-10000", DOSSIER), dessin.get(Option.REFLETS), juge);
    }

    private void juger(Path fichier, int reflets, PovRay juge) throws IOException {
        String nom = fichier.getFileName().toString().replaceFirst("\\.ini$", "");
        Scene scene = Scenes.lire(fichier);
        try {
            SceneJugee jugee = new SceneJugee(juge, nom, scene, reflets, dessin.get(Option.TAILLE).x, dessin.get(Option.TAILLE).y);
            ImageLineaire nous = ImageLineaire.de(jugee.lancer, reflets, Runtime.getRuntime().availableProcessors());
            Accord a = new Accord(nous, jugee.image());
            accord &= a.estLa();
            String verdict = a.estLa() ? "d'accord" : "DÉSACCORD, le pire au pixel (" + a.pirePixel % dessin.get(Option.TAILLE).x + ", "
                    + a.pirePixel / dessin.get(Option.TAILLE).x + ") : lancer " + nous.getCouleur(a.pirePixel);
            int spheres = scene.getObjets().size();
            sortie.printf(LIGNE, nom, spheres, reflets, jugee.dessins, a.auDela8, a.auDela16, ecart(a.pire),
                    ecart(a.moyen), verdict);
            csv.add(FichierCsv.ligne(nom, dessin.get(Option.TAILLE).x, dessin.get(Option.TAILLE).y, spheres, reflets, jugee.dessins,
                    a.auDela8,
                    a.auDela16, ecart(a.pire), ecart(a.moyen), a.estLa() ? "oui" : "non", circonstances.commit, circonstances.date));
        } catch (Echec e) {
            // POV-Ray ne sait pas faire le même calcul
            sortie.println(String.format("%-12s %8s", nom, "") + " non jugée : " + e.getMessage());
        }
    }

    private static String ecart(double pas) {
        return String.format(Locale.ROOT, "%.4f", pas);
    }

    /** Comparaison de deux images d'une scène, limitées à [0, 1], pixel par pixel ; les écarts sont en niveaux de 1/255. */
    static final class Accord {

        private static final double PAS_8 = 1 / 255.0;
        private static final double PAS_16 = 1 / 65535.0;

        /** Un pixel sur ce nombre peut s'écarter de plus d'un pas de 16 bits : sur un bord, ou après cinq reflets entre petites sphères. */
        private static final int UN_SUR = 1000;

        /** Nombre de pixels dont une composante s'écarte de plus d'un pas de 8 bits, puis de 16 bits. */
        final int auDela8;
        final int auDela16;

        /** Le plus grand écart d'une composante, en pas de 8 bits, et le rang de son pixel. */
        final double pire;
        final int pirePixel;

        /** L'écart quadratique moyen des composantes, en pas de 8 bits. */
        final double moyen;

        private final int pixels;

        Accord(ImageLineaire nous, ImageLineaire lui) {
            double[] a = nous.getComposantes();
            double[] b = lui.getComposantes();
            pixels = a.length / 3;
            double[] ecarts = IntStream.range(0, a.length).mapToDouble(c -> Math.abs(limite(a[c]) - limite(b[c]))).toArray();
            double[] pires = IntStream.range(0, a.length).filter(c -> c % 3 == 0)
                    .mapToDouble(c -> Math.max(ecarts[c], Math.max(ecarts[c + 1], ecarts[c + 2]))).toArray();
            auDela8 = (int) Arrays.stream(pires).filter(e -> e > PAS_8).count();
            auDela16 = (int) Arrays.stream(pires).filter(e -> e > PAS_16).count();
            pirePixel = IntStream.range(0, pixels).reduce(0, (p, q) -> pires[q] > pires[p] ? q : p);
            pire = pires[pirePixel] / PAS_8;
            moyen = Math.sqrt(Arrays.stream(ecarts).map(e -> e * e).average().orElse(0)) / PAS_8;
        }

        /** Dit si aucun pixel ne s'écarte d'un pas de 8 bits, et si au plus un sur mille s'écarte d'un pas de 16 bits. */
        boolean estLa() {
            return auDela8 == 0 && (long) auDela16 * UN_SUR <= pixels;
        }

        private static double limite(double composante) {
            return Math.max(0, Math.min(1, composante));
        }
    }
}
