package lancer.antialias;

import java.util.Arrays;
import lancer.Couleur;
import lancer.contrat.Pave;
import lancer.contrat.Releve;
import lancer.contrat.Toile;
import lancer.contrat.Vue;

/**
 * Le travail de {@link Partage} sur un pavé. La case d'un pixel va de son premier sous-pixel à ceux du pixel de droite
 * et de la ligne suivante. Au bord du pavé, elle s'arrête à son dernier sous-pixel. Une case de (x0, y0) à (x1, y1)
 * donne les couleurs des sous-pixels de x0 à x1 − 1 et de y0 à y1 − 1, et des derniers du pavé. Un seul fil l'utilise.
 */
final class Cases {

    /** Surprise moyenne tolérée dans des cases d'un pixel de côté, en seuils. */
    private static final double SURPRISE = 0.125;
    /** Divisions permises de toutes les cases d'un pavé, dont les sous-pixels occupent la mémoire ensemble. */
    private static final int DIVISIONS = 4;

    private final int n;
    private final double seuil;
    private final Pave pave;
    private final boolean seconde;
    private final SousPixels sousPixels;
    /** Les bords des cases de tout le pavé, en sous-pixels. */
    private int[] bordsX;
    private int[] bordsY;
    /** La somme des sous-pixels déjà peints du pixel en cours, par composante : une case fait plusieurs termes. */
    private double r;
    private double v;
    private double b;

    Cases(int n, double seuil, Pave pave, Vue vue) {
        this.n = n;
        this.seuil = seuil;
        this.pave = pave;
        seconde = vue.estSeconde();
        sousPixels = new SousPixels(n, pave, vue);
        bordsX = bords(pave.i1 - pave.i0);
        bordsY = bords(pave.j1 - pave.j0);
    }

    private int[] bords(int pixels) {
        int[] bords = new int[pixels + 1];
        Arrays.setAll(bords, i -> Math.min(i * n, pixels * n - 1));
        return bords;
    }

    /** Dessine ces pixels du pavé. @return avec le nombre de pixels dont la case a été divisée */
    Releve tracer(Pave voulus, Toile toile) {
        int[] departsX = bordsX;
        int[] departsY = bordsY;
        double limite = SURPRISE * seuil;
        Surprise premiere = surprendre();
        boolean surpris = premiere.depasse(limite);
        double soupcon = premiere.getSoupcon(limite);
        int divisions = 0;
        // au second regard, un pavé où rien n'a surpris se cherche lui aussi
        for (boolean cherche = surpris || seconde; cherche; cherche = divisions < DIVISIONS && 1 << divisions < n
                && surprendre().depasse(limite)) {
            bordsX = couper(bordsX);
            bordsY = couper(bordsY);
            divisions++;
            // quatre fois plus de points divisent par deux l'erreur d'un pixel
            limite *= 2;
        }
        int raffines = 0;
        for (int j = voulus.j0 - pave.j0; j < voulus.j1 - pave.j0; j++) {
            for (int i = voulus.i0 - pave.i0; i < voulus.i1 - pave.i0; i++) {
                r = 0;
                v = 0;
                b = 0;
                raffines += peindre(departsX[i], departsY[j], departsX[i + 1], departsY[j + 1], divisions) ? 1 : 0;
                toile.drawPixel(new Couleur(r, v, b).div(n * n), pave.i0 + i, pave.j0 + j);
            }
            sousPixels.oublier(j);
        }
        return new Releve(raffines, soupcon, !surpris && !seconde);
    }

    /** Ces bords et les milieux, là où il reste des sous-pixels entre deux. */
    private static int[] couper(int... bords) {
        int[] coupes = new int[2 * bords.length];
        int nombre = 0;
        for (int k = 0; k + 1 < bords.length; k++) {
            coupes[nombre++] = bords[k];
            if (bords[k + 1] - bords[k] > 1) {
                coupes[nombre++] = (bords[k] + bords[k + 1]) / 2;
            }
        }
        coupes[nombre++] = bords[bords.length - 1];
        return Arrays.copyOf(coupes, nombre);
    }

    /** Compare les couleurs vues : un coin à ses quatre voisins ; le milieu d'une case sur deux à ses coins. */
    private Surprise surprendre() {
        Surprise surprise = new Surprise();
        for (int j = 0; j + 1 < bordsY.length; j++) {
            for (int i = 0; i + 1 < bordsX.length; i++) {
                int x0 = bordsX[i];
                int y0 = bordsY[j];
                int x1 = bordsX[i + 1];
                int y1 = bordsY[j + 1];
                if (i > 0 && j > 0) {
                    surprise.comparer(voir(x0, y0), voir(bordsX[i - 1], y0), voir(x1, y0), voir(x0, bordsY[j - 1]),
                            voir(x0, y1));
                }
                if ((i + j) % 2 == 0 && Math.max(x1 - x0, y1 - y0) > 1) {
                    surprise.comparer(voir((x0 + x1) / 2, (y0 + y1) / 2), voir(x0, y0), voir(x1, y0), voir(x0, y1),
                            voir(x1, y1));
                }
            }
        }
        return surprise;
    }

    private Couleur voir(int x, int y) {
        return sousPixels.voir(x, y);
    }

    /** Dit si contraste × côté dépasse le seuil : une petite case change peu la couleur du pixel. */
    private boolean depasse(int x0, int y0, int x1, int y1) {
        double contraste = Coins.contraste(voir(x0, y0), voir(x1, y0), voir(x0, y1), voir(x1, y1));
        return contraste * Math.sqrt((double) (x1 - x0) * (y1 - y0)) / n > seuil;
    }

    /**
     * Peint une case, divisée en quatre si besoin, ou en deux si elle n'a qu'un sous-pixel de large ou de haut.
     *
     * @param divisions nombre de divisions imposées
     */
    private boolean peindre(int x0, int y0, int x1, int y1, int divisions) {
        if (x0 == x1 || y0 == y1) {
            return false;
        }
        if (Math.max(x1 - x0, y1 - y0) == 1 || divisions <= 0 && !depasse(x0, y0, x1, y1)) {
            interpoler(x0, y0, x1, y1);
            return false;
        }
        int xm = (x0 + x1) / 2;
        int ym = (y0 + y1) / 2;
        peindre(x0, y0, xm, ym, divisions - 1);
        peindre(xm, y0, x1, ym, divisions - 1);
        peindre(x0, ym, xm, y1, divisions - 1);
        peindre(xm, ym, x1, y1, divisions - 1);
        return true;
    }

    /**
     * Ajoute au pixel les sous-pixels de la case, interpolés entre ses quatre coins. La moyenne d'une fonction
     * bilinéaire sur un rectangle est sa valeur au milieu : il suffit d'un poids pour chaque coin.
     */
    private void interpoler(int x0, int y0, int x1, int y1) {
        int suivantX = x1 == bordsX[bordsX.length - 1] ? x1 + 1 : x1;
        int suivantY = y1 == bordsY[bordsY.length - 1] ? y1 + 1 : y1;
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
            Couleur vue = voir(x, y);
            r += poids * vue.r;
            v += poids * vue.v;
            b += poids * vue.b;
        }
    }
}
