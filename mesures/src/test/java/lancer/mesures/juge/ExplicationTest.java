package lancer.mesures.juge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.WritableRaster;
import java.util.Arrays;
import java.util.Collections;
import java.util.function.DoubleFunction;
import java.util.function.Predicate;
import lancer.Couleur;
import lancer.Lampe;
import lancer.Objet3D;
import lancer.Point;
import lancer.PointContact;
import lancer.Rayon;
import lancer.Scene;
import lancer.Vecteur;
import org.junit.jupiter.api.Test;

/** L'explication d'un écart. */
class ExplicationTest {

    /** Un pixel du milieu ; le rayon de son centre va presque tout droit. */
    private static final int I = 20;
    private static final int J = 15;
    private static final double X = I + 0.5;
    private static final double Y = J + 0.5;

    private static final Couleur GRIS = new Couleur(0.5);
    private static final Couleur NOIR = new Couleur();

    private static Rayon premier(Scene scene) {
        return ScenesJugees.lancer(scene).getCamera().getRayon(X, Y);
    }

    private static PointContact contact(Scene scene) {
        return scene.getClosestIntersection(premier(scene));
    }

    /** Le rayon que réfléchit le premier contact. */
    private static Rayon reflechi(Scene scene) {
        Vecteur V = premier(scene).getV();
        PointContact contact = contact(scene);
        Vecteur N = contact.objet.getNormale(contact);
        return new Rayon(contact, V.sub(N.mul(2 * V.dot(N))));
    }

    private static Couleur couleur(Scene scene, double dx) {
        return ScenesJugees.lancer(scene).getCouleurPixel(X + dx, Y, ScenesJugees.REFLETS);
    }

    /** L'explication de ce pixel, si le juge lui donne cette couleur. */
    private static Explication expliquer(Scene scene, Couleur juge) {
        float[] nous = ScenesJugees.couleurs(scene);
        WritableRaster lui = ScenesJugees.image(nous);
        for (Composante c : Composante.values()) {
            lui.setSample(I, J, c.ordinal(), (int) Math.round(65535 * Accord.limite(c.de(juge))));
        }
        Accord accord = new Accord(ScenesJugees.LARGEUR, ScenesJugees.HAUTEUR, nous, lui);
        int rang = J * ScenesJugees.LARGEUR + I;
        assertEquals(Collections.singletonList(rang), accord.auDela16);
        return new Explication(ScenesJugees.lancer(scene), ScenesJugees.REFLETS, accord, rang);
    }

    /** Le dernier nombre, de {@code bas} à {@code haut}, où cela est vrai de la scène. */
    private static double bord(DoubleFunction<Scene> scenes, double bas, double haut, Predicate<Scene> vrai) {
        assertTrue(vrai.test(scenes.apply(bas)));
        assertTrue(!vrai.test(scenes.apply(haut)));
        double a = bas;
        double b = haut;
        for (double m = (a + b) / 2; m != a && m != b; m = (a + b) / 2) {
            if (vrai.test(scenes.apply(m))) {
                a = m;
            } else {
                b = m;
            }
        }
        return a;
    }

    /** Le centre du pixel est sur le bord, à un arrondi près, et le juge voit l'autre côté. */
    private static void verifier(Cause cause, DoubleFunction<Scene> scenes, double bas, double haut, Predicate<Scene> vrai) {
        double a = bord(scenes, bas, haut, vrai);
        Scene nous = scenes.apply(a);
        Scene juge = scenes.apply(a + (haut - bas) * 1e-13);
        assertTrue(!vrai.test(juge));
        Explication explication = expliquer(nous, couleur(juge, 0));
        assertEquals(cause, explication.cause);
        assertTrue(explication.distance > 0 && explication.distance < 1e-9, "à " + explication.distance + " px");
    }

    @Test
    void unPixelSurUneSilhouetteSExpliqueParElle() {
        verifier(Cause.SILHOUETTE, r -> ScenesJugees.scene(ScenesJugees.boule(0.5, 0.25, 6, r, GRIS, NOIR)), 0.1, 0.9,
                s -> contact(s) == null);
    }

    @Test
    void unPixelAuBordDUneOmbreSExpliqueParElle() {
        verifier(Cause.OMBRE, r -> ScenesJugees.scene(ScenesJugees.boule(0, 0, 6, 1, GRIS, NOIR),
                ScenesJugees.boule(-1.25, 2.25, 2.5, r, GRIS, NOIR)), 0.01, 0.9,
                s -> !cachee(s, s.getLampes().get(0), contact(s), contact(s).objet));
    }

    @Test
    void unPixelDontLeRefletEstSurUneSilhouetteSExpliqueParElle() {
        verifier(Cause.SILHOUETTE_REFLETEE, r -> ScenesJugees.scene(ScenesJugees.boule(0, -0.5, 6, 1, NOIR, GRIS),
                ScenesJugees.boule(0.25, 4, 3, r, GRIS, NOIR)), 0.01, 1.5,
                s -> s.getClosestIntersection(reflechi(s), contact(s).objet) == null);
    }

    @Test
    void unPixelDontLeRefletEstAuBordDUneOmbreSExpliqueParElle() {
        Objet3D miroir = ScenesJugees.boule(0, -0.5, 6, 1, NOIR, GRIS);
        Objet3D vue = ScenesJugees.boule(0, 4, 3, 2, GRIS, NOIR);
        Lampe dessous = new Lampe(new Point(6, -1, 8), new Couleur(1));
        verifier(Cause.OMBRE_REFLETEE, r -> new Scene(Arrays.asList(miroir, vue, ScenesJugees.boule(3, 1.2, 5.9, r, GRIS, NOIR)),
                Collections.singletonList(dessous)), 0.05, 0.9,
                s -> {
                    PointContact vu = s.getClosestIntersection(reflechi(s), miroir);
                    return !cachee(s, s.getLampes().get(0), vu, vu.objet);
                });
    }

    @Test
    void unPixelDontLeRefletEstSurLHorizonSExpliqueParLui() {
        verifier(Cause.HORIZON, y -> ScenesJugees.scene(ScenesJugees.boule(0, y, 6, 1, NOIR, GRIS)), -0.5, 0.5,
                s -> reflechi(s).getV().y > 0);
    }

    @Test
    void unPixelOuLaCouleurVarieTresViteSExpliqueAinsi() {
        // une lampe un million de fois trop forte, et un contact presque hors de sa lumière
        Lampe lampe = new Lampe(new Point(100, 0, 6), new Couleur(1e6));
        DoubleFunction<Scene> scenes = x -> new Scene(Collections.singletonList(ScenesJugees.boule(x, 0, 6, 1, GRIS, NOIR)),
                Collections.singletonList(lampe));
        double x = bord(scenes, -0.5, 0.5,
                s -> contact(s).objet.getNormale(contact(s)).dot(new Vecteur(contact(s), lampe.getPosition())) > 0);
        Scene scene = scenes.apply(x - 3e-7);
        Explication explication = expliquer(scene, couleur(scene, 1e-7));
        assertEquals(Cause.PENTE, explication.cause);
        assertTrue(explication.distance > 5e-8 && explication.distance < 2e-7, "à " + explication.distance + " px");
    }

    @Test
    void uneCouleurQuAucunRayonVoisinNeVoitEstInexpliquee() {
        Scene scene = ScenesJugees.deuxBoules(GRIS);
        Explication explication = expliquer(scene, new Couleur(1, 0, 1));
        assertEquals(Cause.INEXPLIQUE, explication.cause);
        assertEquals(0, explication.distance);
        // deux niveaux de 16 bits suffisent
        Couleur presque = couleur(scene, 0).add(new Couleur(2.0 / 65535, 0, 0));
        assertEquals(Cause.INEXPLIQUE, expliquer(scene, presque).cause);
    }

    @Test
    void unRayonTropLoinNeProuveRien() {
        Scene scene = ScenesJugees.scene(ScenesJugees.boule(0.5, 0.25, 6, 0.5, GRIS, NOIR));
        double bord = 0;
        Couleur ici = couleur(scene, 0);
        while (Math.abs(couleur(scene, bord).r - ici.r) < 0.1) {
            bord += 0.01;
        }
        assertTrue(bord > 0.02);
        assertNotEquals(ici, couleur(scene, bord));
        assertEquals(Cause.INEXPLIQUE, expliquer(scene, couleur(scene, bord)).cause);
    }

    private static boolean cachee(Scene scene, Lampe lampe, PointContact contact, Objet3D objet) {
        Vecteur versLampe = new Vecteur(contact, lampe.getPosition());
        return scene.estCachee(lampe, contact, versLampe.normalized(), versLampe.norme(), objet);
    }
}
