package lancer.auto;

import lancer.Couleur;
import lancer.contrat.Vue;

/** Une vue qui se souvient : les échantillonnages essayés sur un bloc demandent souvent les mêmes points. */
final class Souvenir implements Vue {

    private static final int CASES = 1 << 10;

    private final Vue vue;
    private final Bloc bloc;
    private double[] points = new double[2 * CASES];
    private Couleur[] couleurs = new Couleur[CASES];
    private int nombre;
    private int vus;

    Souvenir(Bloc bloc, Vue vue) {
        this.bloc = bloc;
        this.vue = vue;
    }

    /** Le nombre de points demandés dans le bloc, depuis la dernière fois qu'on l'a demandé. */
    int vus() {
        int n = vus;
        vus = 0;
        return n;
    }

    @Override
    public Couleur couleur(double xe, double ye) {
        vus += bloc.contient((int) Math.floor(xe), (int) Math.floor(ye)) ? 1 : 0;
        int c = place(xe, ye);
        if (couleurs[c] == null) {
            if (2 * ++nombre > couleurs.length) {
                agrandir();
                c = place(xe, ye);
            }
            couleurs[c] = vue.couleur(xe, ye);
            points[2 * c] = xe;
            points[2 * c + 1] = ye;
        }
        return couleurs[c];
    }

    /** La case du point, ou celle, vide, où le mettre. */
    private int place(double xe, double ye) {
        int masque = couleurs.length - 1;
        int h = 31 * Double.hashCode(xe) + Double.hashCode(ye);
        int c = (h ^ h >>> 15) * 0x9E3779B9 >>> 8 & masque;
        while (couleurs[c] != null && (points[2 * c] != xe || points[2 * c + 1] != ye)) {
            c = c + 1 & masque;
        }
        return c;
    }

    private void agrandir() {
        double[] anciensPoints = points;
        Couleur[] anciennes = couleurs;
        points = new double[2 * anciensPoints.length];
        couleurs = new Couleur[2 * anciennes.length];
        for (int k = 0; k < anciennes.length; k++) {
            if (anciennes[k] != null) {
                int c = place(anciensPoints[2 * k], anciensPoints[2 * k + 1]);
                couleurs[c] = anciennes[k];
                points[2 * c] = anciensPoints[2 * k];
                points[2 * c + 1] = anciensPoints[2 * k + 1];
            }
        }
    }
}
