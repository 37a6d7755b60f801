package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.ReglagePropose;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.dessin.Dessin;
import lancer.essai.Plan;
import lancer.scene.SectionLue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Ce que choisit {@code --auto} là où l'on sait d'avance ce qu'il faut, et ce qu'il dit de l'image. */
class AutoTest {

    private static final Couleur GRIS = new Couleur(0.5);

    /** Paire, l'horizon passe entre deux lignes de pixels. */
    private static final int HAUTEUR = 30;
    private static final int LARGEUR = 40;

    private static final Map<Variante, Section> SANS = Collections.emptyMap();
    private static final Map<Variante, Section> GRILLES = GrilleDEssai.seule("1", "2", "4", "16");

    private static Auto auto(Scene scene, int largeur, int hauteur, Map<Variante, Section> variantes, double voulue) {
        return new Auto(Dessin.lancer(scene, largeur, hauteur, false), voulue, null, null, 2, variantes, enCours -> { });
    }

    /** Dessine, et contrôle. @return les couleurs de l'image, ligne par ligne */
    private static Couleur[] dessiner(Auto auto) {
        int largeur = auto.lancer.getCamera().getLargeur();
        Couleur[] image = new Couleur[largeur * auto.lancer.getCamera().getHauteur()];
        auto.lancer.TracerPixels(auto.surveiller((couleur, i, j) -> image[j * largeur + i] = couleur, auto.choisi), auto.choisi.reflets, 2);
        return image;
    }

    private static Scene scene(Objet3D... objets) {
        return new Scene(Arrays.asList(objets), Arrays.asList(new Lampe(new Point(-3, 5, -5), new Couleur(0.8))));
    }

    private static Sphere boule(double x, double y, double z, double rayon, double ks) {
        Sphere boule = new Sphere(new Point(x, y, z), rayon);
        boule.setKd(GRIS);
        boule.setKs(new Couleur(ks));
        return boule;
    }

    private static Scene quelquesBoules() {
        return scene(boule(-1, 0, 8, 1.2, 0.5), boule(1.2, 0.4, 7, 0.7, 0.8), boule(0, -1001.5, 8, 1000, 0.3));
    }

    /** Un mur sans fin qui luit et reflète : entre deux, un rayon ne s'arrête jamais. */
    private static final class Mur extends Plan {

        private final double lueur;

        Mur(double z, double ks, double lueur) {
            super(new Point(0, 0, z), new Vecteur(0, 0, -Math.signum(z)));
            this.lueur = lueur;
            setKs(new Couleur(ks));
        }

        @Override
        public Couleur getColor(Scene scene, Rayon incident, PointContact contact, int profondeur) {
            return super.getColor(scene, incident, contact, profondeur).add(new Couleur(lueur));
        }
    }

    /** Entre deux murs, la couleur vue est la somme d'une série géométrique, de limite 0,9. */
    private static Scene entreDeuxMurs(double ks) {
        double lueur = 0.9 * (1 - ks);
        return new Scene(Arrays.asList(new Mur(10, ks, lueur), new Mur(-10, ks, lueur)), Collections.<Lampe>emptyList());
    }

    /** Sous ce seuil du produit des Ks, le nombre de reflets suivis. */
    private static int suivis(double ks, double seuil) {
        int suivis = 0;
        while (Math.pow(ks, suivis + 1) >= seuil) {
            suivis++;
        }
        return suivis;
    }

    /** Il manque à la série 255 × 0,9 × ks^(suivis + 1) niveaux : au plus un sixième du carré de l'erreur voulue, à peu près. */
    @ParameterizedTest
    @CsvSource({"0.5, 20, 0.0625", "0.5, 8, 0.015625", "0.5, 3, 0.00390625", "0.2, 4, 0.00390625", "0.8, 50, 0.0625"})
    void entreDeuxMiroirsLeSeuilEstCeluiDeLaSerie(double ks, double erreur, double seuil) {
        Auto auto = auto(entreDeuxMurs(ks), 16, 12, SANS, erreur);
        assertEquals(seuil, auto.choisi.seuil);
        assertTrue(auto.choisi.auPlus <= erreur);
        double manque = 255 * 0.9 * Math.pow(ks, suivis(ks, seuil) + 1);
        assertEquals(manque, auto.choisi.erreur, 0.02 * manque);
        // l'écran, et autant de reflets : les murs n'ont pas d'ombre
        assertEquals(1 + suivis(ks, seuil), auto.choisi.prix, 1e-9);
        dessiner(auto);
        assertEquals(manque, auto.getErreurMesuree(), 0.02 * manque);
        assertEquals("erreur voulue tenue", auto.getVerdict());
    }

    @Test
    void ceQuiEstFixeResteEtLeResteSeChoisit() {
        Lancer prepare = Dessin.lancer(entreDeuxMurs(0.5), 16, 12, false);
        Auto auto = new Auto(prepare, 8, 7, null, 2, SANS, enCours -> { });
        assertEquals("un rayon par pixel, --reflets 7 --seuil 0.015625", auto.choisi.toString());
        auto = new Auto(prepare, 1, 3, 0.25, 2, SANS, enCours -> { });
        assertEquals("un rayon par pixel, --reflets 3 --seuil 0.25", auto.choisi.toString());
        assertTrue(auto.choisi.auPlus > 1);
    }

    @Test
    void leCielNeDemandeQuUnRayonParPixel() {
        Scene ciel = new Scene(Collections.<Objet3D>emptyList(), Collections.<Lampe>emptyList());
        Auto auto = auto(ciel, LARGEUR, HAUTEUR, GRILLES, 0.1);
        assertEquals("[Grille] n=1", auto.choisi.section.toString());
        assertEquals(1, auto.choisi.prix);
        dessiner(auto);
        assertTrue(auto.getIncertitude() >= 0.01, "jamais ± 0,00");
    }

    @Test
    void desBoulesPlusPetitesQuUnPixelDemandentPlusieursRayons() {
        Auto auto = auto(damier(), LARGEUR, HAUTEUR, GRILLES, 4);
        assertTrue(auto.choisi.auPlus <= 4 && auto.choisi.prix >= 4, auto.choisi.toString());
        assertEquals("[Grille] n=1", auto(damier(), LARGEUR, HAUTEUR, GRILLES, 100).choisi.section.toString());
    }

    /** Là où la base est seule, ce qui manque est nommé. */
    @Test
    void ceQuiNEstPasTenuEstDitAvecCeQuiAiderait() {
        Auto auto = auto(damier(), LARGEUR, HAUTEUR, SANS, 4);
        assertTrue(auto.choisi.auPlus > 4);
        dessiner(auto);
        assertTrue(auto.getErreurMesuree() > 4);
        assertTrue(auto.getVerdict().matches("erreur voulue dépassée : .*antialias/target/antialias\\.jar.*"), auto.getVerdict());
        Auto grilles = auto(damier(), LARGEUR, HAUTEUR, GrilleDEssai.seule("1", "2"), 0.1);
        dessiner(grilles);
        assertTrue(grilles.getVerdict().matches("erreur voulue dépassée : .*n=64.*"), grilles.getVerdict());
    }

    /** Des boules d'un quart de pixel, un pixel sur deux. */
    private static Scene damier() {
        double pixel = Constantes.ECHELLE / LARGEUR;
        int colonnes = LARGEUR / 2;
        Objet3D[] boules = new Objet3D[colonnes * HAUTEUR / 2];
        for (int k = 0; k < boules.length; k++) {
            // presque sur l'écran, où la perspective ne change rien
            boules[k] = boule((2 * (k % colonnes) + 0.4 - colonnes) * pixel, (2 * (k / colonnes) + 0.4 - HAUTEUR / 2) * pixel, 0.01,
                    pixel / 2, 0);
        }
        return scene(boules);
    }

    /** Des boules de ce rayon, en pixels, au hasard dans l'image. */
    private static Scene petites(int combien, double rayon, double ks, long graine, int largeur) {
        SplittableRandom hasard = new SplittableRandom(graine);
        List<Sphere> boules = new ArrayList<>();
        for (int k = 0; k < combien; k++) {
            double z = 6 + hasard.nextDouble(2);
            double champ = (z + Camera.FOCALE) / Camera.FOCALE;
            boules.add(boule(hasard.nextDouble(-1, 1) * champ, hasard.nextDouble(-0.75, 0.75) * champ, z,
                    rayon * Constantes.ECHELLE / largeur * champ, ks));
        }
        return scene(boules.toArray(new Objet3D[0]));
    }

    /** L'erreur vraie, sans biais ni limite : chaque pixel contre deux fois 64 rayons, chacun au hasard dans une case du pixel. */
    private static double vraie(Auto auto, Couleur[] image) {
        auto.lancer.getScene().getModele().setSeuil(0);
        int largeur = auto.lancer.getCamera().getLargeur();
        SplittableRandom hasard = new SplittableRandom(9);
        double somme = 0;
        for (int p = 0; p < image.length; p++) {
            double[][] justes = new double[2][];
            for (int r = 0; r < 2; r++) {
                Couleur moyenne = new Couleur();
                for (int k = 0; k < 64; k++) {
                    moyenne = moyenne.add(auto.lancer.getCouleurPixel(p % largeur + (k % 8 + hasard.nextDouble()) / 8,
                            p / largeur + (k / 8 + hasard.nextDouble()) / 8, 60));
                }
                justes[r] = EchantillonPilote.niveaux(moyenne.div(64));
            }
            somme += EchantillonPilote.produit(EchantillonPilote.niveaux(image[p]), justes[0], justes[1]);
        }
        return Math.sqrt(Math.max(0, somme / image.length));
    }

    /** Vingt étoiles d'un pixel dans un ciel uni : aucun tirage au hasard ne les trouve ; la scène sait où elles sont. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void vingtEtoilesDUnPixelNeSontPasManquees(long graine) {
        Auto auto = auto(petites(20, 0.5, 0, graine, 60), 60, 45, SANS, 0.3);
        Couleur[] image = dessiner(auto);
        double vraie = vraie(auto, image);
        assertTrue(vraie > 0.3, "" + vraie);
        assertEquals(vraie, auto.getErreurMesuree(), 0.2 * vraie);
        assertTrue(auto.getVerdict().startsWith("erreur voulue dépassée"), auto.getVerdict());
        Auto grilles = auto(petites(20, 0.5, 0, graine, 60), 60, 45, GRILLES, 1);
        image = dessiner(grilles);
        assertTrue(vraie(grilles, image) <= 1, grilles.choisi.toString());
    }

    /** Quarante petites boules qui se reflètent les unes les autres. */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1, 2, 4})
    void quarantePetitesBoulesBrillantesNeSontJamaisDitesTenuesATort(double voulue) {
        for (double rayon : new double[] {0.7, 2}) {
            Auto auto = auto(petites(40, rayon, 0.8, 11, 60), 60, 45, GRILLES, voulue);
            Couleur[] image = dessiner(auto);
            double vraie = vraie(auto, image);
            String dit = vraie + ", " + auto.choisi + ", " + auto.getVerdict();
            assertTrue(vraie <= 1.1 * voulue || !auto.getVerdict().equals("erreur voulue tenue"), dit);
            assertTrue(auto.getVerdict().startsWith("erreur voulue dépassée")
                    || vraie <= 2 * auto.getErreurMesuree() + 2 * auto.getIncertitude(), dit);
        }
    }

    @Test
    void leChoixNeDependPasDesFils() {
        for (double erreur : new double[] {0.5, 3}) {
            String attendu = null;
            for (int fils : new int[] {1, 2, 7}) {
                Auto auto = new Auto(Dessin.lancer(quelquesBoules(), 80, 70, false), erreur, null, null, fils, GRILLES,
                        enCours -> { });
                Candidat r = auto.choisi;
                String choix = r + " " + r.erreur + " " + r.auPlus + " " + r.prix + " " + auto.getRayonsDesEssais();
                attendu = attendu == null ? choix : attendu;
                assertEquals(attendu, choix, fils + " fils");
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1, 7", "2, 2", "3, 1", "1, 300", "33, 65", "201, 151"})
    void touteTailleDImageConvient(int largeur, int hauteur) {
        Auto auto = auto(scene(boule(0, 0, 8, 2, 0.5)), largeur, hauteur, GRILLES, 1);
        dessiner(auto);
        assertTrue(auto.getErreurMesuree() < 10, auto.choisi + " " + auto.getVerdict());
    }

    @Test
    void sansErreurVoulueTousLesReglagesSontEssayes() {
        Auto auto = auto(scene(boule(0, 0, 8, 1.5, 0)), LARGEUR, HAUTEUR, GRILLES, 0);
        List<Candidat> front = auto.essayes;
        assertEquals(4, front.size());
        for (int k = 1; k < 4; k++) {
            assertTrue(front.get(k).nsParRayon > 0, "" + front.get(k));
            assertTrue(front.get(k).prix > front.get(k - 1).prix && front.get(k).erreur < front.get(k - 1).erreur, "" + front);
        }
        // une grille lance exactement n² rayons de l'écran, et les mêmes autres à peu près pour chacun
        assertEquals(16, front.get(2).prix / front.get(0).prix, 1);
    }

    @Test
    void chronometrerNeChangeQueLesDurees() {
        Auto auto = auto(scene(boule(0, 0, 8, 1.5, 0.5)), LARGEUR, HAUTEUR, GRILLES, 0);
        List<Candidat> avant = new ArrayList<>(auto.essayes);
        auto.chronometrer();
        assertEquals(avant.size(), auto.essayes.size());
        for (int k = 0; k < avant.size(); k++) {
            Candidat a = avant.get(k);
            Candidat b = auto.essayes.get(k);
            assertEquals(a + " " + a.prix + " " + a.auMoins + " " + a.erreur + " " + a.auPlus,
                    b + " " + b.prix + " " + b.auMoins + " " + b.erreur + " " + b.auPlus);
            assertTrue(b.nsParRayon > 0 && b.nsParRayon != a.nsParRayon, b.nsParRayon + " ns");
        }
    }

    /** Contrôle compris, et dans un pixel au besoin : vingt mille lampes en font autant de rayons pour un seul de l'écran. */
    @ParameterizedTest
    @CsvSource({"1, 40, 30", "1, 200, 150", "200, 40, 30", "20000, 3, 2"})
    void lesEssaisCoutentAuPlusLaMoitieDuDessinOuQuatreRayonsParPixelOuDeuxCentMille(int lampes, int largeur, int hauteur) {
        List<Lampe> toutes = Collections.nCopies(lampes, new Lampe(new Point(-3, 5, -5), new Couleur(0.8 / lampes)));
        for (double voulue : new double[] {50, 1}) {
            Auto auto = auto(new Scene(quelquesBoules().getObjets(), toutes), largeur, hauteur,
                    GrilleDEssai.seule("1", "2"), voulue);
            dessiner(auto);
            double permis = Math.max(200_000, Math.max(4.0 * largeur * hauteur, auto.lancer.getCompteurs().rayons() / 2.0));
            assertTrue(auto.getRayonsDesEssais() <= permis, auto.getRayonsDesEssais() + " pour " + permis + ", " + auto.choisi);
        }
    }

    @Test
    void unFilInterrompuAbandonneLesEssais() {
        Lancer prepare = Dessin.lancer(quelquesBoules(), 80, 60, false);
        Thread.currentThread().interrupt();
        try {
            assertThrows(CancellationException.class, () -> new Auto(prepare, 1, null, null, 2, GRILLES, enCours -> { }));
        } finally {
            assertTrue(Thread.interrupted(), "l'interruption reste à voir");
        }
    }

    @Test
    void unReglageFautifEstRefuseCommeUneSection() {
        Lancer lancer = Dessin.lancer(scene(boule(0, 0, 8, 1, 0)), 20, 15, false);
        Map<Variante, Section> fautive = GrilleDEssai.avec(
                Collections.singletonList(new ReglagePropose(new SectionLue("Grille", "m", "3"), 1, 1)));
        SceneFautive e = assertThrows(SceneFautive.class, () -> new Auto(lancer, 1, null, null, 1, fautive, enCours -> { }));
        assertEquals("réglage, [Grille], m : clé inconnue ; attendu : n", e.getMessage());
    }

    @Test
    void uneVarianteSansEchelleEstNommee() {
        Lancer lancer = Dessin.lancer(scene(boule(0, 0, 8, 1, 0)), 20, 15, false);
        Map<Variante, Section> muette = GrilleDEssai.avec(null);
        NullPointerException e = assertThrows(NullPointerException.class,
                () -> new Auto(lancer, 1, null, null, 1, muette, enCours -> { }));
        assertEquals(GrilleDEssai.class.getName() + ".getReglagesProposes a rendu null", e.getMessage());
    }
}
