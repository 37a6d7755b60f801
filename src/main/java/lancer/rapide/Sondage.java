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

/**
 * Comparaison des réponses de la recherche rapide avec celles des classes du cours, au bit près : la distance de
 * quelques sphères avant un dessin, les boucles de la scène dessinée après lui. Les rayons sont tirés au hasard : de
 * l'écran, d'une lampe à travers une sphère, d'une sphère vers une autre.
 *
 * <p>C'est un sondage : après le dessin, {@value #RAYONS} rayons au plus, et moins si la scène a beaucoup d'objets. Une
 * faute qui ne change la réponse d'aucun de ces rayons n'est pas vue. Les rayons dépendent de la scène et de la taille.
 */
final class Sondage {

    static final int RAYONS = 600;

    /** Nombre d'intersections que les boucles calculent, à peu près ; nombre minimal de rayons. */
    private static final int EXAMENS = 1 << 18;
    private static final int RAYONS_MIN = 6;

    /** Nombre de rayons, et de sphères interrogées par rayon, avant un dessin. */
    private static final int RAYONS_AVANT = 100;
    private static final int SPHERES_AVANT = 16;

    private static final String DISTANCE = "Sphere.getIntersectionDistance ne répond pas comme la recherche rapide";

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
     * Compare, avant un dessin, la distance que donnent quelques sphères à celle que donne leur copie.
     *
     * @return la différence, en une phrase ; {@code null} s'il n'y en a pas
     */
    static String avant(Spheres spheres) {
        Random hasard = new Random(1);
        try {
            for (int k = 0; k < RAYONS_AVANT && spheres.nombre > 0; k++) {
                int s = hasard.nextInt(spheres.nombre);
                // de la surface, ou d'un point au hasard
                Point P = dans(spheres, s, k % 2 == 0 ? 1 : 4 * hasard.nextDouble(), hasard);
                Vecteur V = new Vecteur(P, dans(spheres, hasard.nextInt(spheres.nombre), hasard.nextDouble(), hasard));
                for (int j = 0; j < Math.min(SPHERES_AVANT, spheres.nombre) && V.norme() > 0; j++) {
                    if (!spheres.repond((s + j) % spheres.nombre, P, V.normalized())) {
                        return DISTANCE;
                    }
                }
            }
        } catch (RuntimeException | Error e) {
            // le dessin nommera le pixel qui échoue
        }
        return null;
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
                Recherche.obeir();
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
            Vecteur V = new Vecteur(lampe.getPosition(), dans(spheres, s, hasard.nextDouble(), hasard));
            if (V.norme() > 0) {
                PointContact devant = suivre(lampe.getPosition(), V.normalized(), null);
                eclairer(lampe, devant == null ? null : suivre(devant, V.normalized(), devant.objet));
            }
        } else {
            Point depart = dans(spheres, s, 1, hasard);
            Vecteur V = new Vecteur(depart, dans(spheres, hasard.nextInt(spheres.nombre), hasard.nextDouble(), hasard));
            if (V.norme() > 0) {
                eclairer(lampe, suivre(depart, V.normalized(), spheres.objets[s]));
            }
        }
    }

    /** Un point au hasard de la sphère s, à cette part du rayon. */
    private static Point dans(Spheres spheres, int s, double part, Random hasard) {
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
            ecart = qui + " ne répond pas comme la recherche rapide";
            for (int k = 0; k < spheres.nombre; k++) {
                if (!spheres.repond(k, P, V)) {
                    ecart = DISTANCE;
                }
            }
        }
    }
}
