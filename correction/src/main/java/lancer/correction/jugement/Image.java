package lancer.correction.jugement;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.util.Base64;

/** Une image, en couleurs non limitées. */
public final class Image {

    private static final double PRES = 1e-6;

    public final int largeur;
    public final int hauteur;
    private final float[] rvb;

    Image(int largeur, int hauteur, float[] rvb) {
        this.largeur = largeur;
        this.hauteur = hauteur;
        this.rvb = rvb;
    }

    /** @param texte ce que répond {@code SondeImage} */
    static Image lire(int largeur, int hauteur, String texte) {
        float[] rvb = new float[largeur * hauteur * 3];
        try {
            ByteBuffer.wrap(Base64.getDecoder().decode(texte)).asFloatBuffer().get(rvb);
        } catch (IllegalArgumentException | BufferUnderflowException e) {
            throw new Dialogue.Echec("réponse incompréhensible au lieu d'une image");
        }
        return new Image(largeur, hauteur, rvb);
    }

    /** Une composante, limitée à [0, 1], en niveaux de 255 ; 0 si ce n'est pas un nombre. */
    double niveau(int pixel, int composante) {
        float x = rvb[3 * pixel + composante];
        return x > 0 ? 255 * Math.min(1, x) : 0;
    }

    double brut(int pixel, int composante) {
        return rvb[3 * pixel + composante];
    }

    /** Combien de pixels ont la même couleur dans les deux images, à quelques arrondis près. */
    int pareils(Image autre) {
        int n = 0;
        for (int p = 0; p < pixels(); p++) {
            n += Math.abs(brut(p, 0) - autre.brut(p, 0)) < PRES && Math.abs(brut(p, 1) - autre.brut(p, 1)) < PRES
                    && Math.abs(brut(p, 2) - autre.brut(p, 2)) < PRES ? 1 : 0;
        }
        return n;
    }

    /**
     * La ressemblance de ce qui distingue une image de {@code sans} à ce qui en distingue {@code attendue}, ailleurs que là où
     * l'on voyait {@code ciel} : 1 si l'un est proportionnel à l'autre, 0 s'ils n'ont rien de commun.
     */
    static double accord(Image image, Image attendue, Image sans, Image ciel) {
        double produits = 0;
        double carres = 0;
        double attendus = 0;
        for (int k = 0; k < 3 * sans.pixels(); k++) {
            if (Ecart.ecart(sans, ciel, k / 3) > 0) {
                double effet = image.niveau(k / 3, k % 3) - sans.niveau(k / 3, k % 3);
                double attendu = attendue.niveau(k / 3, k % 3) - sans.niveau(k / 3, k % 3);
                produits += effet * attendu;
                carres += effet * effet;
                attendus += attendu * attendu;
            }
        }
        return carres > 0 && attendus > 0 ? produits / Math.sqrt(carres * attendus) : 0;
    }

    /** De quoi la relire. */
    String texte() {
        ByteBuffer octets = ByteBuffer.allocate(4 * rvb.length);
        octets.asFloatBuffer().put(rvb);
        return largeur + " " + hauteur + " " + Base64.getEncoder().encodeToString(octets.array());
    }

    static Image relire(String texte) {
        String[] mots = texte.split(" ");
        return lire(Integer.parseInt(mots[0]), Integer.parseInt(mots[1]), mots[2]);
    }

    int pixels() {
        return largeur * hauteur;
    }

    /** Le pixel comme un écran le veut. */
    public int code(int x, int y) {
        int code = 0;
        for (int k = 0; k < 3; k++) {
            code = code << 8 | (int) Math.round(niveau(y * largeur + x, k));
        }
        return code;
    }
}
