package lancer.antialias;

import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Le travail de {@link Partage} sur un pavé. La case d'un pixel va de son premier sous-pixel à ceux du pixel de droite
 * et de la ligne suivante. Au bord du pavé, elle s'arrête à son dernier sous-pixel. Une case de (x0, y0) à (x1, y1)
 * donne les couleurs des sous-pixels de x0 à x1 − 1 et de y0 à y1 − 1, et des derniers du pavé. Un seul fil l'utilise.
 */
final class Cases {

    /** Contraste supposé entre quatre couleurs égales : si le seuil est inférieur, toute case est divisée. */
    static final double PRUDENCE = 0.05;

    private final int n;
    private final double seuil;
    private final Petites petites;
    private final Pave pave;
    private final Vue vue;
    private final SousPixels sousPixels;
    private final int largeur;
    private final int hauteur;

    /** Vrai si la case d'un pixel, ou d'un voisin, dépasse le seuil ; les indices sont décalés de un. */
    private final boolean[][] suspects;

    /** Le pixel en cours, dans le pavé ; ses derniers sous-pixels ; la somme des sous-pixels déjà peints. */
    private int i;
    private int j;
    private int finX;
    private int finY;
    private Couleur somme;

    Cases(int n, double seuil, Petites petites, Pave pave, Vue vue) {
        this.n = n;
        this.seuil = seuil;
        this.petites = petites;
        this.pave = pave;
        this.vue = vue;
        sousPixels = new SousPixels(n, pave, vue);
        largeur = pave.i1 - pave.i0;
        hauteur = pave.j1 - pave.j0;
        suspects = new boolean[hauteur + 2][largeur + 2];
    }

    /** Dessine ces pixels du pavé. @return le nombre de pixels dont la case a été divisée */
    int tracer(Pave voulus, Toile toile) {
        chercherLesSuspects(voulus);
        int raffines = 0;
        for (int y = voulus.j0 - pave.j0; y < voulus.j1 - pave.j0; y++) {
            for (int x = voulus.i0 - pave.i0; x < voulus.i1 - pave.i0; x++) {
                commencer(x, y);
                raffines += peindre(0, 0, finX, finY) ? 1 : 0;
                toile.drawPixel(somme.div(n * n), pave.i0 + x, pave.j0 + y);
            }
            sousPixels.oublier(y);
        }
        return raffines;
    }

    private void commencer(int x, int y) {
        i = x;
        j = y;
        finX = i + 1 < largeur ? n : n - 1;
        finY = j + 1 < hauteur ? n : n - 1;
        somme = new Couleur();
    }

    private void chercherLesSuspects(Pave voulus) {
        for (int y = Math.max(0, voulus.j0 - pave.j0 - 1); y < Math.min(hauteur, voulus.j1 - pave.j0 + 1); y++) {
            for (int x = Math.max(0, voulus.i0 - pave.i0 - 1); x < Math.min(largeur, voulus.i1 - pave.i0 + 1); x++) {
                commencer(x, y);
                boolean suspect = depasse(0, 0, finX, finY);
                for (int k = 0; k < 9 && suspect; k++) {
                    suspects[y + k / 3][x + k % 3] = true;
                }
            }
        }
    }

    /** Dit si contraste × côté dépasse le seuil : une petite case change peu la couleur du pixel. */
    private boolean depasse(int x0, int y0, int x1, int y1) {
        double contraste = Coins.contraste(voir(x0, y0), voir(x1, y0), voir(x0, y1), voir(x1, y1));
        return (contraste + PRUDENCE) * Math.sqrt((double) (x1 - x0) * (y1 - y0)) / n > seuil;
    }

    /** Dit si une petite sphère peut être dans la case sans toucher ses coins. */
    private boolean peutEchapper(int x0, int y0, int x1, int y1) {
        double x = pave.i0 + i + 0.5 / n;
        double y = pave.j0 + j + 0.5 / n;
        return petites != null && petites.peutEchapper(x + (double) x0 / n, y + (double) y0 / n, x + (double) x1 / n,
                y + (double) y1 / n);
    }

    private Couleur voir(int x, int y) {
        return sousPixels.voir(i, j, x, y);
    }

    /** Peint une case, divisée en quatre si besoin, ou en deux si elle n'a qu'un sous-pixel de large ou de haut. */
    private boolean peindre(int x0, int y0, int x1, int y1) {
        if (x0 == x1 || y0 == y1) {
            return false;
        }
        boolean divisible = x1 - x0 > 1 || y1 - y0 > 1;
        boolean duPixel = x1 - x0 == finX && y1 - y0 == finY;
        if (!divisible || !(duPixel ? suspects[j + 1][i + 1] : depasse(x0, y0, x1, y1))
                && !peutEchapper(x0, y0, x1, y1)) {
            interpoler(x0, y0, x1, y1);
            return false;
        }
        int xm = (x0 + x1) / 2;
        int ym = (y0 + y1) / 2;
        peindre(x0, y0, xm, ym);
        peindre(xm, y0, x1, ym);
        peindre(x0, ym, xm, y1);
        peindre(xm, ym, x1, y1);
        return true;
    }

    /**
     * Ajoute au pixel les sous-pixels de la case, interpolés entre ses quatre coins. La moyenne d'une fonction
     * bilinéaire sur un rectangle est sa valeur au milieu : il suffit d'un poids pour chaque coin.
     */
    private void interpoler(int x0, int y0, int x1, int y1) {
        int suivantX = x1 == n - 1 && x1 == finX ? n : x1;
        int suivantY = y1 == n - 1 && y1 == finY ? n : y1;
        double nombre = (suivantX - x0) * (suivantY - y0);
        double fx = (suivantX - x0 - 1) / (2.0 * (x1 - x0));
        double fy = (suivantY - y0 - 1) / (2.0 * (y1 - y0));
        ajouter(x0, y0, nombre * (1 - fx) * (1 - fy));
        ajouter(x1, y0, nombre * fx * (1 - fy));
        ajouter(x0, y1, nombre * (1 - fx) * fy);
        ajouter(x1, y1, nombre * fx * fy);
    }

    /** Ajoute un coin, sauf si son poids est nul : sa couleur n'est alors pas calculée. */
    private void ajouter(int x, int y, double poids) {
        if (poids > 0) {
            Couleur couleur = voir(x, y);
            Couleur terme = couleur.mul(poids);
            somme = somme.add(terme);
        }
    }
}
