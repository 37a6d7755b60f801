package lancer.inspection;

import static lancer.essai.Ressources.cachee;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntFunction;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Sphere;
import lancer.Vecteur;
import lancer.image.ImageMemoire;
import lancer.texte.Nombre;
import org.junit.jupiter.api.Test;

/** Les vues en fausses couleurs sont les formules que dit leur page. */
class FaussesCouleursTest {

    private static final int L = 64;
    private static final int H = 48;
    private static final int[] ECHELLE = {0xFF000000, 0xFF2C115F, 0xFF721F81, 0xFFB73779, 0xFFF1605D, 0xFFFEB078, 0xFFFFFFFF};

    private final Scene scene = new Scene("scenes/scene1.ini");
    private final Camera camera = new Camera(L, H);

    private ImageMemoire dessiner(Scene vue, String nom) {
        ImageMemoire image = new ImageMemoire(L, H, true);
        new FaussesCouleurs(new Lancer(vue, camera), image, 5, 2).dessiner(nom);
        return image;
    }

    private PointContact contact(int k) {
        return scene.getClosestIntersection(camera.getRayon(k % L + 0.5, k / L + 0.5));
    }

    private static void verifier(IntFunction<Couleur> attendue, int[] codes) {
        for (int k = 0; k < codes.length; k++) {
            assertEquals(attendue.apply(k).getCode(), codes[k], "pixel " + k % L + ", " + k / L);
        }
    }

    @Test
    void lesNormalesSontNPlusUnSurDeuxEtLeCielNoir() {
        verifier(k -> {
            PointContact contact = contact(k);
            Vecteur N = contact == null ? null : contact.objet.getNormale(contact);
            return N == null ? new Couleur() : new Couleur((N.x + 1) / 2, (N.y + 1) / 2, (N.z + 1) / 2);
        }, dessiner(scene, "normales").codes);
    }

    @Test
    void laDistanceVaDuBlancAuGrisSombreSelonSonRangEtDonneSesDeuxBoutsEtSonMilieu() {
        double[] distances = new double[L * H];
        Arrays.setAll(distances, k -> contact(k) == null ? 0 : contact(k).distance);
        double[] contacts = Arrays.stream(distances).filter(d -> d > 0).distinct().sorted().toArray();
        ImageMemoire image = dessiner(scene, "distance");
        verifier(k -> new Couleur(distances[k] == 0 ? 0
                : 1 - 0.9 * Arrays.stream(contacts).filter(d -> d < distances[k]).count() / (contacts.length - 1)), image.codes);
        assertEquals("vue distance : d = " + Nombre.arrondir(contacts[0]) + " en blanc, " + Nombre.arrondir(contacts[contacts.length / 2])
                + " au milieu, " + Nombre.arrondir(contacts[contacts.length - 1]) + " en gris sombre ; ciel noir", image.echelle);
        int gris = Arrays.stream(image.codes).map(c -> c & 255).filter(c -> c > 0).min().getAsInt();
        assertEquals(Math.round(255 * 0.1), gris, 1, "le plus lointain contact se distingue du ciel");
    }

    @Test
    void uneSeuleDistanceEstBlanche() {
        Scene boule = new Scene(List.of(new Sphere(new Point(0, 0, 6), 5e-3)), List.of());
        ImageMemoire image = new ImageMemoire(1, 1, true);
        new FaussesCouleurs(new Lancer(boule, new Camera(1, 1)), image, 5, 1).dessiner("distance");
        assertEquals(0xFFFFFFFF, image.codes[0]);
        assertEquals("d = 5.99500", image.dire(0));
    }

    @Test
    void leCielSeDitCielEtNonUneValeur() {
        for (String nom : new String[] {"normales", "distance", "lampes"}) {
            ImageMemoire image = dessiner(scene, nom);
            for (int k = 0; k < image.codes.length; k++) {
                assertEquals(contact(k) == null, image.dire(k).equals("ciel"), nom + ", pixel " + k + " : " + image.dire(k));
            }
        }
    }

    @Test
    void chaqueVueDitEnUneLigneCeQueMontrentSesTeintes() {
        assertEquals("vue normales : (N + 1)/2 : x en rouge, y en vert, z en bleu ; ciel noir", dessiner(scene, "normales").echelle);
        assertEquals("vue lampes : lampes qui éclairent, noir : aucune, blanc : 2 sur 2 ; ciel noir", dessiner(scene, "lampes").echelle);
        assertTrue(dessiner(scene, "rayons").echelle.matches("vue rayons : noir : 1 rayon, rose : \\d+, blanc : \\d+"));
        assertTrue(dessiner(scene, "marge").echelle.endsWith("noir : rien ne change, violet : 8 à 10, rouge : 5 à 7, orange : 3 et 4, "
                + "blanc : l'arrondi suffit"));
    }

    @Test
    void lesLampesSontLaPartDeCellesQuiEclairent() {
        List<Lampe> lampes = scene.getLampes();
        verifier(k -> {
            PointContact contact = contact(k);
            double eclairent = 0;
            for (Lampe lampe : contact == null ? List.<Lampe>of() : lampes) {
                eclairent += contact.objet.getNormale(contact).dot(new Vecteur(contact, lampe.getPosition())) > 0
                        && !cachee(scene, lampe, contact, contact.objet) ? 1 : 0;
            }
            return new Couleur(eclairent / lampes.size());
        }, dessiner(scene, "lampes").codes);
        Scene sansLampe = new Scene(scene.getObjets(), List.of());
        assertArrayEquals(new int[] {0xFF000000}, Arrays.stream(dessiner(sansLampe, "lampes").codes).distinct().toArray());
    }

    @Test
    void lesRayonsSeComptentSurUneEchelleLogarithmiqueJusquAuPlusGrandNombre() {
        int[] codes = dessiner(scene, "rayons").codes;
        double[] rayons = new double[codes.length];
        for (int k = 0; k < codes.length; k++) {
            Lancer sien = new Lancer(scene.avec(scene.getModele()), camera);
            sien.getCouleurPixel(k % L + 0.5, k / L + 0.5, 5);
            rayons[k] = sien.getScene().getCompteurs().rayons();
        }
        double max = Arrays.stream(rayons).max().getAsDouble();
        assertTrue(max > 4, "des pixels demandent plus de quatre rayons");
        for (int k = 0; k < codes.length; k++) {
            double place = 6 * Math.log(rayons[k]) / Math.log(max);
            int bas = ECHELLE[(int) place];
            if (place == (int) place) {
                assertEquals(bas, codes[k], "pixel " + k);
            }
            assertTrue((codes[k] >> 16 & 255) >= (bas >> 16 & 255), "pixel " + k);
        }
    }

    /**
     * Chaque boule de rayon r, rencontrée au quart de r de son centre, à la distance d, multiplie l'écart du rayon par 2d/r environ. Le
     * ciel change d'un niveau pour un écart de 1/255 environ.
     */
    @Test
    void chaqueRefletCouteLesDecimalesQueDitLaGeometrie() {
        double r = 0.36;
        double d = 6;
        SplittableRandom hasard = new SplittableRandom(2);
        List<Sphere> chaine = new ArrayList<>();
        Rayon rayon = new Camera(1, 1).getRayon(0.5, 0.5);
        for (int n = 1; n <= 12; n++) {
            Vecteur cote = new Vecteur(hasard.nextDouble() - 0.5, hasard.nextDouble() - 0.5, hasard.nextDouble() - 0.5).normalized();
            Sphere boule = new Sphere(rayon.getP().add(rayon.getV().mul(d)).add(cote.mul(r / 4)), r);
            boule.setKs(new Couleur(1));
            chaine.add(boule);
            boule.getIntersectionDistance(rayon);
            PointContact contact = rayon.calcContact();
            Vecteur N = boule.getNormale(contact);
            rayon = new Rayon(contact, rayon.getV().sub(N.mul(2 * rayon.getV().dot(N))));
            ImageMemoire image = new ImageMemoire(1, 1, true);
            new FaussesCouleurs(new Lancer(new Scene(chaine, List.of()), new Camera(1, 1)), image, n, 1).dessiner("marge");
            double attendue = 16 - Math.log10(255 * Math.pow(2 * d / r, n));
            assertEquals(Math.max(0, Math.min(11, attendue)), image.lineaire[0], 1.5, n + " boules");
        }
    }

    @Test
    void uneMargeEntiereEstNoire() {
        Scene lisse = new Scene(List.of(new Sphere(new Point(0, 0, 1000), 900)), scene.getLampes());
        ImageMemoire image = dessiner(lisse, "marge");
        assertEquals("marge : 11 décimales (11 : rien ne change)", image.dire(L * H / 2 + L / 2));
        assertEquals(0xFF000000, image.codes[L * H / 2 + L / 2]);
    }

    @Test
    void uneSceneVideEstNoireDeToutesLesFacons() {
        Scene vide = new Scene(List.of(), List.of(new Lampe(new Point(0, 5, 0), new Couleur(1))));
        for (String nom : new String[] {"normales", "distance", "lampes", "rayons"}) {
            assertArrayEquals(new int[] {0xFF000000}, Arrays.stream(dessiner(vide, nom).codes).distinct().toArray(), nom);
        }
    }
}
