package lancer.promesses;

import static lancer.essai.Ressources.boule;
import static lancer.essai.Ressources.deplacee;
import static lancer.essai.Ressources.fois;
import static lancer.essai.Ressources.image;
import static lancer.essai.Ressources.memesBits;
import static lancer.essai.Ressources.scene;
import static lancer.rapide.Structuree.imageRapide;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Ressources;
import lancer.essai.Tirages;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Deux façons de dire la même scène, ou de la dessiner, qui doivent donner la même image au bit près ; {@link DessinTest} en a d'autres.
 */
class EgalitesTest {

    private static final Camera CAMERA = new Camera(64, 48);

    private static Scene foule() {
        return new Scene(Ressources.chemin("reference/p4-foule.ini"));
    }

    /** La même vue d'un monde {@code fois} plus grand. */
    private static final class CameraAgrandie extends Camera {

        private final double fois;

        CameraAgrandie(double fois) {
            super(CAMERA.getLargeur(), CAMERA.getHauteur());
            this.fois = fois;
        }

        @Override
        public Rayon getRayon(double xe, double ye) {
            Point ecran = super.getRayon(xe, ye).getP();
            return new Rayon(fois(ecran, fois), new Vecteur(OEIL, ecran).mul(fois));
        }
    }

    /** Rien dans le programme n'a d'unité de longueur : ni seuil de distance, ni décalage, ni case plus petite que tout. */
    @Test
    void grossirToutLeMondeParUnePuissanceDeDeuxNeChangePasUnBit() {
        Map<String, Scene> scenes = new LinkedHashMap<>();
        for (String nom : new String[] {"p1-quatre", "p2-sol", "p3-miroirs", "p4-foule"}) {
            scenes.put(nom, new Scene(Ressources.chemin("reference/" + nom + ".ini")));
        }
        for (double rayon : new double[] {5e3, 3e7, 9.9e7, 4e11}) {
            scenes.put("lampe qui rase un sol de rayon " + rayon, scene(List.of(boule(0, -rayon - 1, 8, rayon, 0.8, 0.3, 5),
                    boule(0.4, -0.4, 6, 0.6, 0.5, 0.4, 40)), new Lampe(new Point(-6, -0.999999, 12), new Couleur(1))));
        }
        scenes.put("trois géantes", scene(List.of(boule(0, -9e7 - 1, 8, 9e7, 0.8, 0.3, 5), boule(-3e7 - 3, 0, 9, 3e7, 0.6, 0.5, 9),
                boule(0, 0, 6e7 + 20, 6e7, 0.7, 0.2, 3)), new Lampe(new Point(1, 2, 3), new Couleur(1))));
        scenes.forEach((nom, scene) -> {
            Ressources.Image attendue = imageRapide(scene, new CameraAgrandie(1), 5);
            assertTrue(memesBits(attendue, image(new Scene(scene.getObjets(), scene.getLampes()), 64, 48, 5, 2)), nom);
            for (int k : new int[] {-300, -27, -1, 2, 300}) {
                double taille = Math.scalb(1.0, k);
                Camera camera = new CameraAgrandie(taille);
                Scene grosse = deplacee(scene, p -> fois(p, taille), taille);
                Ressources.Image lisible = new Ressources.Image(64, 48);
                new Lancer(grosse, camera).TracerImage(lisible, 5, 2);
                assertTrue(memesBits(attendue, lisible), nom + " fois 2^" + k);
                assertTrue(memesBits(attendue, imageRapide(grosse, camera, 5)), nom + " fois 2^" + k + ", recherche rapide");
            }
        });
    }

    /** Noire, au cœur d'une boule, ou sous le sol : une lampe que rien ne voit. */
    @Test
    void uneLampeInutileNeChangePasUnBit() {
        List<Sphere> boules = List.of(boule(0, -1001.5, 8, 1000, 0.8, 0.2, 3), boule(0, 0, 6, 1, 0.5, 0.5, 40),
                boule(1.5, 0.3, 5, 0.5, 0.4, 0.6, 0), boule(-1.2, -0.4, 4, 0.7, 0.9, 0, 1));
        Lampe utile = new Lampe(new Point(-5, 8, -4), new Couleur(0.9, 0.8, 0.7));
        Ressources.Image sans = imageRapide(scene(boules, utile), CAMERA, 5);
        Lampe[] inutiles = {new Lampe(new Point(3, 3, 0), new Couleur()), new Lampe(new Point(0.3, 0.2, 5.6), new Couleur(1e6)),
            new Lampe(new Point(0, -20, 6), new Couleur(50)), new Lampe(new Point(0, -1001.5, 8), new Couleur(1))};
        for (Lampe inutile : inutiles) {
            for (Lampe[] lampes : new Lampe[][] {{utile, inutile}, {inutile, utile}}) {
                assertTrue(memesBits(sans, imageRapide(scene(boules, lampes), CAMERA, 5)), inutile.toString());
                assertTrue(memesBits(sans, image(scene(boules, lampes), 64, 48, 5, 2)), inutile + ", --simple");
            }
        }
        Lampe vue = new Lampe(new Point(3, 3, 0), new Couleur(0.001));
        assertFalse(memesBits(sans, imageRapide(scene(boules, utile, vue), CAMERA, 5)), "une lampe utile, si faible qu'elle soit, se voit");
    }

    /** La foule n'a pas deux contacts à la même distance d'un rayon : {@link #aDistanceEgaleLaPremiereDuFichierEstVue}. */
    @Test
    void sansDistancesEgalesMelangerLesSpheresNeChangePasUnBitDeLImageRapide() {
        Scene scene = foule();
        Ressources.Image attendue = image(scene, 64, 48, 5, 2);
        Tirages tirages = new Tirages(46);
        for (int essai = 0; essai < 8; essai++) {
            List<Objet3D> melees = new ArrayList<>(scene.getObjets());
            Collections.shuffle(melees, tirages.hasard);
            assertTrue(memesBits(attendue, imageRapide(new Scene(melees, scene.getLampes()), CAMERA, 5)), "graine 46, essai " + essai);
        }
    }

    /** Deux boules symétriques, à la même distance de tout rayon du plan x = y : seules, puis dans une foule derrière elles. */
    @ParameterizedTest
    @ValueSource(ints = {0, 60})
    void aDistanceEgaleLaPremiereDuFichierEstVue(int foule) {
        List<Sphere> ordre = new ArrayList<>(List.of(boule(0, 1, 6, 1, 0.9, 0, 1), boule(1, 0, 6, 1, 0.2, 0, 1)));
        for (int k = 0; k < foule; k++) {
            ordre.add(boule(k % 10 - 4.5, k / 10 - 2.7, 12, 0.2, 0.5, 0, 1));
        }
        List<Sphere> envers = new ArrayList<>(ordre);
        Collections.swap(envers, 0, 1);
        Lampe lampe = new Lampe(new Point(3, 6, -4), new Couleur(0.9));
        Ressources.Image[] images = new Ressources.Image[2];
        for (int k = 0; k < 2; k++) {
            images[k] = image(scene(k == 0 ? ordre : envers, lampe), 64, 48, 5, 2);
            assertTrue(memesBits(images[k], imageRapide(scene(k == 0 ? ordre : envers, lampe), CAMERA, 5)), "recherche rapide, " + k);
        }
        int egales = 0;
        for (int k = 0; k < 64 * 48; k++) {
            Rayon rayon = CAMERA.getRayon(k % 64 + 0.5, k / 64 + 0.5);
            double haute = ordre.get(0).getIntersectionDistance(rayon);
            boolean egale = haute < Constantes.INFINI && haute == ordre.get(1).getIntersectionDistance(rayon);
            boolean differe = images[0].composantes[3 * k] != images[1].composantes[3 * k];
            assertTrue(egale || !differe, "pixel " + k);
            egales += differe ? 1 : 0;
            if (egale) {
                assertSame(ordre.get(0), scene(ordre, lampe).getClosestIntersection(rayon).objet);
                assertSame(envers.get(0), scene(envers, lampe).getClosestIntersection(rayon).objet);
            }
        }
        assertTrue(egales > 5, egales + " pixels");
    }
}
