package lancer.limites;

import static lancer.essai.Ressources.boule;
import static lancer.essai.Ressources.cachee;
import static lancer.essai.Ressources.scene;
import static lancer.essai.Tirages.direction;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import lancer.Camera;
import lancer.Constantes;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.essai.Exact;
import lancer.essai.Ressources;
import lancer.rapide.Structuree;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Les ombres là où un arrondi en ferait ou en ôterait : sphères qui se touchent, et lampes lointaines. Aussi loin que soit une lampe,
 * l'ombre est celle de l'arithmétique exacte : chaque moitié du segment se demande de son bout (Scene.estCachee). Le rayon du cours,
 * parti de la lampe, manque son contact du dernier chiffre de la distance.
 */
class OmbresTest {

    private static final int CONTACTS = 400;

    /** Deux boules au-dessus d'un sol, plus trois points éclairés par boule, au hasard. */
    private final Random hasard = new Random(14);
    private final Sphere boule = new Sphere(new Point(0.3, 0.2, 8), 1);
    private final Sphere petite = new Sphere(new Point(-1.1, 0.9, 7), 0.25);
    private final Sphere sol = new Sphere(new Point(0, -1001.5, 8), 1000);

    /** Vrai si la surface de s coupe le segment de A à B ; {@code null} si des doubles ne sauraient en juger. */
    private static Boolean coupe(Point A, Point B, Sphere s) {
        Exact exact = new Exact(A, B, s.getCentre(), s.getRayon());
        return Math.abs(exact.enfoncement) < 1e-9 * s.getRayon() ? null : exact.distance < new Vecteur(A, B).norme();
    }

    private Point surLaSurface(Sphere s, boolean enHaut) {
        Vecteur n = direction(hasard);
        if (enHaut) {
            n = new Vecteur(3e-3 * n.x, 1, 3e-3 * n.z).normalized();
        }
        return s.getCentre().add(s.getRayon(), n);
    }

    private void comparer(String nom, Lampe lampe, Sphere... autour) {
        List<Sphere> spheres = new ArrayList<>(List.of(boule, petite, sol));
        spheres.addAll(List.of(autour));
        Scene boucles = new Scene(spheres, List.of(lampe));
        Scene scene = Structuree.scene(boucles, new Camera(80, 60));
        int cachees = 0;
        for (int k = 0; k < CONTACTS; k++) {
            Sphere eclairee = spheres.get(k % 3);
            Point contact = surLaSurface(eclairee, eclairee == sol);
            if (eclairee.getNormale(contact).dot(new Vecteur(contact, lampe.getPosition())) <= 0) {
                continue;
            }
            Boolean attendu = false;
            for (Sphere s : spheres) {
                Boolean c = s == eclairee ? Boolean.FALSE : coupe(contact, lampe.getPosition(), s);
                attendu = attendu == null || c == null ? null : attendu || c;
            }
            boolean lisible = cachee(boucles, lampe, contact, eclairee);
            assertEquals(lisible, cachee(scene, lampe, contact, eclairee), nom + ", rapide, contact " + contact);
            if (attendu != null) {
                assertEquals(attendu, lisible, nom + ", contact " + contact);
                cachees += attendu ? 1 : 0;
            }
        }
        assertTrue(autour.length > 0 || cachees > 5, nom + " : " + cachees + " contacts à l'ombre");
    }

    private Vecteur versLeHaut() {
        return new Vecteur(hasard.nextGaussian(), 2 + hasard.nextDouble(), -hasard.nextDouble()).normalized();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e5, 9.9e7, 1.01e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e50, 1e100})
    void lOmbreDUneLampeLointaineEstExacte(double loin) {
        comparer("à " + loin, new Lampe(new Point().add(loin, versLeHaut()), new Couleur(1)));
    }

    /** Là où les coordonnées d'une lampe se distinguent encore de celles d'un astre qui la porte. */
    @ParameterizedTest
    @ValueSource(doubles = {1e5, 9.9e7, 1.01e8, 1e10, 1e12, 1e15, 1e17})
    void unAstreOuUneLuneAutourDeLaLampeNeChangentQueCeQuIlsCachent(double loin) {
        Vecteur d = versLeHaut();
        Vecteur cote = new Vecteur(d.y, -d.x, 0).normalized();
        Point p = new Point().add(loin, d);
        double rayon = loin / 1000;
        comparer("devant son astre, à " + loin, new Lampe(p, new Couleur(1)), new Sphere(p.add(1.001 * rayon, d), rayon));
        comparer("derrière son astre, à " + loin, new Lampe(p, new Couleur(1)), new Sphere(p.add(-1.001 * rayon, d), rayon));
        comparer("dans son astre, à " + loin, new Lampe(p, new Couleur(1)), new Sphere(p, rayon));
        comparer("près d'une lune, à " + loin, new Lampe(p, new Couleur(1)), new Sphere(p.add(2 * rayon, cote), rayon));
    }

    /** Les points éclairés de face de deux boules concentriques, où celle du dehors est dite à l'ombre, ou l'autre au jour. */
    private int faux(Point centre, double rayon, double ecart, Point lampe) {
        Sphere dehors = new Sphere(centre, rayon);
        Sphere dedans = new Sphere(centre, rayon - ecart);
        Lampe seule = new Lampe(lampe, new Couleur(1));
        Scene scene = new Scene(List.of(dedans, dehors), List.of(seule));
        Scene rapide = Structuree.scene(scene, new Camera(80, 60));
        int faux = 0;
        for (int k = 0; k < 2 * CONTACTS; k++) {
            Sphere eclairee = k % 2 == 0 ? dehors : dedans;
            Point contact = surLaSurface(eclairee, false);
            if (eclairee.getNormale(contact).dot(new Vecteur(contact, lampe)) > 0) {
                boolean cachee = cachee(scene, seule, contact, eclairee);
                assertEquals(cachee, cachee(rapide, seule, contact, eclairee), "rapide, contact " + contact);
                faux += cachee == (eclairee == dehors) ? 1 : 0;
            }
        }
        return faux;
    }

    private Point auLoin(double loin) {
        return new Point().add(loin, direction(hasard));
    }

    @ParameterizedTest
    @CsvSource({"1e-12, 1e5", "1e-12, 2e8", "1e-8, 9.9e7", "1e-8, 1.1e8", "4.4e-11, 2e4", "4.4e-11, 4.9e4", "4.4e-11, 7e4", "1e-13, 1e30"})
    void deDeuxBoulesConcentriquesCelleDuDehorsEstSeuleAuJour(double ecart, double loin) {
        for (int fois = 0; fois < 4; fois++) {
            assertEquals(0, faux(new Point(0, 0, 6), 1, ecart, auLoin(loin)));
        }
    }

    /** Des lampes de part et d'autre du facteur, et huit arrondis d'écart : de quoi ne pas confondre deux surfaces. */
    @Test
    void aHuitArrondisLUneDeLAutreDeuxSurfacesNeSeConfondentPas() {
        for (int k = 0; k < 100; k++) {
            double grandeur = Math.pow(2, 200 * hasard.nextDouble() - 100);
            Point centre = auLoin(grandeur);
            double rayon = grandeur * (0.05 + 0.3 * hasard.nextDouble());
            double ecart = 8 * Constantes.LOINTAINE * 0x1p-53 * (grandeur + rayon);
            Point lampe = auLoin(grandeur * Math.pow(10, 1 + 11 * hasard.nextDouble()));
            assertEquals(0, faux(centre, rayon, ecart, lampe), lampe + " vue de " + centre + ", rayon " + rayon);
        }
    }

    @Test
    void dansLesScenesLivreesChaqueLampeEstProcheDeChaqueContact() {
        Camera camera = new Camera(40, 30);
        for (Path fichier : Ressources.scenes(Path.of("scenes"))) {
            Scene scene = new Scene(fichier.toString());
            for (int k = 0; k < 40 * 30; k++) {
                PointContact contact = scene.getClosestIntersection(camera.getRayon(k % 40 + 0.5, k / 40 + 0.5));
                assertTrue(contact == null || scene.getLampes().stream().noneMatch(lampe -> Scene.estLointaine(lampe, contact)),
                        fichier.toString());
            }
        }
    }

    @Test
    void uneLampeEstLointaineDUnContactParUnFacteurQuiNAPasDUnite() {
        for (int k : new int[] {-300, 0, 1, 300}) {
            Point contact = new Point(0, Math.scalb(-6.0, k), Math.scalb(1.0, k));
            double bord = Math.scalb(6 * Constantes.LOINTAINE, k);
            assertFalse(Scene.estLointaine(new Lampe(new Point(0, 0, -bord), new Couleur(1)), contact), "2^" + k);
            assertTrue(Scene.estLointaine(new Lampe(new Point(Math.nextUp(bord), 0, 0), new Couleur(1)), contact), "2^" + k);
        }
    }

    @Test
    void deDeuxSpheresQuiSInterpenetrentCelleQuiEntoureLeDepartCompte() {
        Sphere a = boule(-0.5, 0, 6, 1, 1, 0, 1);
        Sphere b = boule(0.5, 0, 6, 1, 1, 0, 1);
        Scene scene = scene(List.of(a, b));
        // sur a, et au centre de b
        Point depart = new Point(0.5, 0, 6);
        for (Vecteur v : new Vecteur[] {new Vecteur(1, 0, 0), new Vecteur(0, 0, -1), new Vecteur(0, 0.6, 0.8)}) {
            PointContact sortie = scene.getClosestIntersection(new Rayon(depart, v), a);
            assertSame(b, sortie.objet);
            assertEquals(1, sortie.distance, 1e-15);
        }
        Lampe dehors = new Lampe(new Point(0.5, 9, 6), new Couleur(1));
        assertTrue(cachee(scene, dehors, depart, a), "b entoure le contact");
        assertFalse(cachee(scene, dehors, new Point(0.5, 1, 6), b), "le haut de b est libre");
    }

    /**
     * Une boule posée sur le sol, une lampe droit au-dessus : son ombre est un disque noir. Près du pied le rayon voit le sol ou
     * le dessous de la boule, à quelques dix-millionièmes près ; l'un et l'autre sont noirs.
     */
    @Test
    void lePiedDUneBoulePoseeSurLeSolEstExactementNoir() {
        for (double R : new double[] {100, 1e4, 1e6}) {
            List<Sphere> boules = List.of(boule(0, -R, 10, R, 1, 0, 1), boule(0, 1, 10, 1, 1, 0.5, 9));
            Scene scene = scene(boules, new Lampe(new Point(0, 50, 10), new Couleur(1)));
            Point oeil = new Point(0, 3, 0);
            // la lampe est à 49 du centre : le cône d'ombre a 50·tan(asin(1/49)) = 1,0206 au sol, si celui-ci est plat
            for (double d = 1e-9; d < 0.9; d *= 1.07) {
                for (double phi = 0; phi < 3.2; phi += 0.4) {
                    Point vise = new Point(d * Math.cos(phi), 0, 10 - d * Math.sin(phi));
                    assertEquals(new Couleur(), scene.getCouleurVue(new Rayon(oeil, vise), null, 0), "R = " + R + ", d = " + d);
                }
            }
            for (double d = 1.2; d < 3; d += 0.1) {
                assertTrue(scene.getCouleurVue(new Rayon(oeil, new Point(0, 0, 10 - d)), null, 0).r > 0.8, "R = " + R + ", d = " + d);
            }
        }
    }

    /** Le contact n'est connu qu'à 4 u (r + |C|) près : à deux fois cela, deux coquilles se distinguent ; à un huitième, non. */
    @Test
    void deDeuxCoquillesAHuitArrondisCelleDuDehorsEstVueEtEclairee() {
        assertEquals(0, confondues(8));
        assertTrue(confondues(0.5) > 100, confondues(0.5) + " pixels : un double ne peut les distinguer");
    }

    /** @param ecart de deux boules concentriques, en u (r + |C|) ; le nombre de pixels où celle du dehors n'est pas vue, ou ombrée */
    private int confondues(double ecart) {
        hasard.setSeed(52);
        Camera camera = new Camera(60, 60);
        Lampe lampe = new Lampe(new Point(3, 5, -4), new Couleur(1));
        int confondues = 0;
        for (int essai = 0; essai < 20; essai++) {
            Point C = new Point(0.3 * hasard.nextGaussian(), 0.3 * hasard.nextGaussian(), 4 + 4 * hasard.nextDouble());
            double r = 0.5 + hasard.nextDouble();
            double jeu = ecart * 0x1p-53 * (r + new Vecteur(new Point(), C).norme());
            Sphere dehors = boule(C.x, C.y, C.z, r, 1, 0, 1);
            Scene scene = scene(List.of(boule(C.x, C.y, C.z, r - jeu, 1, 0, 1), dehors), lampe);
            for (int k = 0; k < 60 * 60; k++) {
                PointContact vu = scene.getClosestIntersection(camera.getRayon(k % 60 + 0.5, k / 60 + 0.5));
                confondues += vu != null && (vu.objet != dehors || dehors.getNormale(vu).dot(new Vecteur(vu, lampe.getPosition())) > 0
                        && cachee(scene, lampe, vu, dehors)) ? 1 : 0;
            }
        }
        return confondues;
    }
}
