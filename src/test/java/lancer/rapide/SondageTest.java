package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.HashMap;
import java.util.Map;
import lancer.Camera;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.contrat.Compteurs;
import org.junit.jupiter.api.Test;

/** Un sondage voit une recherche qui ne répond pas comme les classes du cours, et les boucles du cours dessinent alors. */
class SondageTest {

    private static final Camera CAMERA = new Camera(97, 61);

    private static Scene rapide(Scene scene, Camera camera) {
        scene.getModele().setRecherche(Preparation.pour(scene, camera, part -> { }));
        return scene;
    }

    /** Ce que voit le sondage d'une scène dont la recopie, ou ce qui en est fait, a les rayons multipliés par cette part. */
    private static String sonder(Scene scene, double part) {
        Spheres plates = new Spheres(scene.getObjets());
        for (int k = 0; k < plates.nombre; k++) {
            plates.geometrie[Spheres.PAS * k + 3] *= part;
        }
        assertEquals(part == 1, Sondage.avant(plates) == null, "avant le dessin déjà");
        scene.getModele().setRecherche(new RechercheRapide(new Structures(plates, scene.getLampes()), new Compteurs()));
        return Sondage.ecart(scene, plates, CAMERA);
    }

    private static String ecart(Scene scene) {
        RechercheRapide recherche = (RechercheRapide) scene.getModele().getRecherche();
        recherche.differe(scene, CAMERA);
        return recherche.getEcart();
    }

    @Test
    void uneRechercheJusteNAAucunEcart() {
        Map<String, Scene> scenes = new HashMap<>(ScenesDEssai.toutes(60));
        scenes.putAll(ScenesDEssai.extremes(60));
        scenes.putAll(ScenesDEssai.hostiles(1000));
        scenes.forEach((nom, scene) -> {
            for (Preparation.Genre genre : Preparation.Genre.values()) {
                scene.getModele().setRecherche(Preparation.pour(scene, CAMERA, genre, part -> { }));
                assertNull(ecart(scene), nom);
            }
        });
    }

    @Test
    void uneEquationChangeeSeVoit() {
        ScenesDEssai.toutes(60).forEach((nom, scene) -> {
            Spheres spheres = new Spheres(scene.getObjets());
            if (spheres.nombre > 0 && spheres.autres.length == 0) {
                assertEquals("Sphere.getIntersectionDistance ne répond pas comme la recherche rapide", sonder(scene, 0.98), nom);
            }
        });
    }

    @Test
    void unEcartDUnDernierChiffreSeVoit() {
        assertNotNull(sonder(ScenesDEssai.foule(3, 40, 0).scene(), 1 + 0x1p-52));
        assertNull(sonder(ScenesDEssai.foule(3, 40, 0).scene(), 1));
    }

    /** Un rayon qui ne part pas d'où partent ceux d'un masque, ou va ailleurs, reçoit quand même la réponse des boucles. */
    @Test
    void unRayonDeplaceOuTorduALaReponseDesBoucles() {
        for (Map.Entry<String, Scene> e : ScenesDEssai.toutes(60).entrySet()) {
            Scene scene = rapide(e.getValue(), CAMERA);
            Scene boucles = new Scene(scene.getObjets(), scene.getLampes());
            java.util.Random hasard = new java.util.Random(5);
            for (int k = 0; k < 5000; k++) {
                Point ailleurs = new Point(hasard.nextGaussian(), hasard.nextGaussian(), k % 3 == 0 ? 0 : 4 * hasard.nextGaussian());
                Rayon rayon = new Rayon(ailleurs,
                        new Point(3 * hasard.nextGaussian(), 3 * hasard.nextGaussian(), 6 + hasard.nextGaussian()));
                Objet3D depart = k % 2 == 0 || scene.getObjets().isEmpty() ? null : scene.getObjets().get(k % scene.getObjets().size());
                scene.getClosestIntersection(rayon, depart);
                double distance = rayon.getDistance();
                Objet3D objet = rayon.getObjet();
                boucles.getClosestIntersection(rayon, depart);
                assertEquals(rayon.getDistance(), distance, e.getKey() + ", rayon " + k);
                assertEquals(rayon.getObjet(), objet, e.getKey() + ", rayon " + k);
                for (Lampe lampe : scene.getLampes()) {
                    if (depart != null) {
                        assertEquals(boucles.estCachee(lampe, ailleurs, rayon.getV(), 5, depart),
                                scene.estCachee(lampe, ailleurs, rayon.getV(), 5, depart),
                                e.getKey() + ", ombre " + k);
                    }
                }
            }
        }
    }
}
