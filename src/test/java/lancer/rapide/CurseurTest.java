package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import lancer.Camera;
import lancer.CameraPlacee;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.essai.Ressources;
import org.junit.jupiter.api.Test;

/** Une recherche ne cache aucun objet qu'un rayon rencontre, d'où qu'il parte, et toute forme bornée s'y trouve comme une sphère. */
class CurseurTest {

    private static final Camera CAMERA = new Camera(97, 61);

    /** Une sphère qui n'est pas de la classe {@link Sphere}, avec ou sans enveloppe. */
    private static final class Bulle extends Objet3D {

        private final Sphere sphere;
        private final boolean bornee;
        private final AtomicInteger demandes = new AtomicInteger();

        Bulle(Sphere sphere, boolean bornee) {
            this.sphere = sphere;
            this.bornee = bornee;
            setMatiere(sphere);
        }

        @Override
        public Sphere getEnveloppe() {
            return bornee ? sphere : null;
        }

        @Override
        public double getIntersectionDistance(Rayon incident) {
            demandes.incrementAndGet();
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
        return new IdentiteTest.Dessin(Structuree.scene(scene, CAMERA), CAMERA, 3, 2);
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
    void chaqueObjetDemandeEstCompte() {
        for (boolean bornees : new boolean[] {true, false}) {
            Scene scene = enBulles(ScenesDEssai.foule(3, 60, 0).scene(), bornees);
            long comptes = dessiner(scene).compteurs.testsSpheres;
            assertEquals(scene.getObjets().stream().mapToLong(bulle -> ((Bulle) bulle).demandes.get()).sum(), comptes);
        }
    }

    @Test
    void unObjetSansEnveloppeEstSoumisATousLesRayons() {
        Scene scene = enBulles(ScenesDEssai.foule(3, 60, 0).scene(), false);
        IdentiteTest.Dessin tous = new IdentiteTest.Dessin(scene, CAMERA, 3, 2);
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
            comparer(nom + ", cellules", scene, Structuree.scene(scene, CAMERA));
            comparer(nom + ", arbre", scene, Structuree.scene(scene, new Camera(1, 1)));
        });
    }

    private static void comparer(String nom, Scene boucles, Scene scene) {
        Random hasard = new Random(5);
        for (int k = 0; k < 2000; k++) {
            Point ailleurs = new Point(hasard.nextGaussian(), hasard.nextGaussian(), k % 3 == 0 ? 0 : 4 * hasard.nextGaussian());
            Vecteur v = new Vecteur(hasard.nextGaussian() / 3, hasard.nextGaussian() / 3, 1).normalized();
            Rayon rayon = Rayon.unitaire(ailleurs, k % 7 == 0 ? v.mul(1.5) : v);
            Objet3D depart = k % 2 == 0 || scene.getObjets().isEmpty() ? null : scene.getObjets().get(k % scene.getObjets().size());
            memeContact(boucles, scene, rayon, depart, nom + ", rayon " + k);
            for (Lampe lampe : scene.getLampes()) {
                if (depart != null) {
                    assertEquals(boucles.estCachee(lampe, ailleurs, rayon.getV(), 5, depart),
                            scene.estCachee(lampe, ailleurs, rayon.getV(), 5, depart), nom + ", ombre " + k);
                }
            }
        }
    }

    /** Les boucles et la recherche donnent à ce rayon le même objet, à la même distance. */
    private static void memeContact(Scene boucles, Scene recherche, Rayon rayon, Objet3D depart, String cas) {
        boucles.getClosestIntersection(rayon, depart);
        double distance = rayon.getDistance();
        Objet3D objet = rayon.getObjet();
        recherche.getClosestIntersection(rayon, depart);
        assertEquals(distance, rayon.getDistance(), cas);
        assertEquals(objet, rayon.getObjet(), cas);
    }

    /** Le même objet, lampe ou départ, ne décide de rien : un objet qui n'est pas de la scène, et une lampe qui n'en est pas. */
    @Test
    void uneLampeOuUnDepartEtrangersALaSceneOntLaReponseDeTousLesObjets() {
        for (int taille : new int[] {12, 60}) {
            Scene scene = ScenesDEssai.foule(9, taille, 0).scene();
            Scene rapide = Structuree.scene(scene, CAMERA);
            Sphere etrangere = new Sphere(new Point(0, 0, 8), 0.1);
            boolean[][] reponses = new boolean[2][400];
            for (int k = 0; k < 400; k++) {
                Random hasard = new Random(k);
                Point contact = new Point(hasard.nextGaussian(), hasard.nextGaussian(), 8 + hasard.nextGaussian());
                Lampe lampe = new Lampe(new Point(4 * hasard.nextGaussian(), 5, -3), new Couleur(1));
                Vecteur L = new Vecteur(contact, lampe.getPosition());
                reponses[0][k] = scene.estCachee(lampe, contact, L.normalized(), L.norme(), etrangere);
                reponses[1][k] = rapide.estCachee(lampe, contact, L.normalized(), L.norme(), etrangere);
            }
            assertArrayEquals(reponses[0], reponses[1]);
        }
    }

    /** L'œil, puis une lampe, entre le départ d'un rayon et une boule. */
    @Test
    void unRayonQuiPasseParLOeilOuParUneLampeALaReponseDeTousLesObjets() {
        List<Objet3D> objets = new ArrayList<>(ScenesDEssai.foule(3, 60, 0).scene().getObjets());
        objets.add(new Sphere(new Point(0, 0, -10), 1));
        Lampe lampe = new Lampe(new Point(0, 0, -8), new Couleur(1));
        Scene boucles = new Scene(objets, List.of(lampe));
        Scene rapide = Structuree.scene(boucles, CAMERA);
        for (double z : new double[] {20, 0, -2, -5, -8, -8.5}) {
            for (Objet3D depart : new Objet3D[] {null, objets.get(0)}) {
                Rayon rayon = new Rayon(new Point(0, 0, z), new Vecteur(0, 0, -1));
                memeContact(boucles, rapide, rayon, depart, "de z = " + z);
                assertTrue(rayon.getDistance() < 30);
            }
        }
    }

    /** Tout y est plus près de l'œil que l'écart permis à un rayon qui en vient ; un rayon de l'écran, lui, en est loin. */
    @Test
    void dansUneSceneMinusculeUnRayonQuiPartDeLOeilALaReponseDeTousLesObjets() {
        Scene boucles = Ressources.deplacee(ScenesDEssai.hostiles(60).get("nuage de boules mêlées"),
                p -> Ressources.fois(p, 1e-24), 1e-24);
        Camera camera = new CameraPlacee(97, 61, new Point(), new Vecteur(0, 0, 1), 60);
        Scene rapide = Structuree.scene(boucles, camera);
        Random hasard = new Random(5);
        for (int k = 0; k < 2000; k++) {
            Vecteur v = new Vecteur(hasard.nextGaussian() / 3, hasard.nextGaussian() / 3, 1);
            memeContact(boucles, rapide, new Rayon(camera.getOeil(), v), null, "rayon " + k);
        }
    }

    /** D'une lampe si lointaine, la foule est dans quelques arrondis d'une direction. */
    @Test
    void deTresLoinUneLampeALesOmbresDeTousLesObjets() {
        Lampe lampe = new Lampe(new Point(1e16, 1.5e16, -1.2e16), new Couleur(1));
        Scene boucles = new Scene(ScenesDEssai.foule(3, 60, 0).scene().getObjets(), List.of(lampe));
        Scene rapide = Structuree.scene(boucles, CAMERA);
        for (Objet3D objet : boucles.getObjets()) {
            Point centre = ((Sphere) objet).getCentre();
            Vecteur L = new Vecteur(centre, lampe.getPosition()).normalized();
            Point contact = centre.add(-1e16, L);
            assertEquals(boucles.estCachee(lampe, contact, L, 3e16, null), rapide.estCachee(lampe, contact, L, 3e16, null));
        }
    }

    /** Là où un cube commence juste au-delà de la sphère unité, un arrondi peut y mettre une direction. */
    @Test
    void uneDirectionUnPeuPlusLongueQueUnVoitAussi() {
        Cellules cellules = Cellules.de(new double[] {0, 0, 1, 0.5}, new int[] {0}, 1e-14, true, 8, 100);
        int cube = cellules.cubeDe(0, 0, 1 + 4e-15);
        assertEquals(1, cellules.debut[cube + 1] - cellules.debut[cube]);
    }

    /** Une question posée pendant une autre ne change ni ses objets, ni sa limite, ni l'objet qui y est à égalité. */
    @Test
    void uneQuestionPoseePendantUneAutreLaisseSaReponse() {
        Scene boucles = ScenesDEssai.toutes(60).get("presque jumelles");
        Recherche rapide = Preparation.recherche(boucles, CAMERA);
        Random hasard = new Random(3);
        for (int k = 0; k < 500; k++) {
            Rayon rayon = CAMERA.getRayon(97 * hasard.nextDouble(), 61 * hasard.nextDouble());
            Rayon attendu = Rayon.unitaire(rayon.getP(), rayon.getV());
            boucles.getClosestIntersection(attendu);
            Objet3D plusProche = null;
            double distance = Double.POSITIVE_INFINITY;
            for (Objet3D objet : rapide.candidats(rayon, null, distance)) {
                double d = objet.getIntersectionDistance(rayon);
                Rayon autre = CAMERA.getRayon(k % 97, 30);
                rapide.candidats(autre, null, Double.POSITIVE_INFINITY).forEach(o -> o.getIntersectionDistance(autre));
                if (d < distance) {
                    plusProche = objet;
                    distance = d;
                    rapide.limiter(distance);
                }
            }
            assertEquals(attendu.getDistance(), distance);
            assertEquals(attendu.getObjet(), rapide.aEgalite(plusProche));
        }
    }

    /** Deux questions qui avancent ensemble : ce qui limite l'une ne limite pas l'autre. */
    @Test
    void deuxQuestionsMeneesDeFrontOntChacuneLeurLimite() {
        Scene boucles = ScenesDEssai.toutes(60).get("presque jumelles");
        Recherche rapide = Preparation.recherche(boucles, CAMERA);
        Random hasard = new Random(3);
        for (int k = 0; k < 500; k++) {
            Rayon[] rayons = new Rayon[2];
            double[] distances = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
            List<Iterator<Objet3D>> questions = new ArrayList<>();
            for (int i = 0; i < 2; i++) {
                rayons[i] = CAMERA.getRayon(97 * hasard.nextDouble(), 61 * hasard.nextDouble());
                questions.add(rapide.candidats(rayons[i], null, Double.POSITIVE_INFINITY).iterator());
            }
            boolean[] suite = {true, true};
            while (suite[0] || suite[1]) {
                for (int i = 0; i < 2; i++) {
                    suite[i] = questions.get(i).hasNext();
                }
                for (int i = 0; i < 2; i++) {
                    if (suite[i]) {
                        distances[i] = Math.min(distances[i], questions.get(i).next().getIntersectionDistance(rayons[i]));
                        rapide.limiter(distances[i]);
                    }
                }
            }
            for (int i = 0; i < 2; i++) {
                Rayon attendu = Rayon.unitaire(rayons[i].getP(), rayons[i].getV());
                boucles.getClosestIntersection(attendu);
                assertEquals(attendu.getDistance(), distances[i], "rayon " + k);
            }
        }
    }
}
