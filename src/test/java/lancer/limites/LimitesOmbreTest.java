package lancer.limites;

import static lancer.essai.Ressources.boule;
import static lancer.essai.Ressources.image;
import static lancer.essai.Ressources.memesBits;
import static lancer.essai.Ressources.scene;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
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
import lancer.Sphere;
import lancer.Vecteur;
import lancer.contrat.Vue;
import lancer.essai.Formule;
import lancer.essai.Ombre;
import lancer.essai.Rangee;
import lancer.essai.TraceurNaif;
import org.junit.jupiter.api.Test;

/**
 * Où les façons courantes de demander « cette lampe est-elle cachée ? » échouent. Le contact calculé n'est jamais exactement sur
 * sa sphère : le rayon d'ombre la retrouve tout près de lui, devant ou derrière, au gré des arrondis. Toutes les recettes sont des
 * façons de ne pas voir cette rencontre ; la nôtre est la seule qui n'ait pas d'unité de longueur : ne pas la demander.
 */
class LimitesOmbreTest {

    private static final int COTE = 101;

    /** Le nombre de pixels noirs d'une scène que l'on regarde de la lampe : il ne devrait pas y en avoir. */
    private static int noirs(Scene scene) {
        Lancer lancer = new Lancer(scene, new Camera(COTE, COTE));
        return noirs((xe, ye) -> lancer.getCouleurPixel(xe, ye, 0));
    }

    private static int noirs(Vue vue) {
        int noirs = 0;
        for (int k = 0; k < COTE * COTE; k++) {
            noirs += vue.couleur(k % COTE + 0.5, k / COTE + 0.5).b == 0 ? 1 : 0;
        }
        return noirs;
    }

    private static Scene vueDeLaLampe(Sphere... boules) {
        return scene(Arrays.asList(boules), new Lampe(Camera.OEIL, new Couleur(1)));
    }

    /** Du contact vers la lampe, tout ce que le rayon touche à plus d'epsilon, selon le manuel, cache, l'objet éclairé compris. */
    private static TraceurNaif sansExclure(Scene scene, double epsilon) {
        return new TraceurNaif(scene, new Camera(COTE, COTE), 0, TraceurNaif.Ombre.SANS_EXCLURE, epsilon);
    }

    /** L'acné. */
    @Test
    void sansExclureLaSurfaceDeDepartElleSOmbreElleMeme() {
        Scene scene = vueDeLaLampe(boule(0, 0, 5, 1.5, 1, 0, 1));
        assertEquals(0, noirs(scene));
        int noirs = noirs(sansExclure(scene, 0));
        assertTrue(noirs > 200, noirs + " points noirs");
        Rangee.montre("sansExclureLaSurfaceDeDepartElleSOmbreElleMeme", noirs, 0, 0);
    }

    /** Un epsilon de 1e-6 couvre les arrondis d'une scène de quelques unités, ni ceux d'un grand sol, ni rien d'une petite scène. */
    @Test
    void unEpsilonFixeNeGueritQueLesScenesDeSaTaille() {
        Scene moyenne = vueDeLaLampe(boule(0, 0, 5, 1.5, 1, 0, 1));
        assertEquals(0, noirs(sansExclure(moyenne, 1e-6)), "il guérit celle-ci");
        Scene grande = vueDeLaLampe(boule(6e10, -8e10 - 2.5, 5, 1e11, 1, 0, 1));
        assertEquals(0, noirs(grande));
        int noirs = noirs(sansExclure(grande, 1e-6));
        Rangee.montre("unEpsilonFixeNeGueritQueLesScenesDeSaTaille", noirs, 0, 0);
        assertTrue(noirs > 50, noirs + " points noirs : de près, la racine du manuel se trompe de u·1e11 = 1e-5");
        // une bille posée à 2e-7 du contact devrait le cacher
        Sphere mur = boule(0, 0, 5, 1, 1, 0, 1);
        Scene petite = scene(Arrays.asList(mur, boule(0, 0, 4 - 3e-7, 1e-7, 1, 0, 1)), new Lampe(new Point(), new Couleur(1)));
        assertTrue(Ombre.cachee(petite, petite.getLampes().get(0), new Point(0, 0, 4), mur));
        assertFalse(sansExclure(petite, 1e-6).cachee(petite.getLampes().get(0), new Point(0, 0, 4), mur), "la lumière passe à travers");
    }

    /** Ignorer tout ce qui est trop près du départ, pour ignorer le départ : de deux boules qui se frôlent, l'autre disparaît. */
    @Test
    void exclureLeDepartParLaDistanceExclutAussiLeVoisin() {
        Sphere a = boule(0, 0, 5, 1, 1, 0, 1);
        Sphere b = boule(0, 0, 3 - 1e-5, 1, 1, 0, 1);
        Scene scene = scene(Arrays.asList(a, b));
        Rayon quitte = new Rayon(new Point(0, 0, 4), new Vecteur(0, 0, -1));
        Objet3D naif = null;
        for (Objet3D objet : scene.getObjets()) {
            double t = objet.getIntersectionDistance(quitte);
            naif = t > 1e-4 && t < Constantes.INFINI ? objet : naif;
        }
        assertEquals(null, naif, "b est à 1e-5");
        PointContact contact = scene.getClosestIntersection(quitte, a);
        assertSame(b, contact.objet);
        assertEquals(1e-5, contact.distance, 1e-15);
        Rangee.montre("exclureLeDepartParLaDistanceExclutAussiLeVoisin", Constantes.INFINI, contact.distance, 1e-5);
    }

    private static double decale(double x, double vers, int unites) {
        return x + Math.rint(unites * vers) * Math.ulp(x);
    }

    /**
     * La recette de Wächter et Binder, ici en doubles : partir du contact décalé, le long de la normale, de quelques unités du dernier
     * chiffre de ses coordonnées, et n'exclure personne.
     */
    private static boolean cacheeDUnDecalage(Scene scene, Point contact, Objet3D objet, int unites) {
        Vecteur N = objet.getNormale(contact);
        Point depart = new Point(decale(contact.x, N.x, unites), decale(contact.y, N.y, unites), decale(contact.z, N.z, unites));
        Point lampe = scene.getLampes().get(0).getPosition();
        Rayon ombre = new Rayon(depart, lampe);
        scene.getClosestIntersection(ombre);
        return ombre.getDistance() < new Vecteur(depart, lampe).norme();
    }

    /** Le nombre de contacts de cette boule, à la distance du manuel, vus de la lampe et pourtant dits cachés. */
    private static int cachesAvecDecalage(Sphere boule, int unites) {
        Camera camera = new Camera(COTE, COTE);
        int caches = 0;
        for (int k = 0; k < COTE * COTE; k++) {
            Rayon vu = camera.getRayon(k % COTE + 0.5, k / COTE + 0.5);
            double t = Formule.MANUEL.distance(vu.getP(), vu.getV(), boule.getCentre(), boule.getRayon());
            caches += t < Constantes.INFINI && cacheeDUnDecalage(vueDeLaLampe(boule), vu.getP().add(t, vu.getV()), boule, unites) ? 1 : 0;
        }
        return caches;
    }

    /** Trop court là où le contact est près de l'origine et sa sphère loin, trop long entre deux surfaces qui se touchent presque. */
    @Test
    void unDecalageRelatifAuContactEstTropCourtPourUnGrandSolEtTropLongEntreDeuxCoquilles() {
        Sphere moyenne = boule(0, 0, 5, 1.5, 1, 0, 1);
        assertTrue(cachesAvecDecalage(moyenne, 0) > 50, "sans décalage : " + cachesAvecDecalage(moyenne, 0));
        assertEquals(0, cachesAvecDecalage(moyenne, 256), "il guérit celle-ci");
        Sphere grande = boule(6e10, -8e10 - 2.5, 5, 1e11, 1, 0, 1);
        assertTrue(cachesAvecDecalage(grande, 256) > 50, cachesAvecDecalage(grande, 256) + " points noirs");
        assertEquals(0, noirs(vueDeLaLampe(grande)), "le nôtre");
        Rangee.montre("unDecalageRelatifAuContactEstTropCourtPourUnGrandSolEtTropLongEntreDeuxCoquilles", cachesAvecDecalage(grande, 256),
                0, 0);
        Sphere dedans = boule(0, 0, 5, 1.5 - 5e-14, 1, 0, 1);
        Scene coquilles = vueDeLaLampe(dedans, boule(0, 0, 5, 1.5, 1, 0, 1));
        int traversees = 0;
        for (int k = 1; k <= 1000; k++) {
            Vecteur n = new Vecteur(0.4 * Math.sin(k), 0.4 * Math.cos(7 * k), -1).normalized();
            Point contact = dedans.getCentre().add(dedans.getRayon(), n);
            traversees += cacheeDUnDecalage(coquilles, contact, dedans, 256) ? 0 : 1;
            assertTrue(Ombre.cachee(coquilles, coquilles.getLampes().get(0), contact, dedans), "la nôtre, " + contact);
        }
        assertTrue(traversees > 900, "la lumière traverse " + traversees + " fois");
    }

    /** Sans s'arrêter à la lampe, le rayon d'ombre trouve aussi ce qui est derrière elle. */
    @Test
    void oublierLaDistanceDeLaLampeFaitOmbrerCeQuiEstDerriereElle() {
        Sphere boule = boule(0, 0, 5, 1.5, 1, 0, 1);
        Scene scene = vueDeLaLampe(boule, boule(0, 0, -9, 2, 1, 0, 1));
        assertEquals(0, noirs(scene));
        int noirs = noirs(new TraceurNaif(scene, new Camera(COTE, COTE), 0, TraceurNaif.Ombre.SANS_DISTANCE, 0));
        assertTrue(noirs > 3_000, noirs + " points noirs");
        Rangee.montre("oublierLaDistanceDeLaLampeFaitOmbrerCeQuiEstDerriereElle", noirs, 0, 0);
    }

    /**
     * Un objet de plus, à la même place, n'est pas le départ : il le cache au gré des arrondis. D'où l'oubli des jumelles, à la lecture.
     */
    @Test
    void uneJumelleQuOnGardeFaitDeLAcne() {
        Sphere boule = boule(0, 0, 5, 1.5, 1, 0, 1);
        Sphere jumelle = boule(0, 0, 5, 1.5, 1, 0, 1);
        Scene scene = vueDeLaLampe(boule, jumelle);
        assertEquals(0, noirs(scene));
        assertTrue(memesBits(image(vueDeLaLampe(boule), COTE, COTE, 0, 1), image(scene, COTE, COTE, 0, 1)));
        // d'une classe dérivée, elle est gardée
        Scene gardee = vueDeLaLampe(boule, new Sphere(boule.getCentre(), boule.getRayon()) { });
        assertTrue(noirs(gardee) > 20, noirs(gardee) + " points noirs");
    }

    /**
     * « Le premier objet vu de la lampe est-il celui-ci ? » (le cours) vaut ce que vaut l'intersection. D'une lampe à un milliard,
     * le discriminant du manuel ne sait plus si le rayon touche la boule : ici elle manque, et le contact passe pour caché.
     */
    @Test
    void lePremierObjetVuDUneLampeLointaineDemandeUneIntersectionJuste() {
        Sphere boule = boule(0, 0, 5, 1, 1, 0, 1);
        Vecteur soleil = new Vecteur(-1, 2, -3).normalized();
        Point lampe = new Point().add(soleil.mul(1e9));
        int manquees = 0;
        int justes = 0;
        for (int k = 0; k < 5_000; k++) {
            double y = 1 - (2 * k + 1.0) / 5_000;
            double rho = Math.sqrt(1 - y * y);
            Vecteur n = new Vecteur(rho * Math.cos(2.4 * k), y, rho * Math.sin(2.4 * k));
            if (n.dot(soleil) > 0.1) {
                Point contact = boule.getCentre().add(n);
                Rayon ombre = new Rayon(lampe, contact);
                Vecteur PC = new Vecteur(boule.getCentre(), lampe);
                double b = PC.dot(ombre.getV());
                manquees += b * b - (PC.dot(PC) - 1) < 0 ? 1 : 0;
                boolean cachee = scene(Collections.singletonList(boule)).getClosestIntersection(ombre) == null;
                assertFalse(cachee, "point " + k);
                justes++;
            }
        }
        Rangee.montre("lePremierObjetVuDUneLampeLointaineDemandeUneIntersectionJuste", manquees, 0, 0);
        assertTrue(manquees > justes / 10, manquees + " contacts sur " + justes + " passent pour cachés");
    }
}
