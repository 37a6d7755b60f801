package lancer.antialias;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Scene;
import lancer.contrat.Echantillonnage;

/**
 * Pour autant de rayons, quelle méthode se trompe le moins ? Chaque méthode, pour plusieurs n et plusieurs seuils, contre une
 * image complète de 20 × 20 sous-pixels. Arguments : le fichier CSV à écrire, puis des scènes sans section de variante ; sur la
 * sortie standard, le tableau du README.
 */
public final class MesureMethodes {

    private static final int LARGEUR = 120;
    private static final int HAUTEUR = 90;
    private static final int N_REFERENCE = 20;
    private static final int[] COTES = {3, 4, 8, 16};
    private static final double[] SEUILS = {0.01, 0.02, 0.03, 0.04, 0.048, 0.06, 0.08, 0.1, 0.15, 0.2, 0.3, 0.5};
    private static final double[] BUDGETS = {2, 3, 5, 6, 8, 12};
    private static final String[] METHODES = {"coins", "partage"};

    private final List<Releve> releves = new ArrayList<>();
    private final Scene scene;
    private double[] reference;

    private MesureMethodes(String fichier) {
        // sans les variantes du chemin des classes : seul l'échantillonnage doit changer
        Scene lue = new Scene(fichier);
        scene = new Scene(lue.getObjets(), lue.getLampes());
    }

    /** Une image : ce qu'elle a pris, et ce dont elle diffère de la référence, limitée à [0, 1]. */
    private static final class Releve {

        private final String methode;
        private final int n;
        private final double seuil;
        private double rayons;
        private double rms;
        private double max;

        Releve(String methode, int n, double seuil) {
            this.methode = methode;
            this.n = n;
            this.seuil = seuil;
        }

        String csv() {
            return String.format(Locale.ROOT, "%s,%d,%s,%.4f,%.6f,%.4f", methode, n, seuil, rayons, rms, max);
        }
    }

    private static Echantillonnage methode(String nom, int n, double seuil) {
        return nom.equals("coins") ? new Coins(n, seuil) : new Partage(n, seuil);
    }

    private double[] image(Echantillonnage echantillonnage, Releve releve) {
        double[] image = new double[3 * LARGEUR * HAUTEUR];
        Lancer lancer = new Lancer(scene.avec(echantillonnage, scene.getSeuil()), new Camera(LARGEUR, HAUTEUR));
        lancer.TracerPixels((couleur, i, j) -> noter(image, 3 * (j * LARGEUR + i), couleur), Constantes.MAX_REFLETS,
                Runtime.getRuntime().availableProcessors());
        releve.rayons = (double) lancer.getCompteurs().primaires / (LARGEUR * HAUTEUR);
        return image;
    }

    private static void noter(double[] image, int k, Couleur couleur) {
        image[k] = limite(couleur.r);
        image[k + 1] = limite(couleur.v);
        image[k + 2] = limite(couleur.b);
    }

    private static double limite(double x) {
        return Math.max(0, Math.min(1, x));
    }

    private void mesurer() {
        reference = image(new Coins(N_REFERENCE, 0), new Releve("coins", N_REFERENCE, 0));
        for (String nom : METHODES) {
            for (int n : COTES) {
                for (double seuil : SEUILS) {
                    Releve releve = new Releve(nom, n, seuil);
                    comparer(image(methode(nom, n, seuil), releve), releve);
                    releves.add(releve);
                }
            }
        }
    }

    private void comparer(double[] image, Releve releve) {
        double somme = 0;
        for (int k = 0; k < image.length; k++) {
            double ecart = Math.abs(image[k] - reference[k]);
            somme += ecart * ecart;
            releve.max = Math.max(releve.max, ecart);
        }
        releve.rms = Math.sqrt(somme / image.length);
    }

    /** Le relevé de moindre erreur qui ne prend pas plus de rayons que le budget, {@code null} s'il n'y en a pas. */
    private Releve meilleur(String nom, double budget) {
        Releve meilleur = null;
        for (Releve releve : releves) {
            if (releve.methode.equals(nom) && releve.rayons <= budget && (meilleur == null || releve.rms < meilleur.rms)) {
                meilleur = releve;
            }
        }
        return meilleur;
    }

    private String ligne(String nom, String methode) {
        StringBuilder s = new StringBuilder("| " + nom + " | `" + methode + "` |");
        for (double budget : BUDGETS) {
            Releve releve = meilleur(methode, budget);
            s.append(releve == null ? " — |" : String.format(Locale.ROOT, " %.4f (%.2f) |", releve.rms, releve.max));
        }
        return s.toString();
    }

    /** @param args le fichier CSV à écrire, puis les scènes */
    public static void main(String[] args) throws IOException {
        StringBuilder tableau = new StringBuilder("| rayons par pixel, au plus | |");
        for (double budget : BUDGETS) {
            tableau.append(String.format(Locale.ROOT, " %.0f |", budget));
        }
        tableau.append("\n|---|---|").append(new String(new char[BUDGETS.length]).replace("\0", "---|"));
        try (PrintWriter csv = new PrintWriter(Files.newBufferedWriter(Paths.get(args[0]), StandardCharsets.UTF_8))) {
            csv.print("scene,methode,n,seuil,rayons.par.pixel,erreur.rms,erreur.max\n");
            for (int k = 1; k < args.length; k++) {
                String nom = Paths.get(args[k]).getFileName().toString().replace(".ini", "");
                MesureMethodes mesure = new MesureMethodes(args[k]);
                mesure.mesurer();
                for (Releve releve : mesure.releves) {
                    csv.print(nom + "," + releve.csv() + "\n");
                }
                for (String methode : METHODES) {
                    tableau.append("\n").append(mesure.ligne(nom, methode));
                }
            }
        }
        System.out.println(tableau);
    }
}
