package lancer.sortie;

import java.util.Arrays;
import lancer.contrat.Compteurs;

/**
 * Ce que le programme dit de lui-même après une image : comptes d'un dessin, et temps. Toujours avec un point décimal,
 * sans séparateur de milliers ni exposant, quelle que soit la langue de la machine.
 */
public final class Statistiques {

    private static final double NS_PAR_MS = 1e6;

    private final Compteurs compteurs;
    private final long lectureNs;
    private final long preparationNs;
    private final long[] tracesNs;

    /**
     * @param compteurs ceux d'un dessin
     * @param lectureNs temps de lecture de la scène, en nanosecondes
     * @param preparationNs temps de construction des structures de recherche, en nanosecondes
     * @param tracesNs temps de chaque dessin, dans l'ordre, en nanosecondes
     */
    public Statistiques(Compteurs compteurs, long lectureNs, long preparationNs, long... tracesNs) {
        this.compteurs = compteurs;
        this.lectureNs = lectureNs;
        this.preparationNs = preparationNs;
        this.tracesNs = tracesNs.clone();
    }

    /** Les lignes {@code nom: valeur}, sans fin de ligne après la dernière. */
    @Override
    public String toString() {
        double trace = mediane(tracesNs);
        StringBuilder s = new StringBuilder();
        ligne(s, "rayons.primaires", compteurs.primaires);
        ligne(s, "rayons.ombre", compteurs.ombre);
        ligne(s, "rayons.reflechis", compteurs.reflechis);
        ligne(s, "tests.spheres", compteurs.testsSpheres);
        ligne(s, "tests.precis", compteurs.testsPrecis);
        ligne(s, "noeuds.visites", compteurs.noeudsVisites);
        ligne(s, "pixels.raffines", compteurs.pixelsRaffines);
        ligne(s, "pixels.temoins", compteurs.pixelsTemoins);
        millisecondes(s, "lecture.ms", lectureNs);
        millisecondes(s, "preparation.ms", preparationNs);
        millisecondes(s, "trace.ms", trace);
        ligne(s, "rayons.par.seconde", Math.round(compteurs.rayons() / (Math.max(trace, 1) / 1e9)));
        return s.substring(0, s.length() - 1);
    }

    /** La médiane de la seconde moitié : au début, la machine virtuelle compile encore. */
    static double mediane(long[] temps) {
        long[] tries = Arrays.copyOfRange(temps, temps.length / 2, temps.length);
        Arrays.sort(tries);
        int milieu = tries.length / 2;
        return tries.length % 2 == 1 ? tries[milieu] : (tries[milieu - 1] + tries[milieu]) / 2.0;
    }

    private static void ligne(StringBuilder s, String nom, long valeur) {
        s.append(nom).append(": ").append(valeur).append('\n');
    }

    private static void millisecondes(StringBuilder s, String nom, double ns) {
        long millieme = Math.round(ns / NS_PAR_MS * 1000);
        String decimales = String.valueOf(1000 + millieme % 1000).substring(1);
        s.append(nom).append(": ").append(millieme / 1000).append('.').append(decimales).append('\n');
    }
}
