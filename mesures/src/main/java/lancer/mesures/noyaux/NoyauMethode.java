package lancer.mesures.noyaux;

import java.util.List;
import java.util.concurrent.TimeUnit;
import lancer.Constantes;
import lancer.essai.Formule;
import lancer.mesures.stabilite.Cas;
import lancer.mesures.stabilite.Regime;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Une façon de calculer une distance, sur les rayons d'un régime : la plus petite de huit est gardée, comme dans toute recherche. Chaque
 * méthode est mesurée dans des machines virtuelles à elle, où {@link Formule#distance} n'a qu'elle pour corps, et y est compilée sur place.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(10)
@Warmup(iterations = 3, time = 150, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 40, time = 5, timeUnit = TimeUnit.MILLISECONDS)
public class NoyauMethode {

    /** Rayons d'une boucle ; leurs nombres tiennent dans le cache le plus proche du processeur. */
    static final int RAYONS = 256;

    /** De tant de distances, la plus petite est gardée. */
    static final int ENSEMBLE = 8;
    private static final int VERIFIES = 128;
    private static final int NOMBRES = 10;

    /** Erreur relative qu'aucune méthode, même en {@code float}, n'atteint d'ordinaire loin de la tangente. */
    private static final double PERMISE = 1e-3;

    // JMH les essaie toutes, dans tous les régimes
    @Param
    public Formule formule;

    @Param
    public Regime regime;

    private final double[] cas = new double[NOMBRES * RAYONS];

    /** Tire les rayons, une fois la méthode vérifiée sur les ordinaires. */
    @Setup
    public void tirer() {
        verifier(formule, Regime.ORDINAIRE);
        List<Cas> tires = regime.tirer(RAYONS + RAYONS / 2);
        for (int k = 0; k < RAYONS; k++) {
            tires.get(k).copier(cas, NOMBRES * k);
        }
    }

    /** @throws IllegalStateException si la méthode n'y répond pas juste : son temps ne voudrait rien dire */
    static void verifier(Formule formule, Regime regime) {
        long faux = regime.tirer(VERIFIES).stream().filter(c -> c.malClasse(formule) || c.erreurRelative(formule) > PERMISE).count();
        if (faux > VERIFIES / 100) {
            throw new IllegalStateException(formule + " se trompe sur " + faux + " rayons sur " + VERIFIES + " : aucun temps");
        }
    }

    /** Les plus petites distances, {@value #ENSEMBLE} par {@value #ENSEMBLE}. */
    @Benchmark
    @OperationsPerInvocation(RAYONS)
    public double distance() {
        double somme = 0;
        for (int ensemble = 0; ensemble < cas.length; ensemble += NOMBRES * ENSEMBLE) {
            double distance = Constantes.INFINI;
            for (int k = ensemble; k < ensemble + NOMBRES * ENSEMBLE; k += NOMBRES) {
                double d = formule.distanceAvant(distance, cas[k], cas[k + 1], cas[k + 2], cas[k + 3], cas[k + 4], cas[k + 5],
                        cas[k + 6], cas[k + 7], cas[k + 8], cas[k + 9]);
                if (d < distance) {
                    distance = d;
                }
            }
            somme += distance;
        }
        return somme;
    }
}
