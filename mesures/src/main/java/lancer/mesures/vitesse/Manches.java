package lancer.mesures.vitesse;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import lancer.mesures.Intervalle;

/**
 * Mesure de temps par manches : chaque manche chronomètre la référence, puis la méthode, et garde leur rapport. Une manche est rejetée si
 * {@link Etalon} dit la machine occupée juste avant ou juste après. Elle l'est aussi si un des deux dessins a eu, par seconde, moins de
 * {@value #PART_MIN} de son temps de processeur ordinaire, la médiane de ses manches.
 *
 * <p>Le nombre de manches est fixé avant la première : s'arrêter sur un intervalle favorable le rendrait trop étroit.
 */
final class Manches {

    static final double PART_MIN = 0.8;

    /** Nombre de manches après lequel la mesure est abandonnée si la moitié sont rejetées. */
    private static final int ESSAIS = 100;

    /** Nombre de manches et durée avant lesquels la mesure d'une méthode n'est pas abandonnée. */
    private static final int ESSAIS_MIN = 4;
    private static final long PATIENCE_NS = TimeUnit.SECONDS.toNanos(60);

    private final BooleanSupplier etalon;
    private final boolean agitee;
    private int toutes;
    private int jetees;

    /** Une mesure que l'on peut répéter. */
    interface Echantillon {

        /**
         * Coût d'un dessin : temps réel et temps des processeurs, en nanosecondes, puis mémoire, en octets. Les deux derniers nombres
         * peuvent manquer ou être NaN.
         */
        double[] prendre() throws IOException;
    }

    /** Rangs des nombres d'un coût. */
    static final int REEL = 0;
    static final int PROCESSEURS = 1;
    static final int MEMOIRE = 2;

    /** Résultat de quelques manches. */
    static final class Temps {

        /** Pour chaque manche gardée, coûts de la référence et de la méthode. */
        final List<double[]> references = new ArrayList<>();
        final List<double[]> couts = new ArrayList<>();

        /** Nombre de manches, gardées ou rejetées. */
        int manches;

        int jetees() {
            return manches - couts.size();
        }

        /** Rapport du temps de la méthode à celui de la référence. */
        Intervalle rapport() {
            return Intervalle.desRapports(IntStream.range(0, couts.size())
                    .mapToDouble(k -> couts.get(k)[REEL] / references.get(k)[REEL]).toArray());
        }

        /** Temps réel médian de la référence. */
        double reference() {
            return mediane(references, REEL);
        }

        /** Coût médian de la méthode ; NaN s'il n'est pas connu. */
        double cout(int grandeur) {
            return mediane(couts, grandeur);
        }

        private static double mediane(List<double[]> couts, int grandeur) {
            return Intervalle.mediane(couts.stream().mapToDouble(c -> grandeur < c.length ? c[grandeur] : Double.NaN).toArray());
        }
    }

    /**
     * @param etalon vrai si la machine est disponible
     * @param agitee vrai pour garder toutes les manches, avec des intervalles plus larges
     */
    Manches(BooleanSupplier etalon, boolean agitee) {
        this.etalon = etalon;
        this.agitee = agitee;
    }

    /**
     * @param voulues nombre de manches à garder
     * @throws IOException si la machine n'est pas assez souvent disponible
     */
    Temps mesurer(Echantillon reference, Echantillon methode, int voulues) throws IOException {
        Temps temps = new Temps();
        List<Double> partsReference = new ArrayList<>();
        List<Double> parts = new ArrayList<>();
        long debut = System.nanoTime();
        boolean calme = false;
        while (temps.couts.size() < voulues) {
            // si l'étalon était bon après la manche d'avant, il n'est pas refait
            calme = calme || etalon.getAsBoolean();
            double[] r = reference.prendre();
            double[] m = methode.prendre();
            boolean garde = partTenue(partsReference, r) & partTenue(parts, m) & calme;
            calme = etalon.getAsBoolean();
            temps.manches++;
            toutes++;
            if (garde && calme || agitee) {
                temps.references.add(r);
                temps.couts.add(m);
            } else {
                jetees++;
                renoncer(temps, voulues, System.nanoTime() - debut);
            }
        }
        return temps;
    }

    private static boolean partTenue(List<Double> parts, double[] temps) {
        double part = temps[PROCESSEURS] / temps[REEL];
        parts.add(part);
        Collections.sort(parts);
        return !(part < PART_MIN * parts.get(parts.size() / 2));
    }

    private void renoncer(Temps temps, int voulues, long dureeNs) throws IOException {
        if (toutes >= ESSAIS && 2 * jetees > toutes) {
            throw troublee(jetees + " manches jetées sur " + toutes);
        }
        if (temps.manches >= Math.max(ESSAIS_MIN, 2 * voulues) && dureeNs > PATIENCE_NS) {
            throw troublee(temps.couts.size() + " manches gardées sur " + temps.manches + " en "
                    + TimeUnit.NANOSECONDS.toSeconds(dureeNs) + " s");
        }
    }

    private static IOException troublee(String raison) {
        return new IOException("machine troublée : " + raison + " ; aucun temps n'est changé. Fermez ce qui l'occupe et recommencez ; ou "
                + "MESURES=--comptes, qui refait le reste sans rien chronométrer");
    }
}
