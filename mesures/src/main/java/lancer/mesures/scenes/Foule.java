package lancer.mesures.scenes;

import java.io.BufferedWriter;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;

/**
 * Des boules au hasard qui ne se touchent pas, devant l'œil : {@code make scene-geante} en écrit autant que l'on veut sur la sortie
 * standard. Le même nombre donne le même texte, à l'octet, sur toute machine.
 */
public final class Foule {

    private static final int N_MAX = 100_000_000;

    /** La boîte qui contient toutes les boules, tout entière dans l'image. */
    private static final double LARGEUR = 4.8;
    private static final double HAUTEUR = 3.6;
    private static final double FOND = 6;
    private static final double Z = 6;

    /** Part des cases qui ont une boule : ni grille régulière, ni boîte vide. */
    private static final double REMPLISSAGE = 0.6;

    private static final int MATERIAUX = 36;

    private Foule() {
    }

    /** @param args le nombre de boules */
    public static void main(String[] args) {
        try (Writer sortie = new BufferedWriter(new OutputStreamWriter(new FileOutputStream(FileDescriptor.out), StandardCharsets.UTF_8))) {
            ecrire(new Plume(sortie), nombre(args));
        } catch (IllegalArgumentException | IOException e) {
            System.err.println("Foule : " + e.getMessage());
            System.exit(e instanceof IOException ? 1 : 2);
        }
    }

    /** @throws IllegalArgumentException si la demande ne va pas */
    static int nombre(String... args) {
        int n = args.length == 1 && args[0].matches("[0-9]{1,9}") ? Integer.parseInt(args[0]) : 0;
        if (n < 1 || n > N_MAX) {
            throw new IllegalArgumentException("le nombre de boules est un entier de 1 à " + N_MAX);
        }
        return n;
    }

    static void ecrire(Plume plume, int n) throws IOException {
        plume.commentaires("Une foule : " + n + " boules au hasard, qui ne se touchent pas.", "",
                "À regarder : le temps du dessin, et comment il grandit avec le nombre de boules.", "",
                "Écrite par lancer.mesures.scenes.Foule " + n);
        double cote = StrictMath.cbrt(LARGEUR * HAUTEUR * FOND * REMPLISSAGE / n);
        while (cases(cote) < n) {
            cote *= 0.99;
        }
        semer(plume, n, cote);
        plume.lampe("principale", -40, 60, -50, 1, 0.95, 0.86);
        plume.lampe("appoint", 50, 20, -20, 0.35, 0.4, 0.5);
    }

    /** Une boule au plus par case : deux boules ne peuvent se toucher, et rien n'est gardé en mémoire. */
    private static void semer(Plume plume, int n, double cote) throws IOException {
        String[] materiaux = new String[MATERIAUX];
        Arrays.setAll(materiaux, Foule::materiau);
        Random hasard = new Random(1);
        long nx = (long) (LARGEUR / cote);
        long ny = (long) (HAUTEUR / cote);
        long nz = (long) (FOND / cote);
        long restentCases = cases(cote);
        long restentBoules = n;
        for (long k = 0; k < nz; k++) {
            // chaque couche et chaque rangée décalées : sans quoi l'œil verrait des allées
            double dy = hasard.nextDouble() - 0.5;
            for (long j = 0; j < ny; j++) {
                double dx = hasard.nextDouble() - 0.5;
                for (long i = 0; i < nx; i++) {
                    // chaque choix de n cases est aussi probable (Knuth, algorithme S)
                    if (hasard.nextDouble() * restentCases < restentBoules) {
                        restentBoules--;
                        double rayon = cote * (0.2 + 0.22 * hasard.nextDouble());
                        double jeu = cote - 2 * rayon;
                        plume.sphere("" + (n - restentBoules), (i - nx / 2.0 + dx) * cote + rayon + jeu * hasard.nextDouble(),
                                (j - ny / 2.0 + dy) * cote + rayon + jeu * hasard.nextDouble(),
                                Z + k * cote + rayon + jeu * hasard.nextDouble(), rayon, materiaux[hasard.nextInt(MATERIAUX)]);
                    }
                    restentCases--;
                }
            }
        }
    }

    private static String materiau(int i) {
        double[] kd = Plume.couleur(i / (double) MATERIAUX, 0.6 + 0.1 * (i % 3), 0.65);
        return Plume.materiau(kd, Plume.couleur(0, 0, 0.2 + 0.1 * (i % 3)), 40 + 40 * (i % 3));
    }

    private static long cases(double cote) {
        return (long) (LARGEUR / cote) * (long) (HAUTEUR / cote) * (long) (FOND / cote);
    }
}
