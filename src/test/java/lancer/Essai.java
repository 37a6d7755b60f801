package lancer;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.io.UnsupportedEncodingException;
import java.net.URISyntaxException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** De quoi essayer le programme entier, par sa ligne de commande : ce qu'il a rendu, et les images qu'il a écrites. */
public final class Essai {

    /** Statut de sortie. */
    public final int code;

    /** Ce qui a été écrit sur la sortie standard et sur la sortie d'erreur. */
    public final String sortie;
    public final String erreur;

    private Essai(int code, String sortie, String erreur) {
        this.code = code;
        this.sortie = sortie;
        this.erreur = erreur;
    }

    /** Le programme, dans cette machine virtuelle. */
    public static Essai executer(String... args) {
        ByteArrayOutputStream sortie = new ByteArrayOutputStream();
        ByteArrayOutputStream erreur = new ByteArrayOutputStream();
        try {
            int code = Main.executer(args, new PrintStream(sortie, true, "UTF-8"), new PrintStream(erreur, true, "UTF-8"));
            return new Essai(code, sortie.toString("UTF-8"), erreur.toString("UTF-8"));
        } catch (UnsupportedEncodingException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Le programme dans une machine virtuelle à lui, avec les seules classes de la base, d'ini4j et de ces dossiers ou archives.
     *
     * @param classes ce qui s'ajoute au chemin des classes
     */
    public static Essai executerAvec(List<Path> classes, String... args) throws IOException, InterruptedException {
        List<String> chemin = new ArrayList<>();
        chemin.add(origine(Main.class).toString());
        chemin.add(origine(org.ini4j.Config.class).toString());
        for (Path p : classes) {
            chemin.add(p.toString());
        }
        List<String> commande = new ArrayList<>();
        commande.add(Paths.get(System.getProperty("java.home"), "bin", "java").toString());
        commande.add("-Dfile.encoding=UTF-8");
        commande.add("-Dsun.stdout.encoding=UTF-8");
        commande.add("-Dsun.stderr.encoding=UTF-8");
        commande.add("-Dstdout.encoding=UTF-8");
        commande.add("-Dstderr.encoding=UTF-8");
        commande.add("-cp");
        commande.add(String.join(File.pathSeparator, chemin));
        commande.add("lancer.Main");
        commande.addAll(Arrays.asList(args));
        Path sortie = Files.createTempFile("essai", ".sortie");
        Path erreur = Files.createTempFile("essai", ".erreur");
        try {
            Process processus = new ProcessBuilder(commande)
                    .redirectOutput(sortie.toFile()).redirectError(erreur.toFile()).start();
            int code = processus.waitFor();
            return new Essai(code, texte(sortie), texte(erreur));
        } finally {
            Files.delete(sortie);
            Files.delete(erreur);
        }
    }

    private static String texte(Path fichier) throws IOException {
        return new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
    }

    /** Le dossier ou l'archive d'où vient cette classe. */
    public static Path origine(Class<?> classe) {
        try {
            return Paths.get(classe.getProtectionDomain().getCodeSource().getLocation().toURI());
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    /** La valeur d'une ligne de {@code --statistiques}. */
    public long statistique(String nom) {
        for (String ligne : sortie.split("\n")) {
            if (ligne.startsWith(nom + ": ")) {
                return Long.parseLong(ligne.substring(nom.length() + 2));
            }
        }
        throw new AssertionError("pas de « " + nom + " » dans : " + sortie);
    }

    /** Écrit ces lignes dans un fichier de scène. */
    public static Path scene(Path fichier, String... lignes) throws IOException {
        return Files.write(fichier, Arrays.asList(lignes), StandardCharsets.UTF_8);
    }

    /** Une ressource d'essai de la classe, en texte. */
    public static String ressource(Class<?> classe, String nom) throws IOException {
        return new String(octets(classe, nom), StandardCharsets.UTF_8);
    }

    /** Une ressource d'essai de la classe. */
    public static byte[] octets(Class<?> classe, String nom) throws IOException {
        try (InputStream entree = classe.getResourceAsStream(nom)) {
            if (entree == null) {
                throw new AssertionError("ressource absente : " + nom);
            }
            ByteArrayOutputStream tout = new ByteArrayOutputStream();
            byte[] morceau = new byte[1 << 16];
            for (int lus = entree.read(morceau); lus >= 0; lus = entree.read(morceau)) {
                tout.write(morceau, 0, lus);
            }
            return tout.toByteArray();
        }
    }

    /** Les composantes d'une image PFM couleur, dans l'ordre du fichier : la ligne du bas d'abord. */
    public static float[] pfm(byte[] octets) {
        int debut = 0;
        for (int lignes = 0; lignes < 3; debut++) {
            lignes += octets[debut] == '\n' ? 1 : 0;
        }
        ByteBuffer donnees = ByteBuffer.wrap(octets, debut, octets.length - debut).order(ByteOrder.LITTLE_ENDIAN);
        float[] composantes = new float[(octets.length - debut) / Float.BYTES];
        donnees.asFloatBuffer().get(composantes);
        return composantes;
    }

    /** Dessine une scène par la ligne de commande, et rend ses composantes non limitées ; tout avertissement est un échec. */
    public static float[] dessiner(Path dossier, Path scene, String... options) throws IOException {
        Path image = dossier.resolve("image.pfm");
        List<String> args = new ArrayList<>(Arrays.asList(options));
        args.addAll(Arrays.asList("--lineaire", image.toString(), scene.toString()));
        Essai essai = executer(args.toArray(new String[0]));
        if (essai.code != 0 || !essai.erreur.isEmpty()) {
            throw new AssertionError("statut " + essai.code + " : " + essai.erreur);
        }
        return pfm(Files.readAllBytes(image));
    }

    /** Le plus grand écart, composante par composante ; infini si les tailles diffèrent ou si un nombre n'est pas fini. */
    public static double ecart(float[] a, float[] b) {
        if (a.length != b.length) {
            return Double.POSITIVE_INFINITY;
        }
        double plusGrand = 0;
        for (int k = 0; k < a.length; k++) {
            double ecart = Math.abs((double) a[k] - b[k]);
            // la comparaison est fausse pour NaN
            if (!(ecart <= Float.MAX_VALUE)) {
                return Double.POSITIVE_INFINITY;
            }
            plusGrand = Math.max(plusGrand, ecart);
        }
        return plusGrand;
    }
}
