package lancer.mesures.noyaux;

import java.util.Random;
import java.util.concurrent.TimeUnit;
import lancer.Constantes;
import lancer.Sphere;
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
 * L'équation du cours, une sphère à la fois : {@link Sphere#distance}. Un même rayon passe devant toutes les sphères et garde
 * la plus petite distance, comme dans toute recherche ; le temps est celui d'une sphère.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 5, time = 500, timeUnit = TimeUnit.MILLISECONDS)
public class NoyauIntersection {

    /** Sphères d'une boucle ; leurs nombres tiennent dans le cache le plus proche du processeur. */
    static final int SPHERES = 512;

    /** Écart à l'axe du rayon, en rayons de la sphère : dedans, touchée ou manquée, sans jamais être tangente. */
    private static final double ECART_TOUCHE = 0.9;
    private static final double ECART_MANQUE = 1.1;

    private static final long GRAINE = 1234;

    /** Le rayon part-il vers la sphère, à côté d'elle, ou de l'intérieur ? */
    @Param({"touche", "manque", "dedans"})
    public String cas;

    /** Centre et rayon de chaque sphère, à la suite. */
    private final double[] spheres = new double[4 * SPHERES];

    /** Le rayon va de l'origine vers les z croissants. */
    @Setup
    public void semer() {
        Random hasard = new Random(GRAINE);
        for (int s = 0; s < spheres.length; s += 4) {
            double r = 0.5 + hasard.nextDouble();
            double angle = 2 * Math.PI * hasard.nextDouble();
            double ecart = r * (cas.equals("manque") ? ECART_MANQUE + hasard.nextDouble() : ECART_TOUCHE * hasard.nextDouble());
            spheres[s] = ecart * Math.cos(angle);
            spheres[s + 1] = ecart * Math.sin(angle);
            // à 0,3 rayon de l'origine, avec un écart d'au plus 0,9 rayon : l'origine est dedans
            spheres[s + 2] = cas.equals("dedans") ? r * 0.3 : r + 2 + 10 * hasard.nextDouble();
            spheres[s + 3] = r;
        }
    }

    /** La plus petite distance, +∞ si le rayon ne touche rien. */
    @Benchmark
    @OperationsPerInvocation(SPHERES)
    public double distance() {
        double distance = Constantes.INFINI;
        for (int s = 0; s < spheres.length; s += 4) {
            double d = Sphere.distance(0, 0, 0, 0, 0, 1, spheres[s], spheres[s + 1], spheres[s + 2], spheres[s + 3]);
            if (d < distance) {
                distance = d;
            }
        }
        return distance;
    }

    /** Sphères que touche le rayon. */
    int touchees() {
        int touchees = 0;
        for (int s = 0; s < spheres.length; s += 4) {
            touchees += Sphere.distance(0, 0, 0, 0, 0, 1, spheres[s], spheres[s + 1], spheres[s + 2], spheres[s + 3])
                    < Constantes.INFINI ? 1 : 0;
        }
        return touchees;
    }

    /** Sphères qui contiennent le départ du rayon. */
    int autourDuDepart() {
        int autour = 0;
        for (int s = 0; s < spheres.length; s += 4) {
            autour += spheres[s] * spheres[s] + spheres[s + 1] * spheres[s + 1] + spheres[s + 2] * spheres[s + 2]
                    < spheres[s + 3] * spheres[s + 3] ? 1 : 0;
        }
        return autour;
    }
}
