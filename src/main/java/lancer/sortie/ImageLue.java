package lancer.sortie;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Locale;
import lancer.Couleur;
import lancer.commande.CodeSortie;
import lancer.commande.Echec;
import lancer.texte.Texte;

/** Une image à comparer : lue dans un PNG ou un PFM, ou dessinée à l'instant. */
public final class ImageLue {

    private final int largeur;
    private final int hauteur;

    /** Rouge, vert, bleu de chaque pixel, ligne par ligne depuis le haut. */
    private final float[] composantes;

    /** Vrai si les couleurs ne sont que des multiples de 1/255. */
    private final boolean surHuitBits;

    /** Les codes qu'un écran montre, si on les a : tirés des flottants, quelques-uns s'arrondiraient autrement. */
    private final int[] codes;

    ImageLue(int largeur, int hauteur, float[] composantes, boolean surHuitBits) {
        this(largeur, hauteur, composantes, surHuitBits, null);
    }

    private ImageLue(int largeur, int hauteur, float[] composantes, boolean surHuitBits, int[] codes) {
        this.codes = codes;
        this.largeur = largeur;
        this.hauteur = hauteur;
        this.composantes = composantes;
        this.surHuitBits = surHuitBits;
    }

    /** @param image une image qui a gardé ses couleurs non limitées */
    public ImageLue(ImageMemoire image) {
        this(image.getLargeur(), image.getHauteur(), image.getLineaire(), false, image.getCodes());
    }

    /** Vrai si ce nom est celui d'une image, et non d'une scène. */
    public static boolean estImage(String nom) {
        String bas = nom.toLowerCase(Locale.ROOT);
        return bas.endsWith(".png") || bas.endsWith(".pfm");
    }

    /** @throws Echec si le fichier n'est pas une image PNG ou PFM que l'on sache lire */
    public static ImageLue lire(String nom) {
        try {
            Path fichier = Paths.get(nom);
            if (!Files.isRegularFile(fichier)) {
                throw new IOException(Files.exists(fichier) ? "ce n'est pas un fichier" : "fichier introuvable");
            }
            byte[] octets = Files.readAllBytes(fichier);
            return nom.toLowerCase(Locale.ROOT).endsWith(".png") ? LecturePng.lire(octets) : LecturePfm.lire(octets);
        } catch (IOException | InvalidPathException | OutOfMemoryError e) {
            throw new Echec(CodeSortie.DEMANDE,
                    Texte.echappe(nom) + " : image illisible : " + e.getMessage() + " ; attendu : un PNG ou un PFM");
        }
    }

    public int getLargeur() {
        return largeur;
    }

    public int getHauteur() {
        return hauteur;
    }

    boolean estSurHuitBits() {
        return surHuitBits;
    }

    /** Le pixel de rang {@code p}, sur 8 bits, comme un écran ou un PNG le veut. */
    int code(int p) {
        return codes != null ? codes[p]
                : new Couleur(composantes[3 * p], composantes[3 * p + 1], composantes[3 * p + 2]).getCode();
    }

    /** Une composante limitée à [0, 1], en niveaux de 255. @param k rang de la composante, depuis le haut */
    double niveau(int k) {
        return 255 * Math.min(1, Math.max(0, (double) composantes[k]));
    }

    boolean aUnNaN() {
        for (float c : composantes) {
            if (Float.isNaN(c)) {
                return true;
            }
        }
        return false;
    }
}
