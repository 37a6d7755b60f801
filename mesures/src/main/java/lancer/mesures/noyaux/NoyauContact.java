package lancer.mesures.noyaux;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
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
import org.openjdk.jmh.infra.Blackhole;

/**
 * L'éclairement d'un contact par deux lampes, {@link Objet3D#getColor}, sans ombre ni reflet : Lambert, Phong, et les vecteurs
 * qu'il leur faut.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 5, time = 500, timeUnit = TimeUnit.MILLISECONDS)
public class NoyauContact {

    /** Contacts éclairés à la suite. */
    static final int CONTACTS = 512;

    private static final long GRAINE = 1234;

    /** Le poli : entier, la puissance se fait par carrés ; sinon par {@link Math#pow}. */
    @Param({"40", "40.5"})
    public double ns;

    private final Sphere sphere = new Sphere(new Point(0, 0, 10), 1);
    private final Rayon[] rayons = new Rayon[CONTACTS];
    private final PointContact[] contacts = new PointContact[CONTACTS];
    private Scene scene;

    @Setup
    public void preparer() {
        sphere.setKd(new Couleur(0.6, 0.5, 0.4));
        sphere.setKs(new Couleur(0.3));
        sphere.setNs(ns);
        List<Lampe> lampes = Arrays.asList(new Lampe(new Point(-40, 60, -50), new Couleur(1, 0.95, 0.86)),
                new Lampe(new Point(50, 20, -20), new Couleur(0.35, 0.4, 0.5)));
        scene = new Scene(Collections.singletonList(sphere), lampes);
        scene.setRecherche(new SansObstacle());
        Random hasard = new Random(GRAINE);
        for (int k = 0; k < CONTACTS; k++) {
            Point vise = new Point(1.3 * hasard.nextDouble() - 0.65, 1.3 * hasard.nextDouble() - 0.65, 10);
            rayons[k] = new Rayon(new Point(0, 0, 0), vise);
            sphere.getIntersectionDistance(rayons[k]);
            contacts[k] = rayons[k].calcContact();
        }
    }

    /** La couleur de chaque contact. */
    @Benchmark
    @OperationsPerInvocation(CONTACTS)
    public void couleur(Blackhole puits) {
        for (int k = 0; k < CONTACTS; k++) {
            puits.consume(couleur(k));
        }
    }

    Couleur couleur(int k) {
        return sphere.getColor(scene, rayons[k], contacts[k], 0);
    }

    /** Rien ne cache jamais rien : ce qui reste est l'éclairement seul. */
    private static final class SansObstacle implements Recherche {

        @Override
        public void plusProche(Rayon incident, Objet3D saufLui) {
            incident.setContact(null, Double.POSITIVE_INFINITY);
        }

        @Override
        public boolean estCachee(Lampe lampe, Point P, Vecteur V, double distance, Objet3D objet) {
            return false;
        }

        @Override
        public Recherche pourUnFil(Compteurs compteurs) {
            return this;
        }
    }
}
