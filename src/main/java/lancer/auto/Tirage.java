package lancer.auto;

import java.util.ArrayList;
import java.util.List;
import lancer.contrat.Pave;

/**
 * Un choix de blocs d'autant plus probable qu'ils promettent d'erreur (tirage systématique à probabilités inégales,
 * Madow, 1949) : un pixel de ciel n'apprend rien, un pixel de bord beaucoup. Chaque mesure est divisée par sa
 * probabilité, et leur moyenne reste sans biais (Hansen et Hurwitz, 1943).
 */
final class Tirage {

    /**
     * Dispersion des carrés que l'on suppose au moins, rapportée au carré de leur moyenne : quelques blocs font presque
     * toute l'erreur d'un bon échantillonnage, et ils peuvent tous manquer au tirage.
     */
    private static final double RARETE = 160;

    private static final int TIRAGES_MIN = 40;
    private static final int TIRAGES_MAX = 360;

    final int tirages;
    private final int semes;

    /** Les blocs tirés, chacun une fois. */
    final List<Pave> blocs = new ArrayList<>();

    /** Pour chaque bloc tiré, combien de fois il l'est, et par quoi multiplier ce qu'on y mesure pour estimer tout. */
    private final List<Integer> fois = new ArrayList<>();
    private final List<Double> poids = new ArrayList<>();

    /**
     * @param combien de tirages, à peu près : assez pour en dire quelque chose, et pas plus qu'il n'est utile
     * @param promesses une par bloc, strictement positive
     * @param debut entre 0 et 1 : un autre début tire d'autres blocs
     */
    Tirage(double combien, List<Pave> parmi, double[] promesses, double debut) {
        tirages = (int) Math.max(TIRAGES_MIN, Math.min(TIRAGES_MAX, combien));
        semes = promesses.length;
        double somme = Estimation.moyenne(promesses) * semes;
        // une mesure vaut pour un bloc entier, et les blocs du bord ont parfois moins de pixels
        double entiers = Essais.pixels(parmi) / (double) (Essais.COTE * Essais.COTE);
        double cumul = 0;
        int faits = 0;
        for (int k = 0; k < semes; k++) {
            cumul += promesses[k];
            int encore = (int) (cumul / somme * tirages + debut) - faits;
            if (encore > 0) {
                blocs.add(parmi.get(k));
                fois.add(encore);
                poids.add(somme / promesses[k] / entiers);
                faits += encore;
            }
        }
    }

    /** @param mesures une par bloc tiré, en niveaux² */
    Estimation estimer(double[] mesures) {
        double moyenne = 0;
        double carres = 0;
        double carresDesBlocs = 0;
        for (int k = 0; k < mesures.length; k++) {
            double mesure = mesures[k] * poids.get(k);
            double part = fois.get(k) / (double) tirages;
            moyenne += part * mesure;
            carres += part * mesure * mesure;
            carresDesBlocs += part * mesure * mesures[k];
        }
        double duTirage = (carres - moyenne * moyenne) / (tirages - 1);
        // ceux parmi lesquels on tire ne sont eux-mêmes que quelques-uns de l'image
        double duSemis = (carresDesBlocs - moyenne * moyenne) / semes;
        double rare = RARETE * moyenne * moyenne / tirages;
        return new Estimation(Math.max(0, moyenne), Math.max(rare, Math.max(0, duTirage) + Math.max(0, duSemis)));
    }

    /** Par pixel de l'image, un nombre compté sur chaque bloc tiré : exact si tous les pixels se valent. */
    double parPixel(double[] comptes) {
        double somme = 0;
        double pixels = 0;
        for (int k = 0; k < comptes.length; k++) {
            somme += comptes[k] * poids.get(k) * fois.get(k);
            pixels += blocs.get(k).pixels() * poids.get(k) * fois.get(k);
        }
        return somme / pixels;
    }
}
