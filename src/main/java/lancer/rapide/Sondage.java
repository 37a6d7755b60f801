package lancer.rapide;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleConsumer;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Modele;
import lancer.contrat.Recherche;
import lancer.precision.Intersection;

/**
 * Vérification, avant le dessin, de ce que la recherche rapide suppose des classes du cours. {@link Rayon} rend le
 * départ et la direction qu'il a reçus. Chaque sphère rend, et note dans le rayon, la distance que calcule
 * {@link Intersection}. Les boucles et la recherche donnent le même contact. Tout est comparé au bit près.
 *
 * <p>Cette vérification est un sondage : {@value #RAYONS} rayons, {@value #SPHERES} sphères au plus. Une faute qui ne
 * change la réponse d'aucun de ces rayons n'est pas vue. Les rayons dépendent de la scène et de la taille.
 */
public final class Sondage {

    private static final String SUITE = " : ce sont les boucles du cours qui dessinent";
    static final int RAYONS = 240;
    static final int SPHERES = 64;

    /** Les sphères choisies, dans l'ordre de la scène, et leur copie. */
    private final List<Objet3D> tirees = new ArrayList<>();
    private final Spheres plates;
    /** La scène des sphères choisies, avec les boucles du cours, puis avec la recherche rapide. */
    private final Scene boucles;
    private final Scene rapide;

    /** Première différence, {@code null} tant qu'il n'y en a pas. */
    private String ecart;

    private Sondage(Scene scene, RechercheRapide recherche) {
        Spheres toutes = recherche.structures.spheres;
        for (long k = 0, m = Math.min(SPHERES, toutes.nombre); k < m; k++) {
            tirees.add(toutes.objets[(int) ((2 * k + 1) * toutes.nombre / (2 * m))]);
        }
        boolean entiere = tirees.size() == scene.getObjets().size();
        plates = entiere ? toutes : new Spheres(tirees);
        boucles = new Scene(tirees, scene.getLampes());
        rapide = boucles.avec(new Modele());
        rapide.getModele().setRecherche(entiere ? recherche.pourUnFil(rapide.getCompteurs())
                : new RechercheRapide(new Structures(plates, scene.getLampes()), rapide.getCompteurs()));
    }

    /** Choisit la recherche de la scène. @return la raison de son refus par le sondage ; {@code null} sans refus */
    public static String choisir(Scene scene, Camera camera, boolean simple, DoubleConsumer suivi) {
        RechercheRapide recherche = simple || !Preparation.estUtile(scene, camera) ? null
                : Preparation.pour(scene, camera, suivi);
        String ecart = recherche == null ? null : ecart(scene, camera, recherche);
        scene.getModele().setRecherche(ecart == null ? recherche : null);
        return ecart;
    }

    /**
     * Sonde cette scène et sa recherche.
     *
     * @return la première différence, en une phrase ; {@code null} s'il n'y en a pas
     * @throws CancellationException si le fil appelant est interrompu
     */
    public static String ecart(Scene scene, Camera camera, RechercheRapide recherche) {
        try {
            Sondage sondage = new Sondage(scene, recherche);
            Random hasard = new Random(31L * (31 * Arrays.hashCode(sondage.plates.geometrie) + camera.getLargeur())
                    + camera.getHauteur());
            for (int k = 0; k < RAYONS && !sondage.tirees.isEmpty() && sondage.ecart == null; k++) {
                Recherche.obeir();
                sondage.tirer(k, hasard, camera, scene.getLampes());
            }
            return sondage.ecart == null ? null : sondage.ecart + SUITE;
        } catch (CancellationException | OutOfMemoryError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            // le dessin nommera le pixel qui échoue
            return "une classe du cours échoue sur un rayon tiré au hasard" + SUITE;
        }
    }

    /** Essaie tour à tour un rayon de l'écran, un rayon d'une lampe vers une sphère, un rayon qui part d'une sphère. */
    private void tirer(int k, Random hasard, Camera camera, List<Lampe> lampes) {
        int s = hasard.nextInt(tirees.size());
        int g = Spheres.PAS * s;
        Point surface = new Point(plates.geometrie[g], plates.geometrie[g + 1], plates.geometrie[g + 2])
                .add(plates.geometrie[g + 3], direction(hasard));
        if (k % 3 == 0) {
            Rayon rayon = camera.getRayon(camera.getLargeur() * hasard.nextDouble(),
                    camera.getHauteur() * hasard.nextDouble());
            rencontrer(rayon.getP(), rayon.getV(), null);
        } else if (k % 3 == 1 && !lampes.isEmpty()) {
            Lampe lampe = lampes.get(hasard.nextInt(lampes.size()));
            Vecteur versLampe = new Vecteur(surface, lampe.getPosition());
            if (versLampe.norme() > 0) {
                Vecteur L = versLampe.normalized();
                demander(lampe.getPosition(), L.neg());
                exiger(boucles.estCachee(lampe, surface, L, versLampe.norme(), tirees.get(s))
                        == rapide.estCachee(lampe, surface, L, versLampe.norme(), tirees.get(s)), "Scene.estCachee");
            }
        } else {
            rencontrer(surface, direction(hasard), tirees.get(s));
        }
    }

    private static Vecteur direction(Random hasard) {
        return new Vecteur(2 * hasard.nextDouble() - 1, 2 * hasard.nextDouble() - 1, 2 * hasard.nextDouble() - 1)
                .normalized();
    }

    private void rencontrer(Point P, Vecteur V, Objet3D saufLui) {
        demander(P, V);
        Rayon un = Rayon.dOmbre(P, V);
        Rayon autre = Rayon.dOmbre(P, V);
        boucles.getClosestIntersection(un, saufLui);
        rapide.getClosestIntersection(autre, saufLui);
        exiger(un.getObjet() == autre.getObjet() && Double.compare(un.getDistance(), autre.getDistance()) == 0,
                "Scene.getClosestIntersection");
    }

    /** Compare la réponse de chaque sphère choisie. */
    private void demander(Point P, Vecteur V) {
        double[] g = plates.geometrie;
        Rayon rayon = Rayon.dOmbre(P, V);
        exiger(P.equals(rayon.getP()) && V.equals(rayon.getV()),
                "Rayon, sur son départ et sa direction,");
        for (int k = 0, s = 0; k < tirees.size(); k++, s += Spheres.PAS) {
            double d = Intersection.distance(P.x, P.y, P.z, V.x, V.y, V.z, g[s], g[s + 1], g[s + 2], g[s + 3]);
            exiger(Double.compare(d, tirees.get(k).getIntersectionDistance(rayon)) == 0
                    && Double.compare(d, rayon.getDistance()) == 0
                    && rayon.getObjet() == (d == Double.POSITIVE_INFINITY ? null : tirees.get(k)),
                    "Sphere.getIntersectionDistance");
        }
    }

    private void exiger(boolean juste, String qui) {
        if (!juste && ecart == null) {
            ecart = qui + " ne répond pas comme la recherche rapide";
        }
    }
}
