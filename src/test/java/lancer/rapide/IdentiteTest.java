package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import lancer.Camera;
import lancer.CameraPlacee;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Atmosphere;
import lancer.contrat.Compteurs;
import lancer.contrat.Modele;
import lancer.contrat.Specularite;
import lancer.essai.CameraDeplacee;
import lancer.essai.Ressources;
import lancer.essai.Tirages;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * L'image rapide est l'image lisible, au bit près, pour autant de rayons, quels que soient la scène, la recherche, le nombre de fils et
 * la caméra.
 */
class IdentiteTest {

    private static final int LARGEUR = 61;
    private static final int HAUTEUR = 47;
    private static final int FOULE = 60;

    /** D'autres caméras, l'image peut être petite : ce sont les questions qui changent, et non leur nombre. */
    private static final int PART = System.getProperty("tests.longs") != null ? 1 : 3;
    private static final int YEUX = 150 / PART;

    /** Celles du fichier de référence, celles qui sont faites pour nuire, et d'autres au hasard. */
    private static Map<String, Scene> scenes() {
        Map<String, Scene> scenes = new LinkedHashMap<>();
        for (String nom : new String[] {"p1-quatre", "p2-sol", "p3-miroirs", "p4-foule"}) {
            scenes.put(nom, new Scene(Ressources.chemin("reference/" + nom + ".ini")));
        }
        scenes.putAll(ScenesDEssai.toutes(FOULE));
        scenes.putAll(ScenesDEssai.extremes(FOULE));
        ScenesDEssai.hostiles(3 * FOULE).forEach((nom, scene) -> scenes.put("hostile : " + nom, scene));
        for (int n = 0; n < 50 / PART; n++) {
            scenes.put("graine " + (4300 + n), new Tirages(4300 + n).scene(1 + 2 * n));
        }
        return scenes;
    }

    @Test
    void chaqueSceneALaMemeImageParChaqueRechercheEtChaqueNombreDeFils() {
        scenes().forEach((nom, scene) -> comparer(nom, scene, 8));
    }

    /** L'œil d'un étudiant et le plan de son écran, puis celui d'une section : derrière, en plongée, au milieu des boules. */
    static Stream<Camera> cameras() {
        double[][] oeils = {{0.3, 0.2, -4.2, 0}, {-2, 1.5, -3, 0}, {0, 0, -1, 0}, {0, 0, -0.3, 0.5}, {0.4, 0, -0.01, 0}, {0, 0, -500, 0},
            {-300, 20, -40, 1}, {0, 0, -0.51, 0}, {0, 0, -0.49, 0}, {0, 0, -30, 0}, {0, 0, 3, 0}, {1, -2, 5, -1}, {0, 0, -1e9, 0},
            {1e120, 0, -1, 0}};
        double[][] sections = {{0, 1, 20, 0, 0, 8, 30}, {3, 9, 8, 0, 0, 8, 60}, {0, 0, 0, 1, 0, 0, 90}, {0, 0, 8, 1, 1, 1, 150},
            {0, 0, 6, 0, 0, 9, 179.9}, {-6, 0, -30, 0, 0, 8, 3}, {1e9, 1e9, 1e9, 0, 0, 8, 1e-7}, {5, -4, 3, 5, -4, 3.0001, 60}};
        return Stream.concat(
                Arrays.stream(oeils).map(o -> new CameraDeplacee(LARGEUR / PART, HAUTEUR / PART, new Point(o[0], o[1], o[2]), o[3])),
                Arrays.stream(sections).map(s -> new CameraPlacee(LARGEUR / PART, HAUTEUR / PART, new Point(s[0], s[1], s[2]),
                        new Vecteur(new Point(s[0], s[1], s[2]), new Point(s[3], s[4], s[5])), s[6])));
    }

    @ParameterizedTest
    @MethodSource("cameras")
    void chaqueSceneALaMemeImageDeChaqueCamera(Camera camera) {
        for (int foule : new int[] {12, FOULE}) {
            ScenesDEssai.toutes(foule).forEach((nom, scene) -> comparer(nom + ", " + foule, scene, camera));
        }
    }

    @Test
    void uneFouleALaMemeImageDUnOeilAuHasard() {
        Random hasard = new Random(42);
        for (int k = 0; k < YEUX; k++) {
            double cote = k % 4 == 0 ? 1 : 0;
            Point oeil = new Point(cote * hasard.nextGaussian(), cote * hasard.nextGaussian(),
                    -Math.pow(10, 3 * hasard.nextDouble() - 1.5));
            double plan = k % 8 == 0 ? hasard.nextGaussian() : 0;
            comparer("tirage " + k + " : " + oeil + ", " + plan, ScenesDEssai.foule(k, k % 2 == 0 ? 30 : 200, 0).scene(),
                    new CameraDeplacee(LARGEUR, HAUTEUR, oeil, plan));
        }
    }

    /** Il y a des rayons qui n'existent pas. */
    @Test
    void dUnOeilDansLePlanDeLEcranOuNullePartLaPreparationNEchouePas() {
        for (double z : new double[] {0, Double.NaN}) {
            Structuree.scene(ScenesDEssai.foule(3, FOULE, 0).scene(), new CameraDeplacee(LARGEUR, HAUTEUR, new Point(0.1, 0.2, z), 0));
        }
    }

    private static void comparer(String nom, Scene scene, Camera camera) {
        new Dessin(Structuree.scene(scene, camera), camera, 3, 2).verifier(nom, new Dessin(scene, camera, 3, 2));
    }

    @Test
    void reflexionsSansFin() {
        Scene scene = ScenesDEssai.toutes(FOULE).get("tout dans une sphère").avec(new Modele().avecSeuil(0));
        comparer("mille réflexions", scene, 1000);
        comparer("aucune réflexion", scene, 0);
    }

    /** À un cheveu de 1, le carré d'une longueur prend un autre chemin pour se normaliser : le même pour les deux images. */
    @Test
    void uneLampeADistanceUnDUnContact() {
        List<Sphere> boules = List.of(Ressources.boule(0, 0, 6, 1, 0.8, 0, 1), Ressources.boule(0.74, 0, 4.82, 0.3, 0.8, 0.3, 1));
        Scene scene = new Scene(boules, List.of(new Lampe(new Point(0.8, 0, 4.4), new Couleur(1))));
        Camera camera = new Camera(801, 601);
        Scene structuree = Structuree.scene(scene, camera);
        for (int k = 0; k < 2000; k++) {
            double xe = 400 + k % 50 * 2.5 + 0.5;
            double ye = 300 - 50 + k / 50 * 2.5 + 0.5;
            Couleur lisible = new Lancer(scene, camera).getCouleurPixel(xe, ye, 5);
            assertEquals(lisible, new Lancer(structuree, camera).getCouleurPixel(xe, ye, 5), xe + ", " + ye);
        }
    }

    @Test
    void autresContrats() {
        Scene foule = ScenesDEssai.toutes(FOULE).get("foule");
        Modele.Construction modele = new Modele.Construction();
        modele.setAtmosphere(new Voile());
        modele.setSpecularite((V, N, L, R, ns) -> Specularite.puissance(N.dot(L.sub(V).normalized()), ns / 2));
        comparer("voile et autre reflet", foule.avec(modele.construire()), 5);
    }

    /** Une atmosphère qui ne commute avec rien. */
    private static final class Voile implements Atmosphere {
        @Override
        public Couleur traverser(Couleur vue, double distance) {
            double k = 1 - Math.exp(-distance / 10);
            return new Couleur(0.8 * k + (1 - k) * vue.r, 0.7 * k + (1 - k) * vue.v, 0.6 * k + (1 - k) * vue.b);
        }
    }

    static void comparer(String nom, Scene scene, int profondeur) {
        Camera camera = new Camera(LARGEUR, HAUTEUR);
        Dessin lisible = new Dessin(scene, camera, profondeur, 2);
        for (Couleur c : lisible.pixels) {
            assertTrue(Math.min(c.r, Math.min(c.v, c.b)) >= 0 && c.estFinie(), nom + " : " + c);
        }
        Compteurs premiers = null;
        // sans cellules : il y a plus de huit objets par pixel
        new Dessin(Structuree.scene(scene, new Camera(1, 1)), camera, profondeur, 2).verifier(nom + ", arbre", lisible);
        for (int fils : new int[] {1, 2, 7}) {
            Dessin rapide = new Dessin(Structuree.scene(scene, camera), camera, profondeur, fils);
            rapide.verifier(nom + ", " + fils + " fils", lisible);
            premiers = premiers == null ? rapide.compteurs : premiers;
            assertEquals(premiers.testsSpheres, rapide.compteurs.testsSpheres, nom + ", sphères, fils");
            assertEquals(premiers.noeudsVisites, rapide.compteurs.noeudsVisites, nom + ", nœuds, fils");
        }
    }

    /** Une image et ses comptes. */
    static final class Dessin {

        final Couleur[] pixels;
        final Compteurs compteurs;
        private final int largeur;

        Dessin(Scene scene, Camera camera, int profondeur, int fils) {
            largeur = camera.getLargeur();
            pixels = new Couleur[largeur * camera.getHauteur()];
            Lancer lancer = new Lancer(scene, camera);
            lancer.TracerImage((couleur, i, j) -> pixels[j * largeur + i] = couleur, profondeur, fils);
            compteurs = lancer.getAtelier().getCompteurs();
        }

        void verifier(String nom, Dessin attendu) {
            for (int k = 0; k < pixels.length; k++) {
                if (!pixels[k].equals(attendu.pixels[k])) {
                    fail(nom + " : pixel (" + k % largeur + ", " + k / largeur + ") " + pixels[k] + ", lisible " + attendu.pixels[k]);
                }
            }
            assertEquals(attendu.compteurs.primaires, compteurs.primaires, nom + ", primaires");
            assertEquals(attendu.compteurs.ombre, compteurs.ombre, nom + ", ombre");
            assertEquals(attendu.compteurs.reflechis, compteurs.reflechis, nom + ", réfléchis");
        }
    }
}
