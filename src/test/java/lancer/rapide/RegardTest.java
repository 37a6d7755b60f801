package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.image.ImageMemoire;
import org.junit.jupiter.api.Test;

/** Le regard voit une recherche qui cache un objet et une réponse qui change ; il ne voit rien d'une recherche juste. */
class RegardTest {

    private static final Camera CAMERA = new Camera(97, 61);

    /** Une sphère dont l'enveloppe n'a que cette part du rayon. */
    private static final class Debordante extends Sphere {

        private final double part;

        Debordante(Sphere sphere, double part) {
            super(sphere.getCentre(), sphere.getRayon());
            this.part = part;
        }

        @Override
        public Sphere getEnveloppe() {
            return new Sphere(getCentre(), part * getRayon());
        }
    }

    private static Regard preparer(Scene scene, boolean simple) {
        Preparation.choisir(scene, CAMERA, simple);
        return new Regard(scene, CAMERA);
    }

    private static float[] dessiner(Scene scene, Regard regard, int fils) {
        ImageMemoire image = new ImageMemoire(97, 61, true);
        Lancer lancer = new Lancer(scene, CAMERA);
        lancer.TracerPixels(image, 3, fils);
        if (regard.cachait(lancer, image, 3)) {
            lancer.TracerPixels(image, 3, fils);
        }
        return image.lineaire;
    }

    @Test
    void dUneRechercheJusteIlNeVoitRienEtNeCompteRien() {
        Map<String, Scene> scenes = new HashMap<>(ScenesDEssai.toutes(60));
        scenes.putAll(ScenesDEssai.toutes(20));
        scenes.putAll(ScenesDEssai.extremes(60));
        scenes.putAll(ScenesDEssai.hostiles(300));
        scenes.forEach((nom, scene) -> {
            Regard regard = preparer(scene, false);
            assertNull(regard.getEcart(), nom);
            assertEquals(0, ComptesTest.cout(scene.getCompteurs()), nom);
            if (scene.getLampes().size() < 100) {
                dessiner(scene, regard, 2);
                assertNull(regard.getEcart(), nom);
            }
        });
    }

    @Test
    void unObjetPlusGrandQueSonEnveloppeEstVuEtTousLesObjetsDessinent() {
        for (double part : new double[] {0.5, 0.9}) {
            List<Objet3D> objets = new ArrayList<>(ScenesDEssai.foule(3, 60, 0).scene().getObjets());
            objets.replaceAll(objet -> new Debordante((Sphere) objet, part));
            Scene scene = new Scene(objets, ScenesDEssai.foule(3, 60, 0).scene().getLampes());
            float[] attendue = dessiner(scene, preparer(scene, true), 2);
            Regard regard = preparer(scene, false);
            assertArrayEquals(attendue, dessiner(scene, regard, 2));
            assertTrue(regard.getEcart().contains("les boucles sur tous les objets"), regard.getEcart());
            assertNull(scene.getModele().getRecherche());
        }
    }

    /** Trois objets faux parmi mille : ceux de chaque classe ont autant de rayons. */
    @Test
    void uneSeuleClasseFausseParmiMilleSpheresEstVueAussi() {
        List<Objet3D> objets = new ArrayList<>(ScenesDEssai.foule(3, 1000, 0).scene().getObjets());
        for (int k = 0; k < 3; k++) {
            objets.set(300 * k, new Debordante((Sphere) objets.get(300 * k), 0.7));
        }
        Scene scene = new Scene(objets, ScenesDEssai.foule(3, 60, 0).scene().getLampes());
        assertTrue(preparer(scene, false).getEcart() != null);
    }

    /** Un champ que deux fils partagent : l'image n'est pas dessinée de nouveau, mais une ligne le demande. */
    @Test
    void uneReponseQuiChangeDUnAppelALAutreEstDite() {
        List<Objet3D> objets = new ArrayList<>(ScenesDEssai.foule(3, 60, 0).scene().getObjets());
        int[] appels = new int[1];
        objets.add(new Sphere(new Point(0, 0, 6), 2) {
            @Override
            public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
                return new Couleur(++appels[0]);
            }
        });
        for (boolean simple : new boolean[] {false, true}) {
            Scene scene = new Scene(objets, ScenesDEssai.foule(3, 60, 0).scene().getLampes());
            Regard regard = preparer(scene, simple);
            assertNull(regard.getEcart());
            dessiner(scene, regard, 1);
            assertEquals("la réponse change d'un appel à l'autre : un champ garde-t-il quelque chose ?", regard.getEcart());
            assertEquals(simple, scene.getModele().getRecherche() == null);
        }
    }

    /** Là où deux fils se disputent un champ, quelques pixels seulement sont faux, mais aucun voisin ne leur ressemble. */
    @Test
    void unSeulPixelFauxEstVuOuQuIlSoit() {
        for (int k : new int[] {0, 96, 97 * 30, 97 * 30 + 48, 97 * 61 - 1}) {
            for (boolean lineaire : new boolean[] {false, true}) {
                Scene scene = ScenesDEssai.foule(3, 60, 0).scene();
                Regard regard = preparer(scene, false);
                ImageMemoire image = new ImageMemoire(97, 61, !lineaire, lineaire);
                Lancer lancer = new Lancer(scene, CAMERA);
                lancer.TracerPixels(image, 3, 1);
                Couleur c = image.getCouleur(k);
                image.drawPixel(new Couleur(1 - Math.round(c.r), 1 - Math.round(c.v), 1 - Math.round(c.b)), k % 97, k / 97);
                assertFalse(regard.cachait(lancer, image, 3), k + " : la recherche n'y est pour rien");
                assertTrue(regard.getEcart().contains("change d'un appel à l'autre"), k + " : " + regard.getEcart());
            }
        }
    }
}
