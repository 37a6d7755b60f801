package lancer.mesures.scenes;

import java.io.BufferedWriter;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;

/**
 * Des sphères au hasard, devant l'œil, qui ne se touchent pas. {@code make scene-geante} en écrit N sur la sortie standard. Le même nombre
 * donne le même texte, à l'octet près, sur toute machine.
 */
public final class Foule {

    private static final int N_MAX = 100_000_000;

    /** La boîte qui contient toutes les sphères ; elle est entièrement dans l'image. */
    private static final double LARGEUR = 4.8;
    private static final double HAUTEUR = 3.6;
    private static final double FOND = 6;
    private static final double Z = 6;

    /** Part des cases qui contiennent une sphère : la scène n'est ni une grille régulière, ni presque vide. */
    private static final double REMPLISSAGE = 0.6;

    private static final int MATERIAUX = 36;

    /** Nombre de décimales, avant d'ôter les zéros de la fin : assez pour la plus petite sphère de cent millions. */
    private static final int DECIMALES = 9;

    private Foule() {
    }

    /** @param args le nombre de boules, ou le nom d'une scène de {@link Difficiles} */
    public static void main(String[] args) {
        try (Writer sortie = new BufferedWriter(new OutputStreamWriter(new FileOutputStream(FileDescriptor.out), StandardCharsets.UTF_8))) {
            ecrire(sortie, args);
        } catch (IllegalArgumentException | IOException e) {
            System.err.println("Foule : " + e.getMessage());
            System.exit(e instanceof IOException ? 1 : 2);
        }
    }

    static void ecrire(Appendable sortie, String... args) throws IOException {
        if (args.length == 1 && Scenes.estDifficile(args[0])) {
            Difficiles.ecrire(sortie, args[0]);
        } else {
            ecrire(sortie, combien(args));
        }
    }

    /** @throws IllegalArgumentException si l'argument n'est pas un nombre permis */
    static int combien(String... args) {
        int n = args.length == 1 && args[0].matches("[0-9]{1,9}") ? Integer.parseInt(args[0]) : 0;
        if (n < 1 || n > N_MAX) {
            throw new IllegalArgumentException("le nombre de boules est un entier de 1 à " + N_MAX + " ; ou une scène : "
                    + String.join(", ", Difficiles.FINES) + ", " + String.join(", ", Difficiles.RARES));
        }
        return n;
    }

    /** Écrit la scène sans la garder en mémoire. */
    static void ecrire(Appendable sortie, int n) throws IOException {
        sortie.append("; Une foule : " + n + " boules au hasard, qui ne se touchent pas.\n;\n"
                + "; À regarder : le temps du dessin, et comment il grandit avec le nombre de boules.\n;\n"
                + "; Écrite par lancer.mesures.scenes.Foule " + n + "\n");
        double cote = StrictMath.cbrt(LARGEUR * HAUTEUR * FOND * REMPLISSAGE / n);
        while (cases(cote) < n) {
            cote *= 0.99;
        }
        semer(sortie, n, cote);
        sortie.append("\n[Lampe principale]\nposition=-40 60 -50\ncouleur=1 0.95 0.86\n"
                + "\n[Lampe appoint]\nposition=50 20 -20\ncouleur=0.35 0.4 0.5\n");
    }

    /** Écrit au plus une sphère par case : deux sphères ne peuvent se toucher. */
    private static void semer(Appendable sortie, int n, double cote) throws IOException {
        String[] materiaux = new String[MATERIAUX];
        Arrays.setAll(materiaux, Foule::materiau);
        Random hasard = new Random(1);
        long nx = (long) (LARGEUR / cote);
        long ny = (long) (HAUTEUR / cote);
        long nz = (long) (FOND / cote);
        long restentCases = cases(cote);
        long restentBoules = n;
        for (long k = 0; k < nz; k++) {
            // chaque couche et chaque rangée sont décalées : sinon, l'image aurait des alignements visibles
            double dy = hasard.nextDouble() - 0.5;
            for (long j = 0; j < ny; j++) {
                double dx = hasard.nextDouble() - 0.5;
                for (long i = 0; i < nx; i++) {
                    // tous les choix de n cases ont la même probabilité (Knuth, algorithme S)
                    if (hasard.nextDouble() * restentCases < restentBoules) {
                        restentBoules--;
                        double rayon = cote * (0.2 + 0.22 * hasard.nextDouble());
                        double jeu = cote - 2 * rayon;
                        sortie.append("\n[Sphere " + (n - restentBoules) + "]\ncentre="
                                + triplet((i - nx / 2.0 + dx) * cote + rayon + jeu * hasard.nextDouble(),
                                (j - ny / 2.0 + dy) * cote + rayon + jeu * hasard.nextDouble(),
                                Z + k * cote + rayon + jeu * hasard.nextDouble())
                                + "rayon=" + nombre(rayon) + "\n" + materiaux[hasard.nextInt(MATERIAUX)]);
                    }
                    restentCases--;
                }
            }
        }
    }

    private static String materiau(int i) {
        double[] kd = couleur(i / (double) MATERIAUX, 0.6 + 0.1 * (i % 3), 0.65);
        double ks = 0.2 + 0.1 * (i % 3);
        return "Kd=" + triplet(kd[0], kd[1], kd[2]) + "Ks=" + triplet(ks, ks, ks) + "ns=" + (40 + 40 * (i % 3)) + "\n";
    }

    private static long cases(double cote) {
        return (long) (LARGEUR / cote) * (long) (HAUTEUR / cote) * (long) (FOND / cote);
    }

    /** Une couleur, au millième. La teinte est en tours : 0 rouge, 1/3 vert. La vivacité va de 0, un gris, à 1. */
    static double[] couleur(double teinte, double vivacite, double clarte) {
        double[] rvb = new double[3];
        for (int i = 0; i < 3; i++) {
            double ecart = teinte - i / 3.0;
            // distance à la composante pure sur le cercle des teintes, de 0 à 1/2
            double distance = Math.abs(ecart - Math.rint(ecart));
            double presence = Math.max(0, Math.min(1, 2 - 6 * distance));
            rvb[i] = Math.rint(1000 * clarte * (1 - vivacite * (1 - presence))) / 1000;
        }
        return rvb;
    }

    static String triplet(double x, double y, double z) {
        return nombre(x) + " " + nombre(y) + " " + nombre(z) + "\n";
    }

    /** Ne dépend pas de la langue de la machine. */
    static String nombre(double valeur) {
        return BigDecimal.valueOf(valeur).setScale(DECIMALES, RoundingMode.HALF_UP).stripTrailingZeros().toPlainString();
    }
}
