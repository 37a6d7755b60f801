package lancer.antialias;

import java.util.Arrays;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Le travail de {@link Partage} sur un pavé. Une case va du sous-pixel (x0, y0) au sous-pixel (x1, y1), comptés depuis le coin
 * du pavé ; elle répond de ceux de x0 à x1 − 1 et de y0 à y1 − 1, et des derniers du pavé. N'appartient qu'à un fil.
 */
final class Cases {

    /** Le contraste qu'on suppose invisible entre quatre couleurs égales : sous ce seuil, toute case de la trame est coupée. */
    static final double PRUDENCE = 0.05;

    private final int n;
    private final double seuil;
    private final Pave pave;
    private final Bande bande;
    /** La trame : un sous-pixel par pixel, plus la dernière colonne et la dernière ligne du pavé, ligne par ligne. */
    private final int largeur;
    private final int hauteur;
    private final Couleur[] trame;
    /** Pour chaque pixel, ligne par ligne : si la case qui en part doit être coupée, la somme des sous-pixels, s'il est raffiné. */
    private final boolean[] suspectes;
    private final Couleur[] sommes;
    private final boolean[] raffines;

    Cases(int n, double seuil, Pave pave, Vue vue) {
        this.n = n;
        this.seuil = seuil;
        this.pave = pave;
        bande = new Bande(n, pave, vue);
        largeur = pave.i1 - pave.i0;
        hauteur = pave.j1 - pave.j0;
        trame = new Couleur[(largeur + 1) * (hauteur + 1)];
        for (int j = 0; j <= hauteur; j++) {
            for (int i = 0; i <= largeur; i++) {
                trame[j * (largeur + 1) + i] =
                        vue.couleur(pave.i0 + (sousPixel(i, largeur) + 0.5) / n, pave.j0 + (sousPixel(j, hauteur) + 0.5) / n);
            }
        }
        suspectes = new boolean[largeur * hauteur];
        sommes = new Couleur[largeur * hauteur];
        raffines = new boolean[largeur * hauteur];
        Arrays.fill(sommes, new Couleur());
    }

    /** La colonne (ou la ligne) de sous-pixels de la trame, sur un pavé de {@code nombre} pixels. */
    private int sousPixel(int k, int nombre) {
        return Math.min(k * n, nombre * n - 1);
    }

    /** @return le nombre de pixels raffinés */
    int tracer(Toile toile) {
        for (int j = 0; j < hauteur; j++) {
            for (int i = 0; i < largeur; i++) {
                suspectes[j * largeur + i] = suspecte(i, j);
            }
        }
        for (int j = 0; j < hauteur; j++) {
            tracerRangee(j);
        }
        int nombre = 0;
        for (int k = 0; k < sommes.length; k++) {
            toile.drawPixel(sommes[k].div(n * n), pave.i0 + k % largeur, pave.j0 + k / largeur);
            nombre += raffines[k] ? 1 : 0;
        }
        return nombre;
    }

    /** Vrai si la case de la trame qui part de ce pixel dépasse le seuil à elle seule. */
    private boolean suspecte(int i, int j) {
        int k = j * (largeur + 1) + i;
        double contraste = Contraste.entre(trame[k], trame[k + 1], trame[k + largeur + 1], trame[k + largeur + 2]);
        return depasse(contraste, sousPixel(i + 1, largeur) - i * n, sousPixel(j + 1, hauteur) - j * n);
    }

    /** Le contraste compte pour autant que la case est grande : une petite ne change guère un pixel. */
    private boolean depasse(double contraste, int dx, int dy) {
        return (contraste + PRUDENCE) * Math.sqrt((double) dx * dy) / n > seuil;
    }

    private void tracerRangee(int j) {
        if (j > 0) {
            bande.descendre();
        }
        int y0 = j * n;
        int y1 = sousPixel(j + 1, hauteur);
        for (int i = 0; i <= largeur; i++) {
            bande.poser(sousPixel(i, largeur), y0, trame[j * (largeur + 1) + i]);
            bande.poser(sousPixel(i, largeur), y1, trame[(j + 1) * (largeur + 1) + i]);
        }
        for (int i = 0; i < largeur; i++) {
            int x0 = i * n;
            int x1 = sousPixel(i + 1, largeur);
            if (voisineSuspecte(i, j)) {
                couper(x0, y0, x1, y1);
            } else {
                interpoler(x0, y0, x1, y1, false);
            }
        }
    }

    /** Vrai si cette case de la trame ou l'une de ses huit voisines est suspecte : un détail y déborde souvent. */
    private boolean voisineSuspecte(int i, int j) {
        for (int y = Math.max(0, j - 1); y < Math.min(hauteur, j + 2); y++) {
            for (int x = Math.max(0, i - 1); x < Math.min(largeur, i + 2); x++) {
                if (suspectes[y * largeur + x]) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Peint une case en quatre, ou en deux si elle n'a qu'un sous-pixel de large ou de haut. */
    private void couper(int x0, int y0, int x1, int y1) {
        int xm = x1 - x0 > 1 ? (x0 + x1) / 2 : x1;
        int ym = y1 - y0 > 1 ? (y0 + y1) / 2 : y1;
        peindre(x0, y0, xm, ym);
        if (xm < x1) {
            peindre(xm, y0, x1, ym);
        }
        if (ym < y1) {
            peindre(x0, ym, xm, y1);
        }
        if (xm < x1 && ym < y1) {
            peindre(xm, ym, x1, y1);
        }
    }

    private void peindre(int x0, int y0, int x1, int y1) {
        boolean divisible = x1 - x0 > 1 || y1 - y0 > 1;
        double contraste = Contraste.entre(bande.voir(x0, y0), bande.voir(x1, y0), bande.voir(x0, y1), bande.voir(x1, y1));
        if (divisible && depasse(contraste, x1 - x0, y1 - y0)) {
            couper(x0, y0, x1, y1);
        } else {
            interpoler(x0, y0, x1, y1, true);
        }
    }

    /**
     * Ajoute à chaque pixel ceux de ses sous-pixels dont répond la case, interpolés entre ses quatre coins. La moyenne d'une
     * fonction bilinéaire sur un rectangle est sa valeur au milieu : un seul calcul par pixel suffit.
     */
    private void interpoler(int x0, int y0, int x1, int y1, boolean raffine) {
        Couleur a = bande.voir(x0, y0);
        Couleur b = bande.voir(x1, y0);
        Couleur c = bande.voir(x0, y1);
        Couleur d = bande.voir(x1, y1);
        int finX = x1 == largeur * n - 1 ? x1 + 1 : x1;
        int finY = y1 == hauteur * n - 1 ? y1 + 1 : y1;
        for (int y = y0, ySuivant; y < finY; y = ySuivant) {
            ySuivant = Math.min(finY, (y / n + 1) * n);
            double fy = ((y + ySuivant - 1) / 2.0 - y0) / (y1 - y0);
            for (int x = x0, xSuivant; x < finX; x = xSuivant) {
                xSuivant = Math.min(finX, (x / n + 1) * n);
                double fx = ((x + xSuivant - 1) / 2.0 - x0) / (x1 - x0);
                int nombre = (xSuivant - x) * (ySuivant - y);
                Couleur haut = a.mul(1 - fx).add(b.mul(fx));
                Couleur bas = c.mul(1 - fx).add(d.mul(fx));
                int pixel = y / n * largeur + x / n;
                sommes[pixel] = sommes[pixel].add(haut.mul(1 - fy).add(bas.mul(fy)).mul(nombre));
                raffines[pixel] |= raffine;
            }
        }
    }
}
