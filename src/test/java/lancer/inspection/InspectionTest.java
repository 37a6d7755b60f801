package lancer.inspection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Echantillonnage;
import lancer.contrat.Modele;
import lancer.contrat.Releve;
import lancer.essai.Essai;
import lancer.essai.Modification;
import lancer.essai.Ressources;
import lancer.scene.LecteurScene;
import lancer.scene.SceneLue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Ce que {@code --pixel} dit d'un pixel : chaque terme est celui de l'énoncé, et chaque somme se ferme au bit près. */
class InspectionTest {

    private static final Lampe DERRIERE = new Lampe(new Point(0, 0, -5), new Couleur(1));

    @TempDir
    Path dossier;

    /** Le pixel de cette scène, inspecté. */
    private static Inspection inspecter(Scene scene, Function<Object, String> origines, Camera camera, int reflets, int x, int y) {
        Inspection pixel = new Inspection(scene, origines, camera, reflets, x, y);
        pixel.faire(() -> false);
        return pixel;
    }

    /** Le pixel du milieu d'une image de 9 pixels de côté. */
    private static Inspection auMilieu(Scene scene) {
        return inspecter(scene, chose -> null, new Camera(9, 9), 5, 4, 4);
    }

    private static List<String> recitDe(Inspection pixel) {
        return new Recit(pixel, Double::toString, Double::toString).raconter().lignes();
    }

    private static Scene scene(Sphere boule, Lampe... lampes) {
        return new Scene(List.of(boule), List.of(lampes));
    }

    /** Une boule devant l'écran, dont un étudiant a écrit getColor à sa façon : de la couleur des équations, celle-ci. */
    private static class Boule extends Sphere {

        private final UnaryOperator<Couleur> sienne;

        Boule(double z, double rayon, UnaryOperator<Couleur> sienne) {
            super(new Point(0, 0, z), rayon);
            this.sienne = sienne;
        }

        @Override
        public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
            return sienne.apply(super.getColor(scene, incident, contact, profondeur));
        }
    }

    @ParameterizedTest
    @CsvSource({"p1-quatre, 5, 0.0009765625, Ks nul", "p2-sol, 5, 0, ciel", "p3-miroirs, 9, 0, ciel", "p3-miroirs, 40, 0.3, poids",
        "p4-foule, 1, 0.0009765625, réflexion", "p4-foule, 0, 0, réflexion"})
    void chaqueTermeEstCeluiDesEquationsEtChaqueSommeSeFerme(String nom, int reflets, double seuil, String arret) {
        Scene scene = new Scene(Ressources.chemin("reference/" + nom + ".ini")).avec(new Modele().avecSeuil(seuil));
        EssaiSegments essai = new EssaiSegments(scene, reflets, null, null, 0);
        Random hasard = new Random(5);
        for (int k = 0; k < 200; k++) {
            essai.verifier(inspecter(scene, chose -> null, new Camera(80, 60), reflets, hasard.nextInt(80), hasard.nextInt(60)));
        }
        assertTrue(essai.contacts > 60 && essai.eclairees > 20, essai.contacts + " contacts, " + essai.eclairees);
        assertTrue(essai.arrets.contains(arret), essai.arrets.toString());
        if (nom.equals("p2-sol") || nom.equals("p4-foule")) {
            assertTrue(essai.cachees > 5, essai.cachees + " lampes cachées");
        }
    }

    /** Le texte entier, à quatre décimales : deux reflets, une lampe cachée, une autre dans le dos, des rivaux. */
    @Test
    void leTexteEstCeluiQueLOnARelu() throws IOException {
        SceneLue lue = LecteurScene.lire(Ressources.chemin("reference/recit.ini"), part -> { });
        Scene scene = new Scene(lue.objets, lue.lampes);
        DoubleFunction<String> court = x -> String.format(Locale.ROOT, "%.4f", x);
        String dit = String.join("\n", new Recit(inspecter(scene, lue::getOrigine, new Camera(80, 60), 2, 40, 42), court, court)
                .raconter().lignes());
        assertEquals(Essai.ressource(InspectionTest.class, "/reference/recit.txt").trim(), dit);
    }

    /** Ce qu'un étudiant change dans getColor : un terme de plus, un facteur oublié, le dernier terme seul, deux couleurs échangées. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void ceQueLesTermesNExpliquentPasEstAutre(int change) {
        UnaryOperator<Couleur> fausse = List.<UnaryOperator<Couleur>>of(c -> c.add(new Couleur(0.1, 0.02, 0.3)), c -> c.div(7),
                c -> new Couleur(), c -> new Couleur(c.b, c.v, c.r)).get(change);
        List<Boule> boules = List.of(new Boule(8, 2, fausse), new Boule(-9, 3, fausse));
        for (Boule boule : boules) {
            boule.setKd(new Couleur(0.2, 0.3, 0.9));
            boule.setKs(new Couleur(0.5));
        }
        Inspection pixel = auMilieu(new Scene(boules, List.of(new Lampe(new Point(0, 5, 0), new Couleur(1)))));
        assertEquals(6, pixel.getSegments().size());
        List<String> lignes = recitDe(pixel);
        for (Segment segment : pixel.getSegments()) {
            Couleur termes = segment.eclairages.get(0).apport;
            Couleur somme = segment.reflet == null ? termes : termes.add(segment.reflet);
            assertEquals(segment.somme.sub(somme), segment.autre);
            assertNotEquals(new Couleur(), segment.autre);
            assertTrue(lignes.contains("  autre = " + composantes(segment.autre) + " (que le récit ne connaît pas)"), lignes.toString());
        }
        assertEquals(pixel.getCouleur(), pixel.getSegments().get(0).somme);
    }

    private static String composantes(Couleur c) {
        return c.r + " " + c.v + " " + c.b;
    }

    @Test
    void uneReflexionDevieeEstSuivie() {
        Sphere deviee = new Sphere(new Point(0, 0, 8), 2) {
            @Override
            public Vecteur getReflexion(Vecteur V, Vecteur N) {
                return new Vecteur(0, 1, 0);
            }
        };
        deviee.setKs(new Couleur(0.5));
        Inspection pixel = auMilieu(scene(deviee));
        assertEquals(new Vecteur(0, 1, 0), pixel.getSegments().get(1).rayon.getV());
        assertEquals(new Couleur(), pixel.getSegments().get(0).autre);
    }

    /** Ce que Lancer ajoute après getColor : ici, la caméra regarde ailleurs quand elle est interrogée de nouveau. */
    @Test
    void ceQuiChangeApresGetColorEstAutre() {
        Camera camera = new Camera(9, 9) {
            private int fois;

            @Override
            public Rayon getRayon(double xe, double ye) {
                return super.getRayon(xe, fois++ == 0 ? 0 : ye);
            }
        };
        Inspection pixel = inspecter(new Scene(List.of(), List.of()), chose -> null, camera, 5, 4, 4);
        Couleur autre = pixel.getCouleur().sub(pixel.getSegments().get(0).somme);
        assertNotEquals(new Couleur(), autre);
        List<String> lignes = recitDe(pixel);
        assertEquals("autre = " + composantes(autre) + " (que le récit ne connaît pas)", lignes.get(lignes.size() - 2));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"Couleur | v + c.v | v", "Scene | (recherche.aEgalite(plusProche), distance) | "
            + "(recherche.aEgalite(plusProche), 1.001 * distance)"})
    void laSommeDUnPixelEstLaCouleurDessineeQuoiQuUnEtudiantChange(String classe, String ancienne, String nouvelle) throws IOException {
        try (Essai.Isole programme = Modification.de(dossier, classe, ancienne, nouvelle)) {
            String pfm = dossier.resolve("i.pfm").toString();
            assertEquals("", programme.executer("--taille=120x90", "--lineaire", pfm, "scenes/scene1.ini").erreur);
            float[] image = Essai.pfm(Files.readAllBytes(dossier.resolve("i.pfm")));
            for (int[] pixel : new int[][] {{60, 55}, {31, 62}, {88, 49}, {12, 80}}) {
                String dit = programme.executer("--taille=120x90", "--pixel", pixel[0] + "," + pixel[1], "scenes/scene1.ini").sortie;
                String[] somme = dit.substring(dit.lastIndexOf("somme ")).split(" ");
                for (int c = 0; c < 3; c++) {
                    assertEquals(image[3 * ((89 - pixel[1]) * 120 + pixel[0]) + c], (float) Double.parseDouble(somme[1 + c]), dit);
                }
            }
        }
    }

    /** De la cible, la lampe est dans la direction (0, 30, −49) ; les sphères sont à ces parts du chemin. */
    @ParameterizedTest
    @CsvSource({"1, 0.2, 0.6, haute", "1e4, 1e-3, 2e-3, basse", "1e4, 1e-3, 0.9, basse", "1e4, -1e-3, 0.9, haute",
        "1e9, 1e-8, 2e-8, basse", "1e9, -1e-8, 0.9, haute"})
    void celleQuiCacheEstLaPremiereDepuisLaLampeOuDepuisLeContactSiElleEstLointaine(double loin, double basse, double haute, String qui)
            throws Exception {
        Path scene = Essai.scene(dossier.resolve("s.ini"), "[Sphere cible]", "centre=0 0 10", "rayon=1", "Kd=1 1 1", "[Sphere basse]",
                "centre=" + surLeChemin(loin * basse), "rayon=1", "[Sphere haute]", "centre=" + surLeChemin(loin * haute),
                "rayon=" + Math.max(1, loin * haute / 100), "[Lampe]", "position=" + surLeChemin(loin), "couleur=1 1 1");
        Essai e = Essai.executer("--taille=9x9", "--pixel=4,4", scene.toString());
        assertTrue(e.sortie.contains("  cachée par [Sphere " + qui + "] ligne "), e.toString());
    }

    private static String surLeChemin(double part) {
        return "0 " + 30 * part + " " + (9 - 49 * part);
    }

    @Test
    void leDepartNeDependPasDuNombreDeReflexionsPermises() {
        Scene scene = new Scene(Ressources.chemin("reference/p3-miroirs.ini"));
        List<Integer> segments = new ArrayList<>();
        for (int reflets : new int[] {0, 1, 3}) {
            Inspection pixel = inspecter(scene, chose -> null, new Camera(80, 60), reflets, 40, 30);
            segments.add(pixel.getSegments().size());
            List<String> lignes = recitDe(pixel);
            String arret = lignes.stream().filter(ligne -> ligne.startsWith("  arrêt : ")).findFirst().get();
            assertTrue(lignes.indexOf(arret) < lignes.size() - 2 || reflets == 0, "la chaîne va du dernier contact au premier");
            assertTrue(arret.matches("  arrêt : (ciel|" + reflets + " réflexions?)"), arret);
        }
        assertEquals(1, segments.get(0));
        assertTrue(segments.get(1) == 2 && segments.get(2) >= 2, segments.toString());
    }

    /** Ce que la classe demande d'abord d'un pixel noir ou d'un ciel. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "[Sphere] centre=0,0,9 rayon=1 Kd=1,1,1 | 1  [Sphere] ligne 1  0.0 0.0 0.0 : rien ne l'éclaire "
            + "| aucune lampe dans la scène : rien ne l'éclaire",
        "[Lampe] position=0,5,0 couleur=1,1,1 | 1  ciel  | aucun objet dans la scène",
        "[Sphere] centre=0,0,-9 rayon=1 [Lampe] position=0,5,0 couleur=1,1,1 | 1  ciel  | arrêt : ciel",
        "[Sphere] centre=9,0,9 rayon=1 | 1  ciel  | arrêt : ciel",
        "[Sphere] centre=0,0,9 rayon=1 Kd=1,1,1 [Lampe] position=0,0,99 couleur=1,1,1 "
            + "| 1  [Sphere] ligne 1  0.0 0.0 0.0 : rien ne l'éclaire "
            + "| [Lampe] ligne 5  N·(lampe − contact) = -91.0  dans le dos : pas de rayon d'ombre"})
    void ceQuiManqueAUnPixelNoirSeDit(String ini, String titre, String premiere) throws Exception {
        Path fichier = Essai.scene(dossier.resolve("s.ini"), ini.replace(" ", "\n").replace(',', ' ').split("\n"));
        List<String> lignes = List.of(Essai.executer("--taille=9x9", "--pixel=4,4", fichier.toString()).sortie.split("\\R"));
        assertTrue((lignes.get(1) + "  ").startsWith(titre), lignes.toString());
        assertEquals("  " + premiere, lignes.get(2));
    }

    @Test
    void unNombreDuFichierSeDitCommeIlYEstEcrit() throws Exception {
        Path fichier = Essai.scene(dossier.resolve("s.ini"), "[Sphere]", "centre=0 0 9", "rayon=1", "Kd=0.93 0.06 1", "Ks=0.68 0.68 0.68",
                "ns=80", "[Lampe]", "position=0 0 0", "couleur=1.12 1 0.0005");
        String dit = Essai.executer("--taille=9x9", "--pixel=4,4", fichier.toString()).sortie;
        assertTrue(dit.contains("    diffus = Kd (0.93 0.06 1) ⊗ lampe (1.12 1 0.0005) × N·L 1.0 = "), dit);
        assertTrue(dit.contains("    reflet = Ks (0.68 0.68 0.68) ⊗ lampe (1.12 1 0.0005) × (R·L 1.0)^80 = "), dit);
        assertTrue(dit.contains(" = diffus + reflet + 0.68 ⊗ somme 2\n".replace("\n", System.lineSeparator())), dit);
        assertTrue(dit.indexOf("2  ciel") < dit.indexOf("⊗ somme 2"), dit);
    }

    @Test
    void unPixelDontLeRayonMemeEchoueSeRaconteJusquALaFaute() {
        Camera camera = new Camera(9, 9) {
            @Override
            public Rayon getRayon(double xe, double ye) {
                throw new IllegalStateException("pas encore écrit");
            }
        };
        List<String> lignes = recitDe(inspecter(new Scene(List.of(), List.of()), chose -> null, camera, 5, 4, 4));
        assertEquals("pixel 4, 4", lignes.get(0));
        assertTrue(lignes.get(1).startsWith("échec : java.lang.IllegalStateException: pas encore écrit ("), lignes.toString());
        assertEquals(2, lignes.size());
    }

    /** Le récit d'une sphère qui se colore à sa façon, selon cet échantillonnage. */
    private static List<String> recitDUneForme(Sphere sphere, Echantillonnage echantillonnage) {
        return recitDe(auMilieu(scene(sphere, DERRIERE).avec(new Modele().avec(echantillonnage, Constantes.SEUIL))));
    }

    /** Neuf échantillons, et le pixel vaut leur somme divisée par ce nombre. */
    private static Echantillonnage neuf(double diviseur) {
        return (pave, voulus, vue, toile) -> {
            Couleur somme = new Couleur();
            for (int k = 0; k < 9; k++) {
                somme = somme.add(vue.couleur(4 + (k % 3 + 0.5) / 3, 4 + (k / 3 + 0.5) / 3));
            }
            toile.drawPixel(somme.div(diviseur), 4, 4);
            return Releve.RIEN;
        };
    }

    @Test
    void laCouleurDUneFormeQuiSeColoreASaFaconEstAutre() {
        Sphere sphere = new Boule(8, 2, c -> new Couleur(0.25, 0.5, 0.75));
        List<String> lignes = recitDUneForme(sphere, neuf(9));
        assertEquals("9 échantillons", lignes.get(1));
        assertEquals("leur somme = 2.25 4.5 6.75, divisée par 9 pour le pixel", lignes.get(11));
        assertEquals(List.of("chaîne de l'échantillon 4.5 4.5", "1  objet 1  0.25 0.5 0.75 = autre",
                "  lampe 1  N·L = 1.0  sans effet sur cette matière : pas de rayon d'ombre",
                "  autre = 0.25 0.5 0.75 (que le récit ne connaît pas)"), lignes.subList(12, 16));
        assertEquals(List.of("  arrêt : Ks nul", "somme 0.25 0.5 0.75 = #4080BF"), lignes.subList(lignes.size() - 2, lignes.size()));
        lignes = recitDUneForme(sphere, neuf(18));
        assertEquals("leur moyenne = 0.25 0.5 0.75 ; l'échantillonnage les pèse autrement pour le pixel", lignes.get(11));
    }

    @Test
    void uneFormeSansNormaleDitSaCouleurEtPourquoiLeRecitSArrete() {
        List<String> lignes = recitDUneForme(new Sphere(new Point(0, 0, 8), 2) {
            @Override
            public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
                return new Couleur(0.5);
            }

            @Override
            public Vecteur getNormale(Point contact) {
                throw new IllegalStateException("pas encore écrite");
            }
        }, Lancer::TracerPave);
        assertEquals(List.of("1  objet 1  0.5 0.5 0.5 = autre", "  autre = 0.5 0.5 0.5 (que le récit ne connaît pas)"),
                lignes.subList(1, 3));
        assertTrue(lignes.get(lignes.size() - 2).startsWith("échec : java.lang.IllegalStateException: pas encore écrite ("),
                lignes.toString());
        assertEquals("somme 0.5 0.5 0.5 = #808080", lignes.get(lignes.size() - 1));
    }

    @Test
    void lesSegmentsQuiPrecedentUnEchecSeDisent() {
        Sphere miroir = new Sphere(new Point(0, 0, 8), 2);
        miroir.setKs(new Couleur(0.5));
        Sphere derriere = new Boule(-50, 9, c -> {
            throw new IllegalStateException("boum");
        });
        Inspection pixel = auMilieu(new Scene(List.of(miroir, derriere), List.of()));
        assertEquals("boum", pixel.getFaute().getCause().getMessage());
        List<String> lignes = recitDe(pixel);
        assertEquals(List.of("2  objet 2", "1  objet 1"),
                lignes.stream().filter(ligne -> ligne.matches("\\d+  .*")).collect(Collectors.toList()));
        assertTrue(lignes.get(lignes.size() - 1).startsWith("échec : java.lang.IllegalStateException: boum ("), lignes.toString());
    }

    /** Une forme peut rendre sa distance sans la noter dans le rayon. */
    @Test
    void unRivalQuiNeNoteRienSeDit() {
        Sphere muette = new Sphere(new Point(0, 0, 12), 2) {
            @Override
            public double getIntersectionDistance(Rayon incident) {
                return 10;
            }
        };
        List<String> lignes = recitDe(auMilieu(new Scene(List.of(new Sphere(new Point(0, 0, 8), 2), muette), List.of())));
        assertTrue(lignes.contains("    rival objet 2  d = 10.0"), lignes.toString());
    }
}
