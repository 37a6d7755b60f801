package lancer.mesures.vitesse;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lancer.mesures.Intervalle;

/**
 * Des temps pris tour à tour, ceux de la référence et ceux de ce qui lui est comparé : ce que l'on en garde est leur rapport, manche par
 * manche. Une manche est jetée si {@link Etalon} est troublé juste avant ou juste après, ou si l'un des deux dessins n'a pas eu, par
 * seconde, {@value #PART_MIN} du temps des processeurs qu'il a d'ordinaire : la médiane de ses manches.
 *
 * <p>Combien en garder est décidé avant la première : s'arrêter quand l'intervalle plaît le rendrait trop étroit.
 */
final class Manches {

    static final double PART_MIN = 0.8;

    /** Nombre de manches au-delà duquel, si la moitié en sont jetées, la machine n'est pas à nous. */
    private static final int ESSAIS = 100;

    /** Deux manches d'une minute jetées sur deux ne disent pas que toutes le seraient. */
    private static final int ESSAIS_MIN = 4;
    private static final long PATIENCE_NS = TimeUnit.SECONDS.toNanos(60);

    private final BooleanSupplier etalon;
    private final boolean agitee;
    private int toutes;
    private int jetees;

    /** Moyen de prendre un temps, autant de fois qu'on veut. */
    interface Echantillon {

        /**
         * Ce que prend un dessin : le temps réel et celui des processeurs, en nanosecondes, puis la mémoire, en octets. Les deux
         * derniers manquent, ou sont NaN, si l'on n'en sait rien.
         */
        double[] prendre() throws IOException;
    }

    /** Grandeurs que prend un dessin. */
    static final int REEL = 0;
    static final int PROCESSEURS = 1;
    static final int MEMOIRE = 2;

    /** Ce que donnent quelques manches. */
    static final class Temps {

        /** De chaque manche gardée : ce qu'a pris la référence, et combien de fois plus a pris la méthode. */
        final List<double[]> references;
        final List<double[]> rapports;
        final int manches;
        final int jetees;

        Temps(List<double[]> references, List<double[]> rapports, int manches, int jetees) {
            this.references = references;
            this.rapports = rapports;
            this.manches = manches;
            this.jetees = jetees;
        }

        private static double[] valeurs(List<double[]> manches, int grandeur) {
            return manches.stream().mapToDouble(m -> grandeur < m.length ? m[grandeur] : Double.NaN).toArray();
        }

        Intervalle rapport(int grandeur) {
            return Intervalle.desRapports(valeurs(rapports, grandeur));
        }

        /** Ce que prend la référence : la médiane. */
        double reference(int grandeur) {
            return Intervalle.desRapports(valeurs(references, grandeur)).valeur;
        }

        /** Un seul rapport, leur moyenne : des manches d'une même machine virtuelle se ressemblent plus que d'une machine à l'autre. */
        Temps enUnRapport() {
            double[] un = IntStream.rangeClosed(REEL, MEMOIRE).mapToDouble(g -> rapport(g).valeur).toArray();
            return new Temps(references, Collections.singletonList(un), manches, jetees);
        }

        /** Ajoute les manches d'une autre machine virtuelle. */
        Temps plus(Temps autre) {
            return new Temps(ensemble(references, autre.references), ensemble(rapports, autre.rapports), manches + autre.manches,
                    jetees + autre.jetees);
        }

        private static List<double[]> ensemble(List<double[]> unes, List<double[]> autres) {
            return Stream.concat(unes.stream(), autres.stream()).collect(Collectors.toList());
        }
    }

    /**
     * @param etalon vrai si la machine est calme
     * @param agitee vrai pour garder toutes les manches : les intervalles diront ce qu'elles valent
     */
    Manches(BooleanSupplier etalon, boolean agitee) {
        this.etalon = etalon;
        this.agitee = agitee;
    }

    /**
     * @param voulues manches à garder
     * @throws IOException si la machine ne nous est pas assez souvent laissée
     */
    Temps mesurer(Echantillon reference, Echantillon methode, int voulues) throws IOException {
        List<double[]> references = new ArrayList<>();
        List<double[]> rapports = new ArrayList<>();
        List<Double> partsReference = new ArrayList<>();
        List<Double> parts = new ArrayList<>();
        long debut = System.nanoTime();
        boolean calme = false;
        int essais = 0;
        while (rapports.size() < voulues) {
            // ce qui a fait jeter la manche d'avant ne fait pas jeter celle-ci s'il a cessé
            calme = calme || etalon.getAsBoolean();
            double[] r = reference.prendre();
            double[] m = methode.prendre();
            boolean garde = partTenue(partsReference, r) & partTenue(parts, m) & calme;
            calme = etalon.getAsBoolean();
            essais++;
            toutes++;
            if (garde && calme || agitee) {
                references.add(r);
                rapports.add(IntStream.range(0, Math.min(r.length, m.length)).mapToDouble(g -> m[g] / r[g]).toArray());
            } else {
                jetees++;
                renoncer(essais, rapports.size(), voulues, System.nanoTime() - debut);
            }
        }
        return new Temps(references, rapports, essais, essais - rapports.size());
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

    /** La machine n'est pas assez à nous. */
    static final class Troublee extends IOException {

        private static final long serialVersionUID = 1;

        Troublee(String raison) {
            super("machine troublée : " + raison + " ; aucun temps n'est changé. Fermez ce qui l'occupe et recommencez ; ou "
                    + "MESURES=--comptes, qui refait le reste sans rien chronométrer");
        }
    }
}
