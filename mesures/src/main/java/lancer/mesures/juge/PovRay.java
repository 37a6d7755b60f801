package lancer.mesures.juge;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;

/** La commande {@code povray}. Elle écrit un PNG de 16 bits par composante, proportionnel à la lumière. */
public final class PovRay {

    /** Le nom sous lequel la chercher. */
    public static final String COMMANDE = "povray";

    private static final Pattern TRACE =
            Pattern.compile("Trace Time:[^(]*\\(([\\d.]+) seconds\\)\\s+using \\d+ thread\\(s\\) with ([\\d.]+) CPU");
    private static final Pattern VERSION = Pattern.compile("POV-Ray (\\d[\\w.]*)");

    private final String commande;
    private final Path dossier;
    private final String version;
    private double[] temps;

    /**
     * @param commande un nom à chercher dans PATH, ou un chemin
     * @param dossier où écrire scènes et images
     * @throws IOException si la commande ne peut être lancée
     */
    public PovRay(String commande, Path dossier) throws IOException {
        this.commande = commande;
        this.dossier = dossier;
        Path journal = dossier.resolve("version.txt");
        try {
            lancer(journal, commande, "--version");
        } catch (IOException e) {
            throw new IOException(commande + " ne se lance pas ; pour l'avoir : sudo apt-get install povray (Debian, Ubuntu), brew install"
                    + " povray (macOS)", e);
        }
        Matcher m = VERSION.matcher(texte(journal));
        version = m.find() ? m.group(1).replaceFirst("\\.unofficial$", "") : "inconnue";
        Files.delete(journal);
    }

    String nom() {
        return "POV-Ray " + version;
    }

    /** @param texte une scène de ce nom, telle que l'écrit {@link TraductionPov} */
    void ecrire(String nom, String texte) throws IOException {
        Files.write(dossier.resolve(nom + ".pov"), texte.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * @param nom d'une scène {@link #ecrire écrite}
     * @param options d'anticrénelage, dans la langue de sa commande ; aucune pour un rayon par pixel
     * @return l'image linéaire : trois composantes de 16 bits, la ligne du haut d'abord
     * @throws IOException s'il n'y arrive pas ; le message dit pourquoi
     */
    Raster dessiner(String nom, int largeur, int hauteur, String... options) throws IOException {
        Path scene = dossier.resolve(nom + ".pov");
        Path image = dossier.resolve(nom + ".png");
        Path journal = dossier.resolve(nom + ".txt");
        Files.deleteIfExists(image);
        // ni affichage, ni pause, ni hasard ; File_Gamma=1 : les niveaux du PNG sont la lumière
        List<String> dessin = new ArrayList<>(Arrays.asList(commande, "+I" + scene, "+O" + image, "+FN16", "File_Gamma=1", "+W" + largeur,
                "+H" + hauteur, "-D", "-P", "-V", "-J"));
        dessin.addAll(Arrays.asList(options.length == 0 ? new String[] {"-A"} : options));
        int statut = chronometrer(journal, dessin);
        if (statut != 0) {
            // sur une machine chargée il renonce parfois : « Timed out waiting for worker thread startup »
            statut = chronometrer(journal, dessin);
        }
        if (statut != 0 || !Files.exists(image)) {
            throw new IOException(commande + " n'a pas dessiné " + nom + ", statut " + statut + " : "
                    + texte(journal).trim().replaceFirst("(?s).*\\n\\s*", ""));
        }
        BufferedImage lue = ImageIO.read(image.toFile());
        if (lue == null || lue.getWidth() != largeur || lue.getHeight() != hauteur || lue.getRaster().getNumBands() < 3
                || lue.getSampleModel().getSampleSize(0) != 16) {
            throw new IOException(commande + " : image inattendue : " + image);
        }
        Files.delete(journal);
        return lue.getRaster();
    }

    private int chronometrer(Path journal, List<String> dessin) throws IOException {
        long debut = System.nanoTime();
        int statut = lancer(journal, dessin.toArray(new String[0]));
        double duree = System.nanoTime() - debut;
        Matcher m = TRACE.matcher(texte(journal));
        temps = m.find() ? new double[] {duree, 1e9 * Double.parseDouble(m.group(1)), 1e9 * Double.parseDouble(m.group(2))}
                : new double[] {duree, Double.NaN, Double.NaN};
        return statut;
    }

    /** Du dernier dessin, en nanosecondes : la commande entière ; selon elle, le dessin seul, et le temps de ses processeurs. */
    public double[] temps() {
        return temps.clone();
    }

    /** @return le statut de la commande, ses deux sorties dans {@code journal} */
    private static int lancer(Path journal, String... commande) throws IOException {
        Process processus = new ProcessBuilder(commande).redirectErrorStream(true).redirectOutput(journal.toFile()).start();
        try {
            return processus.waitFor();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrompu pendant " + commande[0], e);
        } finally {
            // Ctrl+C ne doit pas le laisser dessiner seul
            processus.destroy();
        }
    }

    private static String texte(Path fichier) throws IOException {
        return new String(Files.readAllBytes(fichier), StandardCharsets.UTF_8);
    }
}
