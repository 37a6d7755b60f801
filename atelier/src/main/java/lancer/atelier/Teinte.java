package lancer.atelier;

/** Des couleurs par leur teinte, leur vivacité et leur clarté, plus faciles à accorder que rouge, vert et bleu. */
final class Teinte {

    private Teinte() {
    }

    /**
     * @param teinte en tours : 0 rouge, 1/3 vert, 2/3 bleu
     * @param vivacite 0 gris, 1 vif
     * @param clarte la plus grande des trois composantes
     * @return rouge, vert, bleu, au millième
     */
    static double[] couleur(double teinte, double vivacite, double clarte) {
        double[] rvb = new double[3];
        for (int i = 0; i < 3; i++) {
            double ecart = teinte - i / 3.0;
            // distance à la composante pure sur le cercle des teintes, de 0 à 1/2
            double distance = Math.abs(ecart - Math.rint(ecart));
            double presence = Math.max(0, Math.min(1, 2 - 6 * distance));
            rvb[i] = Math.rint(1000 * clarte * (1 - vivacite * (1 - presence))) / 1000;
        }
        return rvb;
    }

    /** Trois composantes égales. */
    static double[] gris(double clarte) {
        return new double[] {clarte, clarte, clarte};
    }
}
