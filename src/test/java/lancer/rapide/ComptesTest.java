package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CancellationException;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.contrat.Compteurs;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Aucun rayon inutile, et aucune scène où chercher coûte beaucoup plus que dans un arbre. Des comptes, jamais des temps. */
class ComptesTest {

    private static final Camera CAMERA = new Camera(80, 60);
    private static final int AU_PLUS = 3;
    private static final int PLUS = 32;

    private static Sphere boule(double z, double kd, double ks) {
        Sphere s = new Sphere(new Point(0, 0, z), 1);
        s.setKd(new Couleur(kd));
        s.setKs(new Couleur(ks));
        return s;
    }

    private static Compteurs compter(Scene scene, int profondeur) {
        return new IdentiteTest.Dessin(Structuree.scene(scene, CAMERA), CAMERA, profondeur, 2).compteurs;
    }

    /** Jusqu'à quinze objets, ou quelques pixels, les boucles du cours répondent sur leur propre liste. */
    @Test
    void rienNEstPrepareJusquAQuinzeObjetsNiPourQuelquesPixels() {
        Scene quinze = ScenesDEssai.foule(5, 15, 0).scene();
        Scene seize = ScenesDEssai.foule(5, 16, 0).scene();
        for (int[] cote : new int[][] {{8, 6, 1, 1}, {80, 60, 1, 1}, {800, 600, 1, 0}}) {
            Camera camera = new Camera(cote[0], cote[1]);
            assertEquals(cote[2] == 1, Preparation.preparer(quinze, camera) == quinze, cote[0] + " : quinze");
            assertEquals(cote[3] == 1, Preparation.preparer(seize, camera) == seize, cote[0] + " : seize");
        }
    }

    /** Cent lampes ont chacune leur carte : un rayon d'ombre y coûte ce qu'il coûte avec dix. */
    @Test
    void centLampesOntChacuneLeurCarte() {
        double[] parOmbre = new double[2];
        for (int k = 0; k < 2; k++) {
            Compteurs c = compter(ScenesDEssai.foule(8, 820, 0).lampes(k == 0 ? 10 : 100).scene(), 0);
            parOmbre[k] = cout(c) / (double) c.ombre;
        }
        assertTrue(parOmbre[1] < 1.2 * parOmbre[0], parOmbre[0] + " examens par ombre, puis " + parOmbre[1]);
    }

    /** Un examen : un cube, une boîte, une enveloppe ou un objet regardés pour un rayon. */
    @Tag("long")
    @ParameterizedTest
    @ValueSource(ints = {1, 10})
    void aucuneSceneHostileNeCouteTroisFoisCeQueCouteUnArbreSimpleOuLesBoucles(int milliers) {
        int taille = System.getProperty("tests.longs") != null ? 1000 * milliers : 300 * milliers;
        List<String> fautes = new ArrayList<>();
        for (Map.Entry<String, Scene> e : ScenesDEssai.hostiles(taille).entrySet()) {
            Scene scene = e.getValue();
            // là où tout est partout, et chaque rayon long pour tous : moins de rayons
            boolean longs = scene.getLampes().size() > 100 || e.getKey().matches(".*(coquilles|un seul point|mêlées).*");
            Camera camera = longs ? new Camera(20, 15) : CAMERA;
            IdentiteTest.Dessin oracle = new IdentiteTest.Dessin(scene.avec(new ArbreSimple(scene.getObjets(), new Compteurs())), camera, 3,
                    2);
            IdentiteTest.Dessin rapide = new IdentiteTest.Dessin(Preparation.preparer(scene, camera), camera, 3, 2);
            rapide.verifier(e.getKey(), oracle);
            long boucles = rapide.compteurs.rayons() * scene.getObjets().size();
            int n = scene.getObjets().size();
            // une construction d'arbre est permise
            long permis = AU_PLUS * Math.min(boucles, cout(oracle.compteurs)) + PLUS * rapide.compteurs.rayons()
                    + (long) (10 * n * Math.log(n) / Math.log(2));
            if (cout(rapide.compteurs) > permis) {
                fautes.add(e.getKey() + " : " + cout(rapide.compteurs) / (double) rapide.compteurs.rayons()
                        + " examens par rayon, arbre simple " + cout(oracle.compteurs) / (double) rapide.compteurs.rayons());
            }
        }
        assertEquals(Collections.emptyList(), fautes);
    }

    /** Chaque rayon y traverse des dizaines de boules : les listes triées et l'arbre n'en examinent que les premières. */
    @Test
    void desBoulesQuiSeRecouvrentCoutentMoinsQueDansUnArbreSimple() {
        Random hasard = new Random(3);
        List<Sphere> boules = new ArrayList<>();
        for (int k = 0; k < 300; k++) {
            Sphere boule = new Sphere(new Point(8 * hasard.nextDouble() - 4, 6 * hasard.nextDouble() - 3, 4 + 12 * hasard.nextDouble()),
                    0.3 + hasard.nextDouble());
            boule.setKs(new Couleur(0.6));
            boules.add(boule);
        }
        Scene scene = new Scene(boules, Collections.singletonList(new Lampe(new Point(-5, 8, -6), new Couleur(1))));
        Compteurs arbre = new IdentiteTest.Dessin(scene.avec(new ArbreSimple(scene.getObjets(), new Compteurs())), CAMERA, 4, 2).compteurs;
        Compteurs rapide = compter(scene, 4);
        assertTrue(cout(rapide) < cout(arbre) / 2, cout(rapide) + " examens, arbre simple " + cout(arbre));
    }

    /** Sous toutes les boîtes, il y a une boule proche : seule l'entrée exacte dans une boîte l'écarte. */
    @Test
    void dansLArbreSeulDesBoulesQuiSeRecouvrentCoutentCeQueCouteUnArbreSimple() {
        Random hasard = new Random(7);
        List<Sphere> boules = new ArrayList<>();
        for (int k = 0; k < 1000; k++) {
            boules.add(new Sphere(new Point(2 * hasard.nextDouble() - 1, 2 * hasard.nextDouble() - 1, 7 + 2 * hasard.nextDouble()),
                    1 + 2 * hasard.nextDouble()));
        }
        Scene scene = new Scene(boules, Collections.singletonList(new Lampe(new Point(-10, 15, -12), new Couleur(1))));
        Camera camera = new Camera(12, 9);
        Compteurs arbre = compter(scene.avec(new ArbreSimple(scene.getObjets(), new Compteurs())), camera, 3, 1);
        Compteurs rapide = compter(Preparation.preparer(scene, camera), camera, 3, 1);
        assertTrue(cout(rapide) < 1.5 * cout(arbre), cout(rapide) + " examens, arbre simple " + cout(arbre));
    }

    @Test
    void niLampesNiMiroirsNiSousPixelsNiProfondeurNeCoutentPlusQueLaBorne() {
        essayer("25 sphères, 5 000 lampes", ScenesDEssai.foule(25, 25, 0).lampes(5000).scene(), 6, 4, 5, 1, true);
        essayer("24 sphères, 5 000 lampes", ScenesDEssai.foule(24, 24, 0).lampes(5000).scene(), 6, 4, 5, 1, true);
        essayer("trois reflets plus loin", ScenesDEssai.entreDeuxMiroirs(5000), 100, 2, 5, 1, false);
        essayer("dix reflets plus loin", ScenesDEssai.entreDeuxMiroirs(3000), 60, 2, 10, 1, false);
        essayer("mille reflets permis", ScenesDEssai.entreDeuxMiroirs(3000), 16, 1, 1000, 1, false);
        essayer("trois pixels de haut, mille points chacun", ScenesDEssai.foule(26, 5000, 0).scene(), 3, 3, 5, 32, false);
        essayer("douze pixels, seize points chacun", ScenesDEssai.foule(26, 2000, 0).scene(), 12, 12, 5, 4, true);
        essayer("lampes dans la première", ScenesDEssai.lampesDansUneSphere(3000, 0, 100), 20, 15, 2, 1, true);
        essayer("lampes dans la vingtième", ScenesDEssai.lampesDansUneSphere(3000, 19, 100), 20, 15, 2, 1, true);
        essayer("une lampe dans la première", ScenesDEssai.lampesDansUneSphere(3000, 0, 1), 60, 45, 5, 1, true);
    }

    /** @param points par côté de chaque pixel */
    private static void essayer(String nom, Scene lue, int largeur, int hauteur, int profondeur, int points, boolean avecBoucles) {
        Camera camera = new Camera(largeur, hauteur);
        Scene scene = lue.avec(lue.getModele().avecSeuil(0));
        Compteurs arbre = compter(scene.avec(new ArbreSimple(scene.getObjets(), new Compteurs())), camera, profondeur, points);
        Compteurs rapide = compter(Preparation.preparer(scene, camera), camera, profondeur, points);
        long autres = avecBoucles ? cout(compter(scene, camera, profondeur, points)) : Long.MAX_VALUE;
        assertEquals(arbre.rayons(), rapide.rayons(), nom);
        double n = scene.getObjets().size();
        double permis = AU_PLUS * (double) Math.min(autres, cout(arbre)) + PLUS * rapide.rayons() + 10 * n * Math.log(n) / Math.log(2);
        assertTrue(cout(rapide) <= permis, nom + " : " + cout(rapide) + " examens, permis " + permis);
    }

    private static Compteurs compter(Scene scene, Camera camera, int profondeur, int points) {
        Lancer lancer = new Lancer(scene.avec(scene.getModele()), camera);
        for (int y = 0; y < camera.getHauteur() * points; y++) {
            for (int x = 0; x < camera.getLargeur() * points; x++) {
                lancer.getCouleurPixel((x + 0.5) / points, (y + 0.5) / points, profondeur);
            }
        }
        return lancer.getScene().getCompteurs();
    }

    /** Dans un pixel, dans ses questions : ni les boucles, ni l'arbre, ni le regard ne vont au bout. */
    @Test
    void unFilInterrompuSArreteDansUnPixel() {
        Scene scene = ScenesDEssai.foule(7, 20_000, 0).lampes(2000).scene();
        Scene cellules = Structuree.scene(scene, CAMERA);
        for (Scene cherchee : new Scene[] {scene, cellules, Structuree.scene(scene, new Camera(2, 2))}) {
            Lancer lancer = new Lancer(cherchee.avec(cherchee.getModele()), CAMERA);
            Thread.currentThread().interrupt();
            try {
                assertThrows(CancellationException.class, () -> lancer.getCouleurPixel(40, 30, 5));
                assertThrows(CancellationException.class, () -> Regard.trouveUneReponseCachee(cellules, CAMERA));
            } finally {
                assertTrue(Thread.interrupted(), "le fil appelant reste interrompu");
            }
            assertTrue(lancer.getScene().getCompteurs().ombre <= 256, "ombres : " + lancer.getScene().getCompteurs().ombre);
        }
    }

    @Test
    void unePreparationInterrompueSArrete() {
        Scene scene = ScenesDEssai.foule(7, 20_000, 0).scene();
        Thread.currentThread().interrupt();
        try {
            assertThrows(CancellationException.class, () -> Structuree.scene(scene, CAMERA));
        } finally {
            assertTrue(Thread.interrupted(), "le fil appelant reste interrompu");
        }
    }

    @Test
    void uneBoulePerdueAuLoinNeCouteQueDEtreExaminee() {
        Compteurs sans = compter(ScenesDEssai.foule(48, 3000, 0).scene(), 5);
        for (double distance : new double[] {1e9, 1e11, 1e13, 1e31, 1e100}) {
            Compteurs avec = compter(ScenesDEssai.foule(48, 3000, distance).scene(), 5);
            assertTrue(cout(avec) <= cout(sans) + sans.rayons(), "à " + distance + " : " + cout(avec) + " au lieu de " + cout(sans));
        }
    }

    static long cout(Compteurs c) {
        return c.testsSpheres + c.noeudsVisites;
    }
}
