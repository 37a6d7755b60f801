package lancer.mesures.vitesse;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
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

        /** Pour chaque manche gardée, coûts de la référence et de la méthode, et rapport de leurs temps. */
        final List<double[]> references;
        final List<double[]> couts;
        final List<Double> rapports;
        final int manches;
        final int jetees;

        Temps(List<double[]> references, List<double[]> couts, List<Double> rapports, int manches, int jetees) {
            this.references = references;
            this.couts = couts;
            this.rapports = rapports;
            this.manches = manches;
            this.jetees = jetees;
        }

        Intervalle rapport() {
            return Intervalle.desRapports(rapports.stream().mapToDouble(r -> r).toArray());
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
            return Intervalle.desRapports(couts.stream().mapToDouble(c -> grandeur < c.length ? c[grandeur] : Double.NaN).toArray()).valeur;
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
        List<double[]> references = new ArrayList<>();
        List<double[]> couts = new ArrayList<>();
        List<Double> rapports = new ArrayList<>();
        List<Double> partsReference = new ArrayList<>();
        List<Double> parts = new ArrayList<>();
        long debut = System.nanoTime();
        boolean calme = false;
        int essais = 0;
        while (rapports.size() < voulues) {
            // si l'étalon était bon après la manche d'avant, il n'est pas refait
            calme = calme || etalon.getAsBoolean();
            double[] r = reference.prendre();
            double[] m = methode.prendre();
            boolean garde = partTenue(partsReference, r) & partTenue(parts, m) & calme;
            calme = etalon.getAsBoolean();
            essais++;
            toutes++;
            if (garde && calme || agitee) {
                references.add(r);
                couts.add(m);
                rapports.add(m[REEL] / r[REEL]);
            } else {
                jetees++;
                renoncer(essais, rapports.size(), voulues, System.nanoTime() - debut);
            }
        }
        return new Temps(references, couts, rapports, essais, essais - rapports.size());
    }

    private static boolean partTenue(List<Double> parts, double[] temps) {
        double part = temps[PROCESSEURS] / temps[REEL];
        parts.add(part);
        Collections.sort(parts);
        return !(part < PART_MIN * parts.get(parts.size() / 2));
    }

    private void renoncer(int essais, int gardees, int voulues, long dureeNs) throws IOException {
        if (toutes >= ESSAIS && 2 * jetees > toutes) {
            throw new Troublee(jetees + " manches jetées sur " + toutes);
        }
        if (essais >= Math.max(ESSAIS_MIN, 2 * voulues) && dureeNs > PATIENCE_NS) {
            throw new Troublee(gardees + " manches gardées sur " + essais + " en " + TimeUnit.NANOSECONDS.toSeconds(dureeNs) + " s");
        }
    }

    static final class Troublee extends IOException {

        private static final long serialVersionUID = 1;

        Troublee(String raison) {
            super("machine troublée : " + raison + " ; aucun temps n'est changé. Fermez ce qui l'occupe et recommencez ; ou "
                    + "MESURES=--comptes, qui refait le reste sans rien chronométrer");
        }
    }
}
