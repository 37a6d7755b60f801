package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import org.junit.jupiter.api.Test;

/** Une recherche ne cache aucun objet qu'un rayon rencontre, d'où qu'il parte, et toute forme bornée s'y trouve comme une sphère. */
class CurseurTest {

    private static final Camera CAMERA = new Camera(97, 61);

    /** Une sphère qui n'est pas de la classe {@link Sphere}, avec ou sans enveloppe. */
    private static final class Bulle extends Objet3D {

        private final Sphere sphere;
        private final boolean bornee;

        Bulle(Sphere sphere, boolean bornee) {
            this.sphere = sphere;
            this.bornee = bornee;
            setKd(sphere.getKd());
            setKs(sphere.getKs());
            setNs(sphere.getNs());
        }

        @Override
        public Sphere getEnveloppe() {
            return bornee ? sphere : null;
        }

        @Override
        public double getIntersectionDistance(Rayon incident) {
            double d = sphere.getIntersectionDistance(incident);
            incident.setContact(this, d);
            return d;
        }

        @Override
        public Vecteur getNormale(Point contact) {
            return sphere.getNormale(contact);
        }

        @Override
        public Point getPointDeSurface(Point contact, double distance) {
            return sphere.getPointDeSurface(contact, distance);
        }
    }

    private static Scene enBulles(Scene scene, boolean bornees) {
        List<Objet3D> bulles = new ArrayList<>();
        for (Objet3D objet : scene.getObjets()) {
            bulles.add(new Bulle((Sphere) objet, bornees));
        }
        return new Scene(bulles, scene.getLampes());
    }

    private static IdentiteTest.Dessin dessiner(Scene scene) {
        return IdentiteTest.Dessin.de(scene, CAMERA, new Preparation(scene, CAMERA), 3);
    }

    @Test
    void desSpheresEcritesCommeUneFormeNeDemandentPasPlusDExamens() {
        for (int taille : new int[] {30, 1000}) {
            Compteurs spheres = dessiner(ScenesDEssai.foule(3, taille, 0).scene()).compteurs;
            Compteurs bulles = dessiner(enBulles(ScenesDEssai.foule(3, taille, 0).scene(), true)).compteurs;
            assertEquals(spheres.rayons(), bulles.rayons(), taille + " : rayons");
            assertTrue(ComptesTest.cout(bulles) <= 1.5 * ComptesTest.cout(spheres),
                    taille + " : " + ComptesTest.cout(bulles) + " pour " + ComptesTest.cout(spheres));
        }
    }

    @Test
    void unObjetSansEnveloppeEstSoumisATousLesRayons() {
        Scene scene = enBulles(ScenesDEssai.foule(3, 60, 0).scene(), false);
        IdentiteTest.Dessin tous = IdentiteTest.Dessin.de(scene, CAMERA, null, 3);
        IdentiteTest.Dessin cherche = dessiner(scene);
        cherche.verifier("sans enveloppe", tous);
        assertEquals(tous.compteurs.testsSpheres, cherche.compteurs.testsSpheres, tous.compteurs.testsSpheres / 100.0);
    }

    /** Seule la classe Sphere a une enveloppe ; une classe dérivée peut déborder. */
    @Test
    void uneClasseDeriveeDeSphereNAPasDEnveloppe() {
        Sphere boule = new Sphere(new Point(0, 0, 6), 1);
        assertEquals(boule, boule.getEnveloppe());
        assertEquals(null, new Sphere(new Point(), 1) { }.getEnveloppe());
    }

    /** Un rayon qui ne part pas d'où partent ceux d'un masque ou d'une carte, va ailleurs, ou n'est pas de longueur 1. */
    @Test
    void unRayonDeplaceOuTorduALaReponseDeTousLesObjets() {
        Map<String, Scene> scenes = new HashMap<>(ScenesDEssai.toutes(60));
        scenes.putAll(ScenesDEssai.toutes(12));
        scenes.putAll(ScenesDEssai.extremes(60));
        scenes.forEach((nom, scene) -> {
            Preparation preparation = new Preparation(scene, CAMERA);
            Map<String, Recherche> recherches = new HashMap<>();
            recherches.put("cartes", preparation.foule(true));
            recherches.put("arbre", preparation.foule(false));
            if (scene.getObjets().size() <= Long.SIZE) {
                recherches.put("masques", preparation.masques());
            }
            recherches.forEach((sorte, recherche) -> {
                scene.getModele().setRecherche(recherche);
                comparer(nom + ", " + sorte, scene);
            });
        });
    }

    private static void comparer(String nom, Scene scene) {
        Scene boucles = new Scene(scene.getObjets(), scene.getLampes());
        Random hasard = new Random(5);
        for (int k = 0; k < 2000; k++) {
            Point ailleurs = new Point(hasard.nextGaussian(), hasard.nextGaussian(), k % 3 == 0 ? 0 : 4 * hasard.nextGaussian());
            Vecteur v = new Vecteur(hasard.nextGaussian() / 3, hasard.nextGaussian() / 3, 1).normalized();
            Rayon rayon = Rayon.dOmbre(ailleurs, k % 7 == 0 ? v.mul(1.5) : v);
            Objet3D depart = k % 2 == 0 || scene.getObjets().isEmpty() ? null : scene.getObjets().get(k % scene.getObjets().size());
            scene.getClosestIntersection(rayon, depart);
            double distance = rayon.getDistance();
            Objet3D objet = rayon.getObjet();
            boucles.getClosestIntersection(rayon, depart);
            assertEquals(rayon.getDistance(), distance, nom + ", rayon " + k);
            assertEquals(rayon.getObjet(), objet, nom + ", rayon " + k);
            for (Lampe lampe : scene.getLampes()) {
                if (depart != null) {
                    assertEquals(boucles.estCachee(lampe, ailleurs, rayon.getV(), 5, depart),
                            scene.estCachee(lampe, ailleurs, rayon.getV(), 5, depart), nom + ", ombre " + k);
                }
            }
        }
    }

    /** Le même objet, lampe ou départ, ne décide de rien : un objet qui n'est pas de la scène, et une lampe qui n'en est pas. */
    @Test
    void uneLampeOuUnDepartEtrangersALaSceneOntLaReponseDeTousLesObjets() {
        for (int taille : new int[] {12, 60}) {
            Scene scene = ScenesDEssai.foule(9, taille, 0).scene();
            Scene boucles = new Scene(scene.getObjets(), scene.getLampes());
            scene.getModele().setRecherche(new Preparation(scene, CAMERA).pourUnFil(new Compteurs()));
            Sphere etrangere = new Sphere(new Point(0, 0, 8), 0.1);
            boolean[][] reponses = new boolean[2][400];
            for (int k = 0; k < 400; k++) {
                Random hasard = new Random(k);
                Point contact = new Point(hasard.nextGaussian(), hasard.nextGaussian(), 8 + hasard.nextGaussian());
                Lampe lampe = new Lampe(new Point(4 * hasard.nextGaussian(), 5, -3), new lancer.Couleur(1));
                Vecteur L = new Vecteur(contact, lampe.getPosition());
                reponses[0][k] = boucles.estCachee(lampe, contact, L.normalized(), L.norme(), etrangere);
                reponses[1][k] = scene.estCachee(lampe, contact, L.normalized(), L.norme(), etrangere);
            }
            assertArrayEquals(reponses[0], reponses[1]);
        }
    }
}
