package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.contrat.Compteurs;
import lancer.contrat.RechercheSimple;
import lancer.fils.Temoins;
import lancer.fils.Traceur;
import org.junit.jupiter.api.Test;

/** Les pixels témoins voient une recherche qui ne répond pas comme les classes du cours, et les boucles dessinent alors. */
class TemoinsTest {

    private static final Camera CAMERA = new Camera(97, 61);

    private static Scene rapide(Scene scene, Camera camera) {
        scene.getModele().setRecherche(Preparation.pour(scene, camera, part -> { }));
        return scene;
    }

    /** Une sphère dont l'équation a été changée, sous le nom même de la classe du cours : sa recopie à plat, elle, est restée juste. */
    private static Scene modifiee(Scene scene, double part) {
        List<Objet3D> objets = new ArrayList<>(scene.getObjets());
        Scene autre = new Scene(objets, scene.getLampes());
        Spheres plates = new Spheres(autre.getObjets());
        for (int k = 0; k < plates.nombre; k++) {
            plates.geometrie[Spheres.PAS * k + 3] *= part;
        }
        Structures structures = new Structures(plates, autre.getLampes());
        autre.getModele().setRecherche(new RechercheRapide(structures, autre.getObjets(), new Compteurs(), null));
        return autre;
    }

    @Test
    void uneRechercheJusteALeNombreDeTemoinsPromisEtAucunEcart() {
        for (Map.Entry<String, Scene> e : ScenesDEssai.toutes(60).entrySet()) {
            Traceur lancer = new Traceur(rapide(e.getValue(), CAMERA), CAMERA);
            lancer.TracerPixels((couleur, i, j) -> { }, 5, 2);
            assertNull(lancer.getEcart(), e.getKey());
            assertEquals(64, lancer.getCompteurs().pixelsTemoins, e.getKey());
        }
    }

    @Test
    void leurNombreNeDependNiDesFilsNiDesRepetitionsEtLesAutresComptesNonPlus() {
        Scene scene = ScenesDEssai.foule(7, 20_000, 0).scene();
        Compteurs premiers = null;
        for (int fils : new int[] {1, 3}) {
            Traceur lancer = new Traceur(rapide(scene, CAMERA), CAMERA);
            for (int fois = 0; fois < 2; fois++) {
                lancer.TracerPixels((couleur, i, j) -> { }, 5, fils);
                Compteurs c = lancer.getCompteurs();
                premiers = premiers == null ? c : premiers;
                assertTrue(c.pixelsTemoins > 0 && c.pixelsTemoins < 64, c.pixelsTemoins + " témoins");
                assertEquals(premiers.pixelsTemoins, c.pixelsTemoins);
                assertEquals(premiers.testsSpheres, c.testsSpheres);
                assertEquals(CAMERA.getLargeur() * CAMERA.getHauteur(), c.primaires);
            }
        }
    }

    @Test
    void uneImageDUnPixelAUnTemoin() {
        Camera une = new Camera(1, 1);
        Traceur lancer = new Traceur(rapide(ScenesDEssai.toutes(60).get("foule"), une), une);
        lancer.TracerPixels((couleur, i, j) -> { }, 5, 1);
        assertEquals(1, lancer.getCompteurs().pixelsTemoins);
        assertNull(lancer.getEcart());
    }

    @Test
    void uneEquationChangeeSeVoitEtCeSontLesBouclesQuiDessinent() {
        Scene scene = modifiee(ScenesDEssai.toutes(60).get("foule"), 0.98);
        Traceur lancer = new Traceur(scene, CAMERA);
        Couleur[] image = new Couleur[CAMERA.getLargeur() * CAMERA.getHauteur()];
        lancer.TracerPixels((couleur, i, j) -> image[j * CAMERA.getLargeur() + i] = couleur, 5, 2);
        assertNotNull(lancer.getEcart());
        assertTrue(lancer.getEcart().startsWith("au pixel "), lancer.getEcart());
        // un second dessin, par les boucles, n'oublie pas ce que le premier a vu
        lancer.TracerPixels((couleur, i, j) -> assertEquals(image[j * CAMERA.getLargeur() + i], couleur), 5, 2);
        assertNotNull(lancer.getEcart());
        assertTrue(lancer.getCompteurs().pixelsTemoins > 0);
        assertFalse(scene.getModele().getRecherche() instanceof RechercheRapide);
        Scene lisible = new Scene(scene.getObjets(), scene.getLampes());
        IdentiteTest.Dessin attendu = new IdentiteTest.Dessin(lisible, CAMERA, 5, 1);
        for (int k = 0; k < image.length; k++) {
            assertEquals(attendu.pixels[k], image[k], "pixel " + k);
        }
    }

    /** Le brouillon aussi est alors dessiné par les boucles : dans une fenêtre, les témoins viennent avant lui. */
    @Test
    void dansLaFenetreLeBrouillonEstDejaCeluiDesBoucles() {
        Scene scene = modifiee(ScenesDEssai.toutes(60).get("foule"), 0.9);
        Traceur lancer = new Traceur(scene, CAMERA);
        lancer.TracerImage((couleur, i, j) -> assertFalse(scene.getModele().getRecherche() instanceof RechercheRapide), 5, 1);
        assertNotNull(lancer.getEcart());
    }

    /** Cent mille sphères, et assez de lampes pour qu'aucun pixel n'aille à sa fin par les boucles : ses premières questions suffisent. */
    @Test
    void unTemoinCoupeNeCompteMaisVoitUneRechercheFausse() {
        Scene scene = ScenesDEssai.foule(11, 100_000, 0).lampes(40).scene();
        Temoins justes = new Temoins(rapide(scene, CAMERA), CAMERA, 5, null);
        justes.juger();
        assertNull(justes.getEcart());
        assertTrue(justes.getNombre() < 4, justes.getNombre() + " témoins entiers");
        Temoins faux = new Temoins(modifiee(scene, 0.5), CAMERA, 5, null);
        faux.juger();
        assertNotNull(faux.getEcart());
    }

    @Test
    void lesBouclesDuCoursNeSeJugentPas() {
        Scene scene = new Scene(Collections.singletonList(new Sphere(new Point(0, 0, 6), 1)), Collections.<Lampe>emptyList());
        scene.getModele().setRecherche(new RechercheSimple(scene.getObjets(), scene.getCompteurs()));
        Traceur lancer = new Traceur(scene, CAMERA);
        lancer.TracerPixels((couleur, i, j) -> { }, 5, 2);
        assertEquals(0, lancer.getCompteurs().pixelsTemoins);
        assertNull(lancer.getEcart());
    }

    /** Un rayon qui ne part pas d'où partent ceux d'un masque, ou va ailleurs, reçoit quand même la réponse des boucles. */
    @Test
    void unRayonDeplaceOuTorduALaReponseDesBoucles() {
        for (Map.Entry<String, Scene> e : ScenesDEssai.toutes(20).entrySet()) {
            Scene scene = rapide(e.getValue(), CAMERA);
            RechercheSimple boucles = new RechercheSimple(scene.getObjets(), new Compteurs());
            java.util.Random hasard = new java.util.Random(5);
            for (int k = 0; k < 400; k++) {
                Point ailleurs = new Point(hasard.nextGaussian(), hasard.nextGaussian(), k % 3 == 0 ? 0 : 4 * hasard.nextGaussian());
                Rayon rayon = new Rayon(ailleurs,
                        new Point(3 * hasard.nextGaussian(), 3 * hasard.nextGaussian(), 6 + hasard.nextGaussian()));
                Objet3D depart = k % 2 == 0 || scene.getObjets().isEmpty() ? null : scene.getObjets().get(k % scene.getObjets().size());
                scene.getModele().getRecherche().plusProche(rayon, depart);
                double distance = rayon.getDistance();
                Objet3D objet = rayon.getObjet();
                boucles.plusProche(rayon, depart);
                assertEquals(rayon.getDistance(), distance, e.getKey() + ", rayon " + k);
                assertEquals(rayon.getObjet(), objet, e.getKey() + ", rayon " + k);
                for (Lampe lampe : scene.getLampes()) {
                    if (depart != null) {
                        assertEquals(boucles.estCachee(lampe, ailleurs, rayon.getV(), 5, depart),
                                scene.getModele().getRecherche().estCachee(lampe, ailleurs, rayon.getV(), 5, depart),
                                e.getKey() + ", ombre " + k);
                    }
                }
            }
        }
    }
}
