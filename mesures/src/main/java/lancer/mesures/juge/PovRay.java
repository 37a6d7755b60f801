package lancer.mesures.juge;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import lancer.mesures.Lancement;

/** La commande {@code povray}. Elle écrit un PNG de 16 bits par composante, proportionnel à la lumière. */
public final class PovRay {

    /** Nom de la commande. */
    public static final String COMMANDE = "povray";

    private static final Pattern VERSION = Pattern.compile("POV-Ray (\\d[\\w.]*)");

    private final String commande;
    private final Path dossier;
    private final String version;

    private Lancement dernier;

    /**
     * @param commande un nom à chercher dans PATH, ou un chemin
     * @param dossier dossier des scènes et des images
     * @throws IOException si la commande ne peut être lancée
     */
    public PovRay(String commande, Path dossier) throws IOException {
        this.commande = commande;
        this.dossier = dossier;
        if (lancer(Arrays.asList(commande, "--version")) > 125) {
            throw new IOException(commande + " ne se lance pas ; pour l'avoir : sudo apt-get install povray (Debian, Ubuntu), brew install"
                    + " povray (macOS)");
        }
        Matcher m = VERSION.matcher(dernier.dit);
        version = m.find() ? m.group(1).replaceFirst("\\.unofficial$", "") : "inconnue";
    }

    String nom() {
        return "POV-Ray " + version;
    }

    /** @param texte une scène de ce nom, telle que l'écrit {@link TraductionPov} */
    void ecrire(String nom, String texte) throws IOException {
        Files.write(dossier.resolve(nom + ".pov"), texte.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * @param nom celui d'une scène {@link #ecrire écrite}
     * @return l'image linéaire : trois composantes de 16 bits, la ligne du haut d'abord
     * @throws IOException si la commande échoue ; le message dit pourquoi
     */
    Raster dessiner(String nom, int largeur, int hauteur) throws IOException {
        Path scene = dossier.resolve(nom + ".pov");
        Path image = dossier.resolve(nom + ".png");
        Files.deleteIfExists(image);
        // sans affichage, pause ni hasard ; File_Gamma=1 : les niveaux du PNG sont proportionnels à la lumière
        List<String> dessin = Arrays.asList(commande, "+I" + scene, "+O" + image, "+FN16", "File_Gamma=1", "+W" + largeur,
                "+H" + hauteur, "-D", "-P", "-V", "-J", "-A");
        int statut = lancer(dessin);
        if (statut != 0) {
            // sur une machine chargée, POV-Ray échoue parfois : « Timed out waiting for worker thread startup »
            statut = lancer(dessin);
        }
        if (statut != 0 || !Files.exists(image)) {
            throw new IOException(commande + " n'a pas dessiné " + nom + ", statut " + statut + " : "
                    + dernier.derniereLigne());
        }
        BufferedImage lue = ImageIO.read(image.toFile());
        if (lue == null || lue.getWidth() != largeur || lue.getHeight() != hauteur || lue.getRaster().getNumBands() < 3
                || lue.getSampleModel().getSampleSize(0) != 16) {
            throw new IOException(commande + " : image inattendue : " + image);
        }
        return lue.getRaster();
    }

    /** Coût de la dernière commande entière ({@link Lancement#pris}). */
    public double[] pris() {
        return dernier.pris;
    }

    /** @return le statut de la commande */
    private int lancer(List<String> mots) throws IOException {
        dernier = new Lancement(dossier.resolve("povray.pris"), mots.toArray());
        return dernier.statut;
    }
}
