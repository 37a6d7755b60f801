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
    private static final double RARETE = 25;

    final int tirages;
    private final int semes;

    /** Les blocs tirés, chacun une fois. */
    final List<Pave> blocs = new ArrayList<>();

    private final List<Integer> fois = new ArrayList<>();

    /** Pour chaque bloc tiré, par quoi multiplier ce qu'on y mesure pour estimer la moyenne de tous. */
    private final List<Double> poids = new ArrayList<>();

    /**
     * @param promesses une par bloc, strictement positive
     * @param facteur de la moyenne des blocs à celle de l'image, dont les blocs du bord ont moins de pixels
     */
    Tirage(int tirages, List<Pave> parmi, double[] promesses, double facteur) {
        this.tirages = tirages;
        semes = promesses.length;
        double somme = 0;
        for (double promesse : promesses) {
            somme += promesse;
        }
        double cumul = 0;
        int faits = 0;
        for (int k = 0; k < semes; k++) {
            cumul += promesses[k];
            int avant = faits;
            while (faits < tirages && (faits + 0.5) * somme < cumul * tirages) {
                faits++;
            }
            if (faits > avant) {
                blocs.add(parmi.get(k));
                fois.add(faits - avant);
                poids.add(facteur * somme / promesses[k] / semes);
            }
        }
    }

    /** @param mesures une par bloc tiré, en niveaux² */
    Estimation estimer(double[] mesures) {
        double somme = 0;
        double carres = 0;
        double carresDesBlocs = 0;
        for (int k = 0; k < mesures.length; k++) {
            double mesure = mesures[k] * poids.get(k);
            somme += fois.get(k) * mesure;
            carres += fois.get(k) * mesure * mesure;
            carresDesBlocs += fois.get(k) * mesure * mesures[k];
        }
        double moyenne = somme / tirages;
        double duTirage = (carres / tirages - moyenne * moyenne) / (tirages - 1);
        // ceux parmi lesquels on tire ne sont eux-mêmes que quelques-uns de l'image
        double duSemis = (carresDesBlocs / tirages - moyenne * moyenne) / semes;
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

    /** Nombre de pixels de tous les blocs tirés. */
    int pixels() {
        int pixels = 0;
        for (Pave bloc : blocs) {
            pixels += bloc.pixels();
        }
        return pixels;
    }
}
