package lancer.mesures.noyaux;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.UnaryOperator;
import lancer.Camera;
import lancer.Constantes;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.mesures.Generateur;
import lancer.mesures.Scenes;
import lancer.temoins.LancerSurveille;
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
 * Les deux questions de {@link Recherche}, posées à une foule de mille boules : le premier objet sur un rayon réfléchi, et
 * « cette lampe est-elle cachée ? ». Les réponses sont d'abord comparées à celles des boucles du cours ; fausses, il n'y a pas de
 * temps.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 5, time = 500, timeUnit = TimeUnit.MILLISECONDS)
public class NoyauRecherche {

    static final int BOULES = 1000;

    /** Rayons posés à la suite, chacun différent du précédent : le processeur ne peut apprendre la réponse. */
    static final int RAYONS = 512;

    private static final long GRAINE = 1234;

    /** Les boucles du cours, ou la recherche du programme. */
    @Param({"simple", "programme"})
    public String recherche;

    private final Rayon[] reflechis = new Rayon[RAYONS];
    private final Objet3D[] departs = new Objet3D[RAYONS];
    private final PointContact[] contacts = new PointContact[RAYONS];
    private final Vecteur[] deLaLampe = new Vecteur[RAYONS];
    private final double[] distances = new double[RAYONS];
    private Lampe lampe;
    private Recherche sienne;

    /** Les contacts que voit l'œil à travers des points tirés au hasard, et le rayon qui se réfléchit sur chacun. */
    @Setup
    public void preparer() throws IOException {
        preparer(UnaryOperator.identity());
    }

    /** @param remplacement ce qui est mesuré à la place de la recherche */
    void preparer(UnaryOperator<Recherche> remplacement) throws IOException {
        Scene scene = foule();
        Recherche simple = new RechercheSimple(scene.getObjets(), new Compteurs());
        LancerSurveille.preparer(scene, Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE, recherche.equals("simple"));
        sienne = remplacement.apply(scene.getRecherche().pourUnFil(new Compteurs()));
        lampe = scene.getLampes().get(0);
        Camera camera = new Camera(Constantes.LARGEUR_IMAGE, Constantes.HAUTEUR_IMAGE);
        Random hasard = new Random(GRAINE);
        int k = 0;
        while (k < RAYONS) {
            Rayon rayon = camera.getRayon(Constantes.LARGEUR_IMAGE * hasard.nextDouble(), Constantes.HAUTEUR_IMAGE * hasard.nextDouble());
            simple.plusProche(rayon, null);
            PointContact contact = rayon.calcContact();
            if (contact == null) {
                continue;
            }
            Vecteur V = rayon.getV();
            Vecteur N = contact.objet.getNormale(contact);
            // sans cette lumière, le programme ne demanderait pas si la lampe est cachée
            if (N.dot(new Vecteur(contact, lampe.getPosition())) > 0) {
                reflechis[k] = new Rayon(contact, V.sub(N.mul(2 * V.dot(N))));
                departs[k] = contact.objet;
                contacts[k] = contact;
                Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
                deLaLampe[k] = versLampe.normalized().neg();
                distances[k] = versLampe.norme();
                k++;
            }
        }
        verifier(simple);
    }

    /**
     * @param cours les boucles du cours
     * @throws IllegalStateException si la recherche à mesurer ne répond pas comme elles
     */
    private void verifier(Recherche cours) {
        for (int k = 0; k < RAYONS; k++) {
            cours.plusProche(reflechis[k], departs[k]);
            double distance = reflechis[k].getDistance();
            Objet3D objet = reflechis[k].getObjet();
            sienne.plusProche(reflechis[k], departs[k]);
            if (reflechis[k].getObjet() != objet || reflechis[k].getDistance() != distance
                    || estCachee(sienne, k) != estCachee(cours, k)) {
                throw new IllegalStateException("la recherche se trompe sur le rayon " + k + " : aucun temps");
            }
        }
    }

    private boolean estCachee(Recherche laquelle, int k) {
        return laquelle.estCachee(lampe, lampe.getPosition(), deLaLampe[k], distances[k], departs[k]);
    }

    private static Scene foule() throws IOException {
        Path fichier = Files.createTempFile("foule", ".ini");
        try {
            try (BufferedWriter sortie = Files.newBufferedWriter(fichier, StandardCharsets.UTF_8)) {
                Generateur.foule(sortie, BOULES, Generateur.GRAINE);
            }
            return Scenes.lire(fichier);
        } finally {
            Files.delete(fichier);
        }
    }

    /** La somme des distances : tous les rayons y comptent. */
    @Benchmark
    @OperationsPerInvocation(RAYONS)
    public double plusProche() {
        double somme = 0;
        for (int k = 0; k < RAYONS; k++) {
            sienne.plusProche(reflechis[k], departs[k]);
            somme += reflechis[k].getDistance();
        }
        return somme;
    }

    /** Le nombre de contacts à l'ombre. */
    @Benchmark
    @OperationsPerInvocation(RAYONS)
    public int estCachee() {
        int cachees = 0;
        for (int k = 0; k < RAYONS; k++) {
            if (estCachee(sienne, k)) {
                cachees++;
            }
        }
        return cachees;
    }
}
