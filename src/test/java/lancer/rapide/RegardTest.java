package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lancer.Camera;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Le regard voit une recherche qui cache un objet ; il ne voit rien d'une recherche juste. */
class RegardTest {

    private static final Camera CAMERA = new Camera(97, 61);

    /** Une sphère dont l'enveloppe n'a que cette part du rayon. */
    private static class Debordante extends Sphere {

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

    /** Une sphère dont les réponses échouent : une distance qui n'est pas un nombre, une exception, une normale nulle. */
    private static final class Fautive extends Debordante {

        private final String faute;

        Fautive(Sphere sphere, String faute) {
            super(sphere, 1);
            this.faute = faute;
            setMatiere(sphere);
        }

        @Override
        public double getIntersectionDistance(Rayon incident) {
            if (faute.equals("exception")) {
                throw new IllegalStateException("pas fini");
            }
            double d = faute.equals("NaN") ? Double.NaN : super.getIntersectionDistance(incident);
            incident.setContact(this, d);
            return d;
        }

        @Override
        public Vecteur getNormale(Point contact) {
            return faute.equals("normale") ? null : super.getNormale(contact);
        }
    }

    private static List<Objet3D> foule(int taille) {
        return new ArrayList<>(ScenesDEssai.foule(3, taille, 0).scene().getObjets());
    }

    private static Scene eclairee(List<Objet3D> objets) {
        return new Scene(objets, ScenesDEssai.foule(3, 60, 0).scene().getLampes());
    }

    /** Une sphère la cache peut-être : le regard la demande tout de même. */
    @ParameterizedTest
    @ValueSource(strings = {"NaN", "exception", "normale"})
    void uneFormeQuiEchoueEstNommee(String faute) {
        List<Objet3D> objets = foule(60);
        objets.set(30, new Fautive((Sphere) objets.get(30), faute));
        String dit = Regard.regarder(Structuree.scene(eclairee(objets), CAMERA), CAMERA);
        assertTrue(dit.contains(Fautive.class.getName()), dit);
    }

    private static boolean trouve(Scene scene) {
        return Regard.regarder(Structuree.scene(scene, CAMERA), CAMERA) != null;
    }

    @Test
    void dUneRechercheJusteIlNeVoitRienEtNeCompteRien() {
        Map<String, Scene> scenes = new HashMap<>(ScenesDEssai.toutes(60));
        scenes.putAll(ScenesDEssai.toutes(20));
        scenes.putAll(ScenesDEssai.extremes(60));
        scenes.putAll(ScenesDEssai.hostiles(300));
        scenes.forEach((nom, scene) -> {
            Scene preparee = Structuree.scene(scene, CAMERA);
            assertNull(Regard.regarder(preparee, CAMERA), nom);
            assertEquals(0, ComptesTest.cout(preparee.getCompteurs()), nom);
        });
    }

    @Test
    void unObjetPlusGrandQueSonEnveloppeEstVu() {
        for (double part : new double[] {0.5, 0.9}) {
            List<Objet3D> objets = foule(60);
            objets.replaceAll(objet -> new Debordante((Sphere) objet, part));
            assertTrue(trouve(eclairee(objets)), part + " du rayon");
        }
    }

    /** Trois objets faux parmi mille : ceux de chaque classe ont autant de rayons. */
    @Test
    void uneSeuleClasseFausseParmiMilleSpheresEstVueAussi() {
        List<Objet3D> objets = foule(1000);
        for (int k = 0; k < 3; k++) {
            objets.set(300 * k, new Debordante((Sphere) objets.get(300 * k), 0.7));
        }
        assertTrue(trouve(eclairee(objets)));
    }

    /** Le départ du rayon décide : ceux de l'image partent de l'écran, pas de l'œil. */
    @Test
    void unObjetFauxPourLesSeulsRayonsDeLEcranEstVu() {
        List<Objet3D> objets = new ArrayList<>(ScenesDEssai.hostiles(60).get("nuage de boules mêlées").getObjets());
        objets.replaceAll(objet -> new Debordante((Sphere) objet, 1) {
            {
                setMatiere(objet);
            }

            @Override
            public double getIntersectionDistance(Rayon incident) {
                double d = super.getIntersectionDistance(incident);
                d = incident.getP().z == 0 && getCentre().x > 0 ? 0.5 * d : d;
                incident.setContact(this, d);
                return d;
            }
        });
        assertTrue(trouve(eclairee(objets)));
    }
}
