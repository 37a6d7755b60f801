package lancer.inspection;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.IntFunction;
import lancer.Camera;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Lancer;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
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

    private int[] vue(String nom) {
        return vue(scene, nom);
    }

    private int[] vue(Scene vue, String nom) {
        return dessiner(vue, nom).codes;
    }

    private ImageMemoire dessiner(Scene vue, String nom) {
        ImageMemoire image = new ImageMemoire(L, H, true);
        new FaussesCouleurs(new Lancer(vue, camera), 5, 2).dessiner(nom, image, null);
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
        }, vue("normales"));
    }

    @Test
    void laDistanceVaDuBlancAuGrisSombreSelonSonLogarithmeEtDonneSesDeuxBouts() {
        double[] distances = new double[L * H];
        Arrays.setAll(distances, k -> contact(k) == null ? 0 : contact(k).distance);
        double min = Arrays.stream(distances).filter(d -> d > 0).min().getAsDouble();
        double max = Arrays.stream(distances).max().getAsDouble();
        ImageMemoire image = dessiner(scene, "distance");
        verifier(k -> new Couleur(distances[k] == 0 ? 0 : 1 - 0.9 * Math.log(distances[k] / min) / Math.log(max / min)), image.codes);
        assertEquals("vue distance : d = " + Nombre.arrondir(min) + " en blanc, " + Nombre.arrondir(max) + " en gris sombre ; ciel noir",
                image.echelle);
        int gris = Arrays.stream(image.codes).map(c -> c & 255).filter(c -> c > 0).min().getAsInt();
        assertEquals(Math.round(255 * 0.1), gris, 1, "le plus lointain contact se distingue du ciel");
    }

    @Test
    void uneSeuleDistanceEstBlanche() {
        Scene boule = new Scene(Collections.singletonList(new Sphere(new Point(0, 0, 6), 5e-3)), Collections.<Lampe>emptyList());
        ImageMemoire image = new ImageMemoire(1, 1, true);
        new FaussesCouleurs(new Lancer(boule, new Camera(1, 1)), 5, 1).dessiner("distance", image, null);
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
        ImageMemoire gauche = new ImageMemoire(1, 1, true);
        gauche.sens = "N = %.0f %.0f %.0f";
        gauche.drawPixel(new Couleur(-1, 0, 0), 0, 0);
        assertEquals("N = -1 0 0", gauche.dire(0), "une normale vers la gauche n'est pas le ciel");
    }

    @Test
    void chaqueVueDitEnUneLigneCeQueMontrentSesTeintes() {
        assertEquals("vue normales : (N + 1)/2 : x en rouge, y en vert, z en bleu ; ciel noir", dessiner(scene, "normales").echelle);
        assertEquals("vue lampes : lampes qui éclairent, noir : aucune, blanc : 2 sur 2 ; ciel noir", dessiner(scene, "lampes").echelle);
        assertEquals("vue rayons : noir : 1 rayon, violet : 16, rose : 64, orange : 256, blanc : 4096 ou plus",
                dessiner(scene, "rayons").echelle);
        ImageMemoire meme = new ImageMemoire(L, H, true);
        new Lancer(scene, camera).TracerPixels(meme, 5, 2);
        ImageMemoire image = new ImageMemoire(L, H, false);
        new FaussesCouleurs(new Lancer(scene, camera), 5, 2).dessiner("difference", image, meme);
        assertEquals("vue difference : écart, au plus 0 (blanc : 32 niveaux sur 255), avec l'image d'avant", image.echelle);
        String seule = dessiner(scene, "difference").echelle;
        assertTrue(seule.matches("vue difference : écart, au plus [1-9][\\d.]+ \\(.*, avec une image de 64 rayons par pixel"), seule);
    }

    @Test
    void lesLampesSontLaPartDeCellesQuiEclairent() {
        List<Lampe> lampes = scene.getLampes();
        verifier(k -> {
            PointContact contact = contact(k);
            double eclairent = 0;
            for (Lampe lampe : contact == null ? Collections.<Lampe>emptyList() : lampes) {
                Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
                eclairent += contact.objet.getNormale(contact).dot(versLampe) > 0 && !scene.estCachee(lampe, contact,
                        versLampe.normalized(), versLampe.norme(), contact.objet) ? 1 : 0;
            }
            return new Couleur(eclairent / lampes.size());
        }, vue("lampes"));
        Scene sansLampe = new Scene(scene.getObjets(), Collections.<Lampe>emptyList());
        assertArrayEquals(new int[] {0xFF000000}, Arrays.stream(vue(sansLampe, "lampes")).distinct().toArray());
    }

    @Test
    void lesRayonsSeComptentSurUneEchelleLogarithmique() {
        int[] codes = vue("rayons");
        double avant = -1;
        for (int k = 0; k < codes.length; k++) {
            Lancer sien = new Lancer(scene.avec(scene.getModele()), camera);
            sien.getCouleurPixel(k % L + 0.5, k / L + 0.5, 5);
            double place = Math.log(sien.getScene().getCompteurs().rayons()) / Math.log(2) / 2;
            int bas = ECHELLE[(int) place];
            if (place == (int) place) {
                assertEquals(bas, codes[k], "pixel " + k);
            }
            assertTrue((codes[k] >> 16 & 255) >= (bas >> 16 & 255), "pixel " + k);
            avant = Math.max(avant, place);
        }
        assertTrue(avant > 1, "des pixels demandent plus de quatre rayons");
    }

    @Test
    void laDifferenceEstHuitFoisLeplusGrandEcartAUneGrilleDeSoixanteQuatreRayons() {
        Lancer lancer = new Lancer(scene, camera);
        verifier(k -> {
            Couleur somme = new Couleur();
            for (int r = 0; r < 64; r++) {
                somme = somme.add(lancer.getCouleurPixel(k % L + (r % 8 + 0.5) / 8, k / L + (r / 8 + 0.5) / 8, 5));
            }
            Couleur juste = somme.div(64);
            Couleur vue = lancer.getCouleurPixel(k % L + 0.5, k / L + 0.5, 5);
            double pire = Math.max(ecart(vue.r, juste.r), Math.max(ecart(vue.v, juste.v), ecart(vue.b, juste.b)));
            return new Couleur(8 * pire);
        }, vue("difference"));
    }

    private static double ecart(double a, double b) {
        return Math.abs(Math.min(1, (float) a) - Math.min(1, (float) b));
    }

    @Test
    void uneSceneVideEstNoireDeToutesLesFacons() {
        Scene vide = new Scene(Collections.<Objet3D>emptyList(), Collections.singletonList(new Lampe(new Point(0, 5, 0), new Couleur(1))));
        for (String nom : new String[] {"normales", "distance", "lampes", "rayons"}) {
            assertArrayEquals(new int[] {0xFF000000}, Arrays.stream(vue(vide, nom)).distinct().toArray(), nom);
        }
    }
}
