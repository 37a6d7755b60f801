package lancer.rapide;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CancellationException;
import javax.tools.ToolProvider;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.Scene;
import lancer.Sphere;
import lancer.contrat.Compteurs;
import lancer.contrat.Recherche;
import lancer.essai.Essai;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Aucun rayon inutile, et aucune scène où chercher coûte beaucoup plus que dans un arbre. Des comptes, jamais des temps. */
class ComptesTest {

    private static final Camera CAMERA = new Camera(80, 60);
    private static final int AU_PLUS = 3;
    private static final int PLUS = 32;

    private static Compteurs compter(Scene scene, int profondeur) {
        return new IdentiteTest.Dessin(Structuree.scene(scene, CAMERA), CAMERA, profondeur, 2).compteurs;
    }

    private static boolean estPreparee(int objets, int rayons) {
        Scene scene = ScenesDEssai.foule(5, objets, 0).scene();
        return Preparation.preparer(scene, CAMERA, rayons) != scene;
    }

    /** Les boucles du cours répondent alors sur leur propre liste. */
    @Test
    void rienNEstPrepareJusquAQuinzeObjetsNiPourQuelquesDizainesDontPeuDeRayonsViendront() {
        int image = 800 * 600;
        assertFalse(estPreparee(15, 1000 * image), "quinze objets");
        assertFalse(estPreparee(27, image), "une image de vingt-sept objets");
        assertTrue(estPreparee(27, 20 * image), "vingt images de vingt-sept objets");
        assertTrue(estPreparee(27, 4 * image), "quatre rayons par pixel");
        assertTrue(estPreparee(41, 1), "quarante et un objets");
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

    /** Une scène, et comment elle est dessinée. */
    private static final class Cas {

        private final Scene scene;
        private final Camera camera;
        private final int profondeur;
        /** Points par côté de chaque pixel. */
        private final int points;

        Cas(Scene scene, Camera camera, int profondeur, int points) {
            this.scene = scene.avec(scene.getModele().avecSeuil(0));
            this.camera = camera;
            this.profondeur = profondeur;
            this.points = points;
        }

        long rayons() {
            return (long) camera.getLargeur() * camera.getHauteur() * points * points;
        }

        Compteurs compter(Scene cherchee) {
            Lancer lancer = new Lancer(cherchee.avec(cherchee.getModele()), camera);
            for (int y = 0; y < camera.getHauteur() * points; y++) {
                for (int x = 0; x < camera.getLargeur() * points; x++) {
                    lancer.getCouleurPixel((x + 0.5) / points, (y + 0.5) / points, profondeur);
                }
            }
            return lancer.getScene().getCompteurs();
        }
    }

    private static Map<String, Cas> cas() {
        Map<String, Cas> cas = new LinkedHashMap<>();
        for (int taille : new int[] {300, 3000}) {
            ScenesDEssai.hostiles(taille).forEach((nom, scene) -> {
                // là où tout est partout, et chaque rayon long pour tous : moins de rayons
                boolean longs = scene.getLampes().size() > 100 || nom.matches(".*(coquilles|un seul point|mêlées).*");
                cas.put(nom + ", " + taille, new Cas(scene, longs ? new Camera(20, 15) : CAMERA, 3, 1));
            });
        }
        Random hasard = new Random(3);
        List<Sphere> recouvertes = new ArrayList<>();
        for (int k = 0; k < 300; k++) {
            recouvertes.add(new Sphere(new Point(8 * hasard.nextDouble() - 4, 6 * hasard.nextDouble() - 3, 4 + 12 * hasard.nextDouble()),
                    0.3 + hasard.nextDouble()));
            recouvertes.get(k).setKs(new Couleur(0.6));
        }
        cas.put("des boules qui se recouvrent", new Cas(new Scene(recouvertes, List.of(new Lampe(new Point(-5, 8, -6), new Couleur(1)))),
                CAMERA, 4, 1));
        // sous toutes les boîtes, il y a une boule proche : seule l'entrée exacte dans une boîte l'écarte
        List<Sphere> proches = new ArrayList<>();
        for (int k = 0; k < 1000; k++) {
            proches.add(new Sphere(new Point(2 * hasard.nextDouble() - 1, 2 * hasard.nextDouble() - 1, 7 + 2 * hasard.nextDouble()),
                    1 + 2 * hasard.nextDouble()));
        }
        cas.put("dans l'arbre seul", new Cas(new Scene(proches, List.of(new Lampe(new Point(-10, 15, -12), new Couleur(1)))),
                new Camera(12, 9), 3, 1));
        cas.put("25 sphères, 5 000 lampes", new Cas(ScenesDEssai.foule(25, 25, 0).lampes(5000).scene(), new Camera(6, 4), 5, 1));
        cas.put("24 sphères, 5 000 lampes", new Cas(ScenesDEssai.foule(24, 24, 0).lampes(5000).scene(), new Camera(6, 4), 5, 1));
        cas.put("trois reflets plus loin", new Cas(ScenesDEssai.entreDeuxMiroirs(5000), new Camera(100, 2), 5, 1));
        cas.put("dix reflets plus loin", new Cas(ScenesDEssai.entreDeuxMiroirs(3000), new Camera(60, 2), 10, 1));
        cas.put("mille reflets permis", new Cas(ScenesDEssai.entreDeuxMiroirs(3000), new Camera(16, 1), 1000, 1));
        cas.put("mille points par pixel", new Cas(ScenesDEssai.foule(26, 5000, 0).scene(), new Camera(3, 3), 5, 32));
        cas.put("seize points par pixel", new Cas(ScenesDEssai.foule(26, 2000, 0).scene(), new Camera(12, 12), 5, 4));
        cas.put("lampes dans la première", new Cas(ScenesDEssai.lampesDansUneSphere(3000, 0, 100), new Camera(20, 15), 2, 1));
        cas.put("lampes dans la vingtième", new Cas(ScenesDEssai.lampesDansUneSphere(3000, 19, 100), new Camera(20, 15), 2, 1));
        cas.put("une lampe dans la première", new Cas(ScenesDEssai.lampesDansUneSphere(3000, 0, 1), new Camera(60, 45), 5, 1));
        return cas;
    }

    /**
     * À deux centièmes près, les examens de chaque scène : un cube, une boîte, une enveloppe ou un objet regardés pour un rayon. Après un
     * changement voulu, {@code -Dcomptes.refaits=true} récrit le fichier, si aucune scène ne coûte trois fois ce que coûtent les boucles ou
     * un arbre simple, que lui seul compile.
     */
    @Tag("long")
    @Test
    void chaqueSceneCouteLesExamensQueDitLeFichier(@TempDir Path dossier) throws Exception {
        boolean refaire = Boolean.getBoolean("comptes.refaits");
        List<String> attendues = List.of(Essai.ressource(ComptesTest.class, "comptes.txt").split("\\R"));
        List<String> lignes = new ArrayList<>();
        List<String> fautes = new ArrayList<>();
        for (Map.Entry<String, Cas> e : cas().entrySet()) {
            Cas cas = e.getValue();
            Compteurs rapide = cas.compter(Preparation.preparer(cas.scene, cas.camera, cas.rayons()));
            String debut = e.getKey() + " : ";
            lignes.add(debut + cout(rapide));
            String attendue = attendues.stream().filter(ligne -> ligne.startsWith(debut)).findFirst().orElse(debut + 0);
            double examens = Double.parseDouble(attendue.substring(debut.length()));
            if (refaire ? cout(rapide) > permis(cas, rapide, dossier) : Math.abs(cout(rapide) - examens) > 0.02 * examens) {
                fautes.add(debut + cout(rapide) + " examens, au lieu de " + examens);
            }
        }
        assertEquals(List.of(), fautes);
        if (refaire) {
            Files.write(Path.of("src/test/resources/lancer/rapide/comptes.txt"), lignes);
        }
    }

    private static double permis(Cas cas, Compteurs rapide, Path dossier) throws Exception {
        ToolProvider.getSystemJavaCompiler().run(null, null, null, "-d", dossier.toString(), "-cp",
                System.getProperty("java.class.path"), "src/test/resources/lancer/rapide/ArbreSimple.java");
        List<Objet3D> objets = cas.scene.getObjets();
        try (URLClassLoader classes = new URLClassLoader(new URL[] {dossier.toUri().toURL()})) {
            Recherche arbre = (Recherche) classes.loadClass("lancer.rapide.ArbreSimple").getConstructor(List.class, Compteurs.class)
                    .newInstance(objets, new Compteurs());
            // une construction d'arbre est permise
            return AU_PLUS * (double) Math.min(rapide.rayons() * objets.size(), cout(cas.compter(cas.scene.avec(arbre))))
                    + PLUS * rapide.rayons() + 10 * objets.size() * Math.log(objets.size()) / Math.log(2);
        }
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
                assertThrows(CancellationException.class, () -> Regard.regarder(cellules, CAMERA));
            } finally {
                assertTrue(Thread.interrupted(), "le fil appelant reste interrompu");
            }
            assertTrue(lancer.getScene().getCompteurs().ombre <= 256, "ombres : " + lancer.getScene().getCompteurs().ombre);
        }
    }

    /** Ici, dans les cubes de l'espace, avant ceux de l'œil. */
    @Test
    void unePreparationInterrompueSArrete() {
        List<Objet3D> objets = new ArrayList<>(ScenesDEssai.foule(7, 60, 0).scene().getObjets());
        objets.add(new Sphere(new Point(), 1) {
            @Override
            public Sphere getEnveloppe() {
                Thread.currentThread().interrupt();
                return null;
            }
        });
        Camera camera = new Camera(80, 60) {
            @Override
            public Point getOeil() {
                throw new AssertionError("la préparation continue");
            }
        };
        try {
            assertThrows(CancellationException.class, () -> Structuree.scene(new Scene(objets, List.of()), camera));
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
