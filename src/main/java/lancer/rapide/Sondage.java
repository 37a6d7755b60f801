package lancer.rapide;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import lancer.contrat.Modele;
import lancer.contrat.Recherche;
import lancer.fils.Fil;
import lancer.precision.Intersection;

/**
 * Comparaison, après un dessin, des réponses de la recherche rapide avec celles des boucles de la scène dessinée, au
 * bit près. Les rayons sont tirés au hasard : de l'écran, d'une lampe à travers une sphère, d'une sphère vers une
 * autre.
 *
 * <p>Cette comparaison est un sondage : {@value #RAYONS} rayons au plus, et moins si la scène a beaucoup d'objets. Une
 * faute qui ne change la réponse d'aucun de ces rayons n'est pas vue. Les rayons dépendent de la scène et de la taille.
 */
final class Sondage {

    static final int RAYONS = 600;

    /** Nombre d'intersections que les boucles calculent, à peu près ; nombre minimal de rayons. */
    private static final int EXAMENS = 1 << 18;
    private static final int RAYONS_MIN = 6;

    private final Scene scene;
    private final Modele modele;
    private final Recherche recherche;
    private final Camera camera;
    private final Spheres spheres;
    private final Random hasard;

    /** Première différence, {@code null} tant qu'il n'y en a pas. */
    private String ecart;

    private Sondage(Scene scene, Spheres spheres, Camera camera) {
        this.scene = scene;
        this.camera = camera;
        modele = scene.getModele();
        recherche = modele.getRecherche();
        this.spheres = spheres;
        hasard = new Random(31L * (31 * Arrays.hashCode(spheres.geometrie) + camera.getLargeur())
                + camera.getHauteur());
    }

    /**
     * Sonde cette scène et sa recherche rapide.
     *
     * @param spheres celles que la recherche a copiées
     * @return la première différence, en une phrase ; {@code null} s'il n'y en a pas
     * @throws CancellationException si le fil appelant est interrompu
     */
    static String ecart(Scene dessinee, Spheres spheres, Camera camera) {
        try {
            return new Sondage(dessinee, spheres, camera).sonder();
        } catch (CancellationException | OutOfMemoryError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            // le dessin nommera le pixel qui échoue
            return "une classe du cours échoue sur un rayon tiré au hasard";
        }
    }

    private String sonder() {
        int rayons = Math.max(RAYONS_MIN, Math.min(RAYONS, EXAMENS / Math.max(1, scene.getObjets().size())));
        try {
            for (int k = 0; k < rayons && spheres.nombre > 0 && ecart == null; k++) {
                Fil.avancer();
                tirer(k);
            }
            return ecart;
        } finally {
            modele.setRecherche(recherche);
        }
    }

    private void tirer(int k) {
        // chaque sphère à son tour
        int s = (k / 3 + spheres.nombre / 2) % spheres.nombre;
        List<Lampe> lampes = scene.getLampes();
        Lampe lampe = lampes.isEmpty() ? null : lampes.get(hasard.nextInt(lampes.size()));
        if (k % 3 == 0) {
            Rayon rayon = camera.getRayon(camera.getLargeur() * hasard.nextDouble(),
                    camera.getHauteur() * hasard.nextDouble());
            eclairer(lampe, suivre(rayon.getP(), rayon.getV(), null));
        } else if (k % 3 == 1 && lampe != null) {
            Vecteur V = new Vecteur(lampe.getPosition(), dans(s, hasard.nextDouble()));
            if (V.norme() > 0) {
                PointContact devant = suivre(lampe.getPosition(), V.normalized(), null);
                eclairer(lampe, devant == null ? null : suivre(devant, V.normalized(), devant.objet));
            }
        } else {
            Point depart = dans(s, 1);
            Vecteur V = new Vecteur(depart, dans(hasard.nextInt(spheres.nombre), hasard.nextDouble()));
            if (V.norme() > 0) {
                eclairer(lampe, suivre(depart, V.normalized(), spheres.objets[s]));
            }
        }
    }

    /** Un point au hasard de la sphère s, à cette part du rayon. */
    private Point dans(int s, double part) {
        int g = Spheres.PAS * s;
        Vecteur direction = new Vecteur(hasard.nextGaussian(), hasard.nextGaussian(), hasard.nextGaussian());
        return new Point(spheres.geometrie[g], spheres.geometrie[g + 1], spheres.geometrie[g + 2])
                .add(part * spheres.geometrie[g + 3], direction.normalized());
    }

    /** Compare les contacts de ce rayon. @return celui de la recherche */
    private PointContact suivre(Point P, Vecteur V, Objet3D saufLui) {
        Rayon attendu = Rayon.dOmbre(P, V);
        modele.setRecherche(null);
        long avant = scene.getCompteurs().testsSpheres;
        scene.getClosestIntersection(attendu, saufLui);
        // une boucle qui interroge plus d'objets que la liste n'en donne en connaît un que la recherche ignore
        boolean connus = scene.getCompteurs().testsSpheres - avant <= scene.getObjets().size();
        Rayon rayon = Rayon.dOmbre(P, V);
        modele.setRecherche(recherche);
        PointContact contact = scene.getClosestIntersection(rayon, saufLui);
        boolean pareils = rayon.getObjet() == attendu.getObjet()
                && Double.compare(rayon.getDistance(), attendu.getDistance()) == 0;
        exiger(connus && pareils, "Scene.getClosestIntersection", P, V);
        return contact;
    }

    /** Compare les ombres de cette lampe sur ce contact, s'il lui fait face. */
    private void eclairer(Lampe lampe, PointContact contact) {
        if (lampe != null && contact != null) {
            Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
            if (contact.objet.getNormale(contact).dot(versLampe) > 0) {
                Vecteur L = versLampe.normalized();
                modele.setRecherche(null);
                boolean attendu = scene.estCachee(lampe, contact, L, versLampe.norme(), contact.objet);
                modele.setRecherche(recherche);
                exiger(attendu == scene.estCachee(lampe, contact, L, versLampe.norme(), contact.objet),
                        "Scene.estCachee", lampe.getPosition(), L.neg());
            }
        }
    }

    /** Note la première différence, et l'attribue à la distance d'une sphère si elle en vient. */
    private void exiger(boolean juste, String qui, Point P, Vecteur V) {
        if (!juste && ecart == null) {
            double[] g = spheres.geometrie;
            ecart = qui;
            for (int k = 0, s = 0; k < spheres.nombre; k++, s += Spheres.PAS) {
                double d = Intersection.distance(P.x, P.y, P.z, V.x, V.y, V.z, g[s], g[s + 1], g[s + 2], g[s + 3]);
                if (Double.compare(d, spheres.objets[k].getIntersectionDistance(Rayon.dOmbre(P, V))) != 0) {
                    ecart = "Sphere.getIntersectionDistance";
                }
            }
            ecart += " ne répond pas comme la recherche rapide";
        }
    }
}
