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

    /** La racine de la somme des carrés des écarts, en couleurs limitées à [0, 1]. */
    double distance(Image autre) {
        double carres = 0;
        for (int p = 0; p < pixels(); p++) {
            for (int c = 0; c < 3; c++) {
                carres += Math.pow(niveau(p, c) - autre.niveau(p, c), 2);
            }
        }
        return Math.sqrt(carres);
    }

    Image plus(Image autre) {
        float[] somme = rvb.clone();
        for (int k = 0; k < somme.length; k++) {
            somme[k] += autre.rvb[k];
        }
        return new Image(largeur, hauteur, somme);
    }

    /** L'image, n fois plus petite, dont chaque pixel est la moyenne de n x n, à partir de {@code debut}. */
    Image moyenne(int n, int debut) {
        Image petite = new Image(largeur / n, hauteur / n, new float[rvb.length / (n * n)]);
        for (int k = 0; k < petite.rvb.length; k++) {
            int x = k / 3 % petite.largeur * n + debut;
            int y = k / 3 / petite.largeur * n + debut;
            for (int s = 0; s < n * n; s++) {
                int pixel = Math.max(0, y + s / n) * largeur + Math.max(0, x + s % n);
                petite.rvb[k] += rvb[3 * pixel + k % 3] / (n * n);
            }
        }
        return petite;
    }

    /**
     * Dans un carré, les droites de même pente qui donnent au mieux les trois composantes de l'autre image d'après celles
     * de celle-ci : leurs ordonnées à l'origine, puis leur pente.
     */
    double[] regression(Image autre, int x, int y, int cote) {
        double[] moyennes = new double[6];
        double produits = 0;
        double carres = 0;
        for (int passe = 0; passe < 2; passe++) {
            for (int k = 0; k < 3 * cote * cote; k++) {
                int pixel = (y + k / 3 / cote) * largeur + x + k / 3 % cote;
                int c = k % 3;
                if (passe == 0) {
                    moyennes[c] += brut(pixel, c) / (cote * cote);
                    moyennes[3 + c] += autre.brut(pixel, c) / (cote * cote);
                } else {
                    produits += (brut(pixel, c) - moyennes[c]) * (autre.brut(pixel, c) - moyennes[3 + c]);
                    carres += Math.pow(brut(pixel, c) - moyennes[c], 2);
                }
            }
        }
        double pente = carres > 0 ? produits / carres : 1;
        return new double[] {moyennes[3] - pente * moyennes[0], moyennes[4] - pente * moyennes[1],
            moyennes[5] - pente * moyennes[2], pente};
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
