package lancer.auto;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.SceneFautive;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Section;
import lancer.contrat.Variante;
import lancer.fils.Traceur;
import lancer.dessin.LancerSurveille;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ce que choisit {@code --auto} là où l'on sait d'avance ce qu'il faut. */
class AutoTest {

    private static final Couleur GRIS = new Couleur(0.5);

    /** Paire, l'horizon passe entre deux lignes de pixels. */
    private static final int HAUTEUR = 30;
    private static final int LARGEUR = 40;

    private static final List<Variante> GRILLES = GrilleDEssai.seule("1", "2", "4", "16");
    private static final List<Variante> MODESTES = GrilleDEssai.seule("1", "2", "3");

    private static Auto auto(Scene scene, int largeur, int hauteur, List<Variante> variantes, Souhait souhait) {
        return Auto.choisir(LancerSurveille.preparer(scene, largeur, hauteur, false), souhait, 2, variantes, enCours -> { });
    }

    private static Auto auto(Scene scene, Souhait souhait) {
        return auto(scene, LARGEUR, HAUTEUR, Collections.<Variante>emptyList(), souhait);
    }

    /** Entre deux murs, tous les pixels sont le même : il en suffit de peu. */
    private static Auto autoEntreDeuxMurs(double ks, Souhait souhait) {
        return auto(entreDeuxMurs(ks), 16, 12, Collections.<Variante>emptyList(), souhait);
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

    /** Un mur sans fin qui luit et reflète : entre deux, un rayon ne s'arrête jamais. */
    private static final class Mur extends Objet3D {

        private final double z;
        private final double lueur;

        Mur(double z, double ks, double lueur) {
            this.z = z;
            this.lueur = lueur;
            setKs(new Couleur(ks));
        }

        @Override
        public double getIntersectionDistance(Rayon incident) {
            double t = (z - incident.getP().z) / incident.getV().z;
            double d = t > 0 ? t : Double.POSITIVE_INFINITY;
            incident.setContact(this, d);
            return d;
        }

        @Override
        public Vecteur getNormale(Point contact) {
            return new Vecteur(0, 0, -Math.signum(z));
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

    /** La moindre profondeur après laquelle il manque moins que cela à la série : 255 × 0,9 × ks^(profondeur + 1) niveaux. */
    private static int profondeurQuIlFaut(double ks, double erreur) {
        int profondeur = 0;
        while (255 * 0.9 * Math.pow(ks, profondeur + 1) > erreur) {
            profondeur++;
        }
        return profondeur;
    }

    @ParameterizedTest
    @CsvSource({"0.5, 4", "0.5, 2", "0.5, 1", "0.5, 0.5", "0.9, 4", "0.9, 1", "0.2, 1", "0.97, 1"})
    void entreDeuxMiroirsLaProfondeurEstCelleDeLaSerie(double ks, double erreur) {
        Auto auto = autoEntreDeuxMurs(ks, Souhait.erreur(erreur).fixer(null, 0.0));
        int[] essayees = {0, 1, 2, 3, 4, 5, 7, 10, 15, 20, 30, 40, 60, 80, 120, 160, 240, 320, 480, 640, 1000};
        int attendue = Arrays.stream(essayees).filter(p -> p >= profondeurQuIlFaut(ks, erreur)).findFirst().getAsInt();
        assertEquals(attendue, auto.getChoisi().reflets);
        assertTrue(auto.estTenable());
        assertEquals(255 * 0.9 * Math.pow(ks, attendue + 1), auto.getChoisi().erreur, 1e-6);
        // l'écran, et autant de reflets : les murs n'ont pas d'ombre
        assertEquals(1 + attendue, auto.getChoisi().prix, 1e-9);
    }

    /** Devant un seul miroir, aucun rayon ne se réfléchit deux fois : ne rien limiter ne coûte rien de plus. */
    @Test
    void aPrixEgalLesRefletsVontAuBout() {
        Auto auto = auto(scene(boule(0, 0, 8, 1.5, 0.5)), Souhait.erreur(0.5));
        assertTrue(auto.getChoisi().toString().endsWith("--reflets 1000 --seuil 0"), auto.getChoisi().toString());
    }

    @Test
    void laProfondeurFixeeResteEtLeSeuilFaitLeReste() {
        Auto auto = autoEntreDeuxMurs(0.5, Souhait.erreur(1).fixer(1000, null));
        assertEquals(1000, auto.getChoisi().reflets);
        // 8 reflets ont un produit d'au moins 1/256 ; avec 6, soit 1/64, il manquerait 1,8 niveau
        assertTrue(auto.getChoisi().toString().endsWith("--reflets 1000 --seuil 0.00390625"), auto.getChoisi().toString());
        assertEquals(9, auto.getChoisi().prix, 1e-9);
        auto = autoEntreDeuxMurs(0.5, Souhait.erreur(1).fixer(3, 0.25));
        assertEquals("un rayon par pixel, --reflets 3 --seuil 0.25", auto.getChoisi().toString());
        assertFalse(auto.estTenable());
    }

    @ParameterizedTest
    @CsvSource({"255, 0", "4, 0", "0.01, 0", "0, 10", "0, 0.001"})
    void sansRefletsLaProfondeurEstNulle(double erreur, double temps) {
        Auto auto = auto(scene(boule(0, 0, 8, 1.5, 0), boule(0, -1001.5, 8, 1000, 0)),
                erreur > 0 ? Souhait.erreur(erreur) : Souhait.temps(temps));
        assertEquals(0, auto.getChoisi().reflets);
    }

    @Test
    void leCielNADemandeQuUnRayonParPixel() {
        Auto auto = auto(new Scene(Collections.<Objet3D>emptyList(), Collections.<Lampe>emptyList()), LARGEUR, HAUTEUR, GRILLES,
                Souhait.erreur(0.1));
        assertEquals("[Grille] n=1, --reflets 0", auto.getChoisi().toString());
        assertTrue(auto.getChoisi().erreurAuPlus < 0.1, auto.getChoisi().erreurAuPlus + "");
        assertEquals(1, auto.getChoisi().rayons);
    }

    @Test
    void desBoulesPlusPetitesQuUnPixelDemandentPlusieursRayons() {
        Auto auto = auto(damier(), LARGEUR, HAUTEUR, GRILLES, Souhait.erreur(4));
        assertTrue(auto.estTenable());
        assertTrue(auto.getChoisi().rayons >= 4, auto.getChoisi().toString());
        Auto large = auto(damier(), LARGEUR, HAUTEUR, GRILLES, Souhait.erreur(100));
        assertEquals(1, large.getChoisi().rayons);
    }

    @Test
    void ceQuiNEstPasTenableEstDit() {
        Auto auto = auto(damier(), Souhait.erreur(4));
        assertFalse(auto.estTenable());
        assertEquals(1, auto.getChoisi().rayons);
        assertTrue(auto.getChoisi().erreur > 4);
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

    @Test
    void leChoixPourUneErreurNeDependPasDesFils() {
        Scene scene = scene(boule(-1, 0, 8, 1.2, 0.5), boule(1.2, 0.4, 7, 0.7, 0.8), boule(0, -1001.5, 8, 1000, 0.3));
        for (double erreur : new double[] {0.5, 3}) {
            String attendu = null;
            for (int fils : new int[] {1, 2, 7}) {
                // assez de pavés pour que chaque fil en ait
                Auto auto = Auto.choisir(LancerSurveille.preparer(scene, 80, 70, false), Souhait.erreur(erreur), fils, GRILLES,
                        enCours -> { });
                Reglage r = auto.getChoisi();
                String choix = r + " " + r.erreur + " " + r.erreurAuPlus + " " + r.rayons + " " + r.prix;
                attendu = attendu == null ? choix : attendu;
                assertEquals(attendu, choix, fils + " fils");
            }
        }
    }

    @Test
    void lErreurMesureeEstCelleDeToutePart() {
        // une erreur égale sur tous les pixels se mesure sans incertitude
        Auto auto = autoEntreDeuxMurs(0.5, Souhait.erreur(255).fixer(2, 0.0));
        auto.getTraceur().TracerPixels(auto.surveiller((couleur, xe, ye) -> { }, auto.getChoisi()), auto.getChoisi().reflets, 2);
        auto.controler();
        // à ce que vaut « sans limite » près
        assertEquals(255 * 0.9 / 8, auto.getErreurMesuree(), 1e-3);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1, 7", "2, 2", "3, 1", "33, 65", "201, 151"})
    void touteTailleDImageConvient(int largeur, int hauteur) {
        Auto auto = auto(scene(boule(0, 0, 8, 2, 0.5)), largeur, hauteur, GRILLES, Souhait.erreur(1));
        auto.getTraceur().TracerPixels(auto.surveiller((couleur, xe, ye) -> { }, auto.getChoisi()), auto.getChoisi().reflets, 2);
        auto.controler();
        assertEquals(3, auto.getLignes().size());
        assertTrue(auto.getErreurMesuree() < 10, auto.getLignes().toString());
    }

    @Test
    void lesReglagesDUneVarianteSontEssayesEtSesRayonsComptes() {
        Auto auto = auto(scene(boule(0, 0, 8, 1.5, 0)), LARGEUR, HAUTEUR, MODESTES, Souhait.erreur(0.01));
        double[] rayons = auto.getFront().stream().mapToDouble(r -> r.rayons).toArray();
        assertArrayEquals(new double[] {1, 4, 9}, rayons, 1e-9);
        double[] erreurs = auto.getFront().stream().mapToDouble(r -> r.erreur).toArray();
        assertTrue(erreurs[0] > erreurs[1] && erreurs[1] > erreurs[2], Arrays.toString(erreurs));
    }

    @Test
    void vouloirMoinsDErreurNEnAnnoncePasPlus() {
        for (Scene scene : Arrays.asList(damier(), scene(boule(-1, 0, 8, 1.2, 0.5), boule(1.2, 0.4, 7, 0.7, 0.8),
                boule(0, -1001.5, 8, 1000, 0.3)))) {
            double attendue = Double.POSITIVE_INFINITY;
            double auPlus = Double.POSITIVE_INFINITY;
            for (double voulue = 16; voulue > 0.1; voulue /= 1.5) {
                Reglage choisi = auto(scene, LARGEUR, HAUTEUR, GRILLES, Souhait.erreur(voulue)).getChoisi();
                assertTrue(choisi.erreur <= attendue && choisi.erreurAuPlus <= auPlus, choisi + " pour " + voulue);
                attendue = choisi.erreur;
                auPlus = choisi.erreurAuPlus;
            }
        }
    }

    /** Trois verdicts, et « dépassée » jamais en deçà de l'incertitude. */
    @Test
    void ceQueLIncertitudeNePermetPasDeDireNEstPasDit() {
        Souhait souhait = Souhait.erreur(2);
        Estimation erreur = new Estimation(4, 0.25);
        assertEquals(0.25, erreur.incertitude(), 0.01);
        assertTrue(Souhait.erreur(2.3).verdict(erreur, 2).equals("erreur voulue tenue"));
        assertTrue(souhait.verdict(erreur, 2).equals("on ne peut dire si l'erreur voulue est tenue"));
        assertTrue(Souhait.erreur(1.7).verdict(erreur, 2).equals("erreur voulue dépassée"));
        // les essais sont compris dans le temps voulu
        assertTrue(Souhait.temps(2).verdict(erreur, 2.1).equals("temps voulu dépassé"));
    }

    @Test
    void uneErreurMesureeNulleNEstTenueQueSousSonIncertitude() {
        // son carré est de 0 ± 1
        Estimation nulle = new Estimation(0, 0.25);
        assertEquals(1, nulle.incertitude());
        assertEquals("on ne peut dire si l'erreur voulue est tenue", Souhait.erreur(0.9).verdict(nulle, 2));
        assertEquals("erreur voulue tenue", Souhait.erreur(1).verdict(nulle, 2));
    }

    /**
     * Les essais d'un grand dessin en coûtent au plus la moitié ; ceux d'un petit, ce que rien ne demande en 0,2 s : celui d'une grille
     * de 16 s'arrête s'il passerait.
     */
    @ParameterizedTest
    @CsvSource({"40, 30", "200, 150"})
    void lesEssaisCoutentAuPlusLaMoitieDuDessinOuTresPeu(int largeur, int hauteur) {
        Scene boules = scene(boule(-1, 0, 8, 1.2, 0.5), boule(1.2, 0.4, 7, 0.7, 0.8), boule(0, -1001.5, 8, 1000, 0.3));
        for (double voulue : new double[] {50, 4, 1, 0.25}) {
            verifierLeCoutDesEssais(auto(boules, largeur, hauteur, GRILLES, Souhait.erreur(voulue)));
            verifierLeCoutDesEssais(auto(damier(), largeur, hauteur, GRILLES, Souhait.erreur(voulue)));
            verifierLeCoutDesEssais(auto(entreDeuxMurs(0.9), largeur, hauteur, MODESTES, Souhait.erreur(voulue)));
        }
        verifierLeCoutDesEssais(auto(boules, 8 * largeur, 8 * hauteur, MODESTES, Souhait.erreur(1)));
    }

    private static void verifierLeCoutDesEssais(Auto auto) {
        auto.getTraceur().TracerPixels(auto.surveiller((couleur, xe, ye) -> { }, auto.getChoisi()), auto.getChoisi().reflets, 2);
        auto.controler();
        double permis = Math.max(550_000, auto.getTraceur().getCompteurs().rayons() / 2.0);
        assertTrue(auto.getRayonsDesEssais() <= permis, auto.getRayonsDesEssais() + " pour " + permis + ", " + auto.getChoisi());
    }

    @Test
    void unReglageFautifEstRefuseCommeUneSection() {
        Traceur lancer = LancerSurveille.preparer(scene(boule(0, 0, 8, 1, 0)), 20, 15, false);
        List<Variante> fautive = Collections.singletonList(
                new GrilleDEssai(Collections.singletonList(Section.reglage("Grille", "m", "3"))));
        SceneFautive e = assertThrows(SceneFautive.class, () -> Auto.choisir(lancer, Souhait.erreur(1), 1, fautive, enCours -> { }));
        assertEquals("réglage, [Grille], m : clé inconnue ; attendu : n", e.getMessage());
    }

    @Test
    void uneVarianteSansListeDeReglagesEstNommee() {
        Traceur lancer = LancerSurveille.preparer(scene(boule(0, 0, 8, 1, 0)), 20, 15, false);
        List<Variante> muette = Collections.singletonList(new GrilleDEssai(null));
        NullPointerException e = assertThrows(NullPointerException.class,
                () -> Auto.choisir(lancer, Souhait.erreur(1), 1, muette, enCours -> { }));
        assertEquals(muette.get(0).getClass().getName() + ".getReglages a rendu null", e.getMessage());
    }
}
