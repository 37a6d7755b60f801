package lancer.rapide;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.concurrent.CancellationException;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.contrat.RechercheSimple;
import lancer.precision.Intersection;

/**
 * Ce qu'une recherche tient pour acquis des classes du cours, demandé avant de dessiner : {@link Rayon} rend le départ
 * et la direction qu'il a reçus ; chaque sphère répond, et note dans le rayon, ce que donne {@link Intersection} ; les
 * boucles du cours et la recherche répondent de même. Tout se compare au bit près.
 *
 * <p>C'est un sondage : {@value #RAYONS} rayons, {@value #SPHERES} sphères au plus. Une faute qui ne change la réponse
 * d'aucun de ces rayons n'est pas vue. Le tirage suit la scène et la taille de l'image.
 */
final class Sondage {

    static final int RAYONS = 240;
    static final int SPHERES = 64;

    private static final String SUITE = " : ce sont les boucles du cours qui dessinent";
    private static final String REPONSE = " comme la recherche rapide" + SUITE;

    private final List<Lampe> lampes;
    private final Camera camera;
    /** Les sphères tirées, dans l'ordre de la scène, et leur recopie. */
    private final List<Objet3D> tirees = new ArrayList<>();
    private final Spheres plates;
    private final Recherche boucles;
    private final Recherche rapide;
    private final Random hasard;

    /** Première différence, {@code null} tant qu'il n'y en a pas. */
    private String ecart;

    private Sondage(Scene scene, Camera camera, Structures structures) {
        this.camera = camera;
        lampes = scene.getLampes();
        Spheres toutes = structures.spheres;
        int m = Math.min(SPHERES, toutes.nombre);
        int graine = Objects.hash(camera.getLargeur(), camera.getHauteur(), toutes.nombre);
        for (int k = 0; k < m; k++) {
            int tiree = (int) ((2L * k + 1) * toutes.nombre / (2 * m));
            tirees.add(toutes.objets[tiree]);
            for (int s = Spheres.PAS * tiree; s < Spheres.PAS * (tiree + 1); s++) {
                graine = 31 * graine + Double.hashCode(toutes.geometrie[s]);
            }
        }
        hasard = new Random(graine);
        boolean entiere = m == scene.getObjets().size();
        plates = entiere ? toutes : new Spheres(tirees);
        boucles = new RechercheSimple(tirees, new Compteurs());
        rapide = new RechercheRapide(entiere ? structures : new Structures(plates, lampes), tirees, new Compteurs());
    }

    /**
     * Sonde cette scène ainsi préparée.
     *
     * @return ce qui diffère, en une phrase ; {@code null} si rien
     * @throws CancellationException si le fil appelant est interrompu
     */
    static String ecart(Scene scene, Camera camera, Structures structures) {
        try {
            Sondage sondage = new Sondage(scene, camera, structures);
            for (int k = 0; k < RAYONS && !sondage.tirees.isEmpty() && sondage.ecart == null; k++) {
                Recherche.obeir();
                sondage.tirer(k);
            }
            return sondage.ecart;
        } catch (CancellationException | OutOfMemoryError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            // une classe du cours échoue : le dessin nommera le pixel
            return "une classe du cours échoue sur un rayon tiré au hasard" + SUITE;
        }
    }

    /** Un rayon de l'écran, un d'une lampe vers une sphère, un d'une sphère, tour à tour. */
    private void tirer(int k) {
        int s = hasard.nextInt(tirees.size());
        Objet3D sphere = tirees.get(s);
        if (k % 3 == 0) {
            Rayon rayon = camera.getRayon(camera.getLargeur() * hasard.nextDouble(),
                    camera.getHauteur() * hasard.nextDouble());
            rencontrer(rayon.getP(), rayon.getV(), null);
        } else if (k % 3 == 1 && !lampes.isEmpty()) {
            Lampe lampe = lampes.get(hasard.nextInt(lampes.size()));
            Vecteur versLaSphere = new Vecteur(lampe.getPosition(), surface(s));
            if (versLaSphere.norme() > 0) {
                cacher(lampe, versLaSphere.normalized(), versLaSphere.norme(), sphere);
            }
        } else {
            rencontrer(surface(s), direction(), sphere);
        }
    }

    private Vecteur direction() {
        return new Vecteur(2 * hasard.nextDouble() - 1, 2 * hasard.nextDouble() - 1, 2 * hasard.nextDouble() - 1)
                .normalized();
    }

    /** Un point au hasard de la sphère de ce numéro. */
    private Point surface(int k) {
        double[] g = plates.geometrie;
        int s = Spheres.PAS * k;
        return new Point(g[s], g[s + 1], g[s + 2]).add(g[s + 3], direction());
    }

    private void rencontrer(Point P, Vecteur V, Objet3D saufLui) {
        demander(P, V);
        Rayon un = Rayon.dOmbre(P, V);
        Rayon autre = Rayon.dOmbre(P, V);
        boucles.plusProche(un, saufLui);
        rapide.plusProche(autre, saufLui);
        exiger(un.getObjet() == autre.getObjet() && sontEgaux(un.getDistance(), autre.getDistance()),
                "les boucles du cours, sur le premier objet d'un rayon, ne répondent pas");
    }

    private void cacher(Lampe lampe, Vecteur V, double distance, Objet3D objet) {
        Point P = lampe.getPosition();
        demander(P, V);
        exiger(boucles.estCachee(lampe, P, V, distance, objet) == rapide.estCachee(lampe, P, V, distance, objet),
                "les boucles du cours, sur une lampe cachée, ne répondent pas");
    }

    /** Demande ce rayon à chaque sphère tirée. */
    private void demander(Point P, Vecteur V) {
        double[] g = plates.geometrie;
        Rayon rayon = Rayon.dOmbre(P, V);
        Point p = rayon.getP();
        Vecteur v = rayon.getV();
        exiger(sontEgaux(P.x, p.x) && sontEgaux(P.y, p.y) && sontEgaux(P.z, p.z)
                && sontEgaux(V.x, v.x) && sontEgaux(V.y, v.y) && sontEgaux(V.z, v.z),
                "Rayon rend un autre départ ou une autre direction que les siens, et ne répond pas");
        for (int k = 0; k < tirees.size(); k++) {
            int s = Spheres.PAS * k;
            double d = Intersection.distance(P.x, P.y, P.z, V.x, V.y, V.z, g[s], g[s + 1], g[s + 2], g[s + 3]);
            exiger(sontEgaux(d, tirees.get(k).getIntersectionDistance(rayon)) && sontEgaux(d, rayon.getDistance())
                    && rayon.getObjet() == (d == Double.POSITIVE_INFINITY ? null : tirees.get(k)),
                    "Sphere.getIntersectionDistance ne répond pas");
        }
    }

    private void exiger(boolean juste, String faute) {
        if (!juste && ecart == null) {
            ecart = faute + REPONSE;
        }
    }

    private static boolean sontEgaux(double a, double b) {
        return Double.doubleToRawLongBits(a) == Double.doubleToRawLongBits(b);
    }
}
