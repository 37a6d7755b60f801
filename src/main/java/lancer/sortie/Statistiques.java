package lancer.sortie;

import java.util.Arrays;
import java.util.Locale;
import lancer.contrat.Compteurs;

/**
 * Ce que le programme dit de lui-même après une image : comptes d'un dessin, et temps. Toujours avec un point décimal,
 * sans séparateur de milliers ni exposant, quelle que soit la langue de la machine.
 */
public final class Statistiques {

    private static final double NS_PAR_MS = 1e6;

    private Statistiques() {
    }

    /**
     * Des lignes {@code nom: valeur}, sans fin de ligne après la dernière.
     *
     * @param c ce qu'a compté un dessin
     * @param lectureNs temps de lecture de la scène, en nanosecondes
     * @param preparationNs temps de construction des structures de recherche, en nanosecondes
     * @param tracesNs temps de chaque dessin, dans l'ordre, en nanosecondes
     */
    public static String lignes(Compteurs c, long lectureNs, long preparationNs, long... tracesNs) {
        double trace = mediane(tracesNs);
        return String.format(Locale.ROOT, "rayons.primaires: %d\nrayons.ombre: %d\nrayons.reflechis: %d\n"
                + "tests.spheres: %d\ntests.precis: %d\nnoeuds.visites: %d\nexamens.essais: %d\npixels.raffines: %d\n"
                + "pixels.temoins: %d\n"
                + "lecture.ms: %.3f\npreparation.ms: %.3f\ntrace.ms: %.3f\nrayons.par.seconde: %d",
                c.primaires, c.ombre, c.reflechis, c.testsSpheres, c.testsPrecis, c.noeudsVisites, c.examensEssais,
                c.pixelsRaffines, c.pixelsTemoins, lectureNs / NS_PAR_MS, preparationNs / NS_PAR_MS, trace / NS_PAR_MS,
                Math.round(c.rayons() / (Math.max(trace, 1) / 1e9)));
    }

    /** La médiane de la seconde moitié : au début, la machine virtuelle compile encore. */
    private static double mediane(long[] temps) {
        long[] tries = Arrays.copyOfRange(temps, temps.length / 2, temps.length);
        Arrays.sort(tries);
        return (tries[(tries.length - 1) / 2] + tries[tries.length / 2]) / 2.0;
    }
}
